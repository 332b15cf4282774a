#pragma once
// Errors that a user can act on. Every check of input in the program goes through require().

#include <sstream>
#include <stdexcept>
#include <string>

namespace signorini {

/// A wrong input or a state the user must know of; the message names what came, what was expected and the cure.
class Error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// The parts streamed one behind the other; numbers with enough digits to recognise them.
template <class... Parts> std::string text(const Parts&... parts) {
  std::ostringstream out;
  out.precision(10);
  (out << ... << parts);
  return out.str();
}

template <class... Parts> [[noreturn]] void fail(const Parts&... parts) {
  throw Error(text(parts...));
}

/// Throws Error with the joined parts unless `ok`; the message is only built on failure.
template <class... Parts> void require(bool ok, const Parts&... parts) {
  if (!ok) [[unlikely]]
    fail(parts...);
}

} // namespace signorini
