#pragma once
// Targets of the fuzzers: functions that read any bytes as a reader of the program does. Errors of the program are
// right answers; a crash, a hang, memory out of proportion to the input, or a broken promise (require_that) are not.

#include "base/error.hpp"

#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <span>
#include <string>
#include <string_view>

namespace signorini::fuzz {

struct Target {
  const char* name; ///< of its folder in tests/fuzz/corpus, too
  void (*run)(std::string_view input);
};

/// All targets of this program.
std::span<const Target> targets();

void geometry(std::string_view input);   ///< patches in files of other programs
void checkpoint(std::string_view input); ///< checkpoints; length and checksum are corrected
void archive(std::string_view input);    ///< one object of an archive; the first byte selects its type
void words(std::string_view input);      ///< order labels, regular expressions, answers of terminals
void data(std::string_view input);       ///< JSON and MessagePack

/// A changed copy of an input: bytes and numbers are replaced, parts copied, moved or removed. The same seed makes the
/// same change.
std::string mutated(std::string_view input, std::uint64_t seed);

/// A file in memory with these bytes, by its name; valid until the next call.
std::string file_of(std::string_view bytes);

/// Calls f(); returns whether it threw no Error.
template <class F> bool passes(const F& f) {
  try {
    f();
    return true;
  } catch (const Error&) {
    return false;
  }
}

/// Ends the program with a report, as a sanitizer does, if a promise is broken.
inline void require_that(bool kept, const char* promise) {
  if (kept) return;
  std::cerr << "broken promise: " << promise << std::endl;
  std::abort();
}

} // namespace signorini::fuzz
