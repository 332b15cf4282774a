#pragma once
// Parts of error messages: position in the user's script, Lua values as text, nearest words.

#include <lua.hpp>

#include "base/text.hpp"

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace signorini::bind {

/// A complete message, to which the name of the running function is not prepended.
class ArgumentError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Throws with the joined parts as message, to which the name of the running function is prepended.
template <class... Parts> [[noreturn]] void fail(const Parts&... parts) {
  throw std::runtime_error(text(parts...));
}
template <class... Parts> void require(bool ok, const Parts&... parts) {
  if (!ok) [[unlikely]]
    fail(parts...);
}

/// An argument in messages: its name, "E" or "points[3]", and its meaning ("Young's modulus"; may be empty).
struct Argument {
  std::string name;
  const char* meaning = "";
};

/// "script.lua:12: " of the innermost Lua frame outside the standard library; empty if there is none.
std::string user_position(lua_State* L);
/// Pushes the library's own `require`, core.require: scripts may replace the global one.
void push_require(lua_State* L);
/// Declares chunks below this folder as part of the standard library.
void set_library_folder(lua_State* L, const std::string& folder);
/// True if a stack frame (after lua_getinfo "S") runs a chunk of the standard library.
bool in_library(lua_State* L, const lua_Debug& frame);

/// The qualified name ("sg.nurbs.arc", "patch:insert") under which the running C function was registered.
const char* function_name(lua_State* L);

/// A value as text: "the string '1000'", "nan", "a list of 3 values", "a patch", "nothing".
std::string describe(lua_State* L, int index);

/// A message as a terminal can show it: control characters other than line breaks as \x1b, and without the middle part
/// of a message of more than a few thousand bytes, which quotes a long value.
std::string printable(const std::string& message);

/// "a body", "an obstacle".
std::string with_article(const std::string& noun);

/// The word of a list nearest by edit distance; empty if none is near.
std::string nearest(const std::string& word, const std::vector<std::string>& words);
/// "'a', 'b' or 'c'".
std::string one_of(const std::vector<std::string>& words);
/// "a, b, c" of the results of `shown` for the values.
template <class Values, class Shown>
std::string joined_by(const std::string& between, const Values& values, Shown shown) {
  std::string all;
  for (const auto& value : values) all += (all.empty() ? "" : between) + text(std::invoke(shown, value));
  return all;
}
/// "a, b, c".
template <class Values> std::string listed(const Values& values) {
  return joined_by(", ", values, std::identity());
}
/// "; did you mean 'order'?" or empty.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& words);

/// Throws: "sg.f: E must be <expected> (<meaning>), got <value>: <cure>", or that the argument is missing.
[[noreturn]] void reject(lua_State* L, int index, const Argument& argument, const std::string& expected,
                         const std::string& cure = "");

/// Pushes an error value as text: a table without __tostring by its contents, nil as an error without message.
void push_error_text(lua_State* L, int index);

} // namespace signorini::bind
