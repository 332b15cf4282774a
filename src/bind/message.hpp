#pragma once
// What error messages are made of: where the user's script stands, what a Lua value looks like, which word was meant.

#include <lua.hpp>

#include "base/text.hpp"

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace signorini::bind {

/// A complete message: the name of the function that is running is not put before it.
class ArgumentError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Throws with the joined parts as the message, before which the name of the running function is put.
template <class... Parts> [[noreturn]] void fail(const Parts&... parts) {
  throw std::runtime_error(text(parts...));
}
template <class... Parts> void require(bool ok, const Parts&... parts) {
  if (!ok) [[unlikely]]
    fail(parts...);
}

/// An argument as messages name it: "E", "points[3]", and what it stands for ("Young's modulus"; may be empty).
struct Argument {
  std::string name;
  const char* meaning = "";
};

/// "script.lua:12: " of the innermost Lua frame that is not part of the standard library; empty when there is none.
std::string user_position(lua_State* L);
/// Declares that chunks below this folder belong to the standard library.
void set_library_folder(lua_State* L, const std::string& folder);
/// Whether a stack frame (lua_getinfo "S" done) runs a chunk of the standard library.
bool in_library(lua_State* L, const lua_Debug& frame);

/// The qualified name ("sg.nurbs.arc", "patch:insert") under which the running C function was registered.
const char* function_name(lua_State* L);

/// A value as a user would recognize it: "the string '1000'", "nan", "a list of 3 values", "a patch", "nothing".
std::string describe(lua_State* L, int index);

/// "a body", "an obstacle".
std::string with_article(const std::string& noun);

/// The word of a list that is nearest to the given one by edit distance; empty when none is near.
std::string nearest(const std::string& word, const std::vector<std::string>& words);
/// "'a', 'b' or 'c'".
std::string one_of(const std::vector<std::string>& words);
/// "a, b, c" of what `shown` makes of the values.
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
/// "; did you mean 'order'?" or nothing.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& words);

/// Throws: "sg.f: E must be <expected> (<meaning>), got <value>: <cure>", or that the argument is
/// missing.
[[noreturn]] void reject(lua_State* L, int index, const Argument& argument, const std::string& expected,
                         const std::string& cure = "");

/// Pushes an error value as text: a table that has no text of its own as what it holds, nil as an error without
/// message.
void push_error_text(lua_State* L, int index);

} // namespace signorini::bind
