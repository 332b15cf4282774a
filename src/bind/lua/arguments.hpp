#pragma once
// Arguments of a call after their check (lua/signorini/call/check.lua), with the types of the function's table and with
// defaults for missing ones. Reading converts without further checks.

#include "bind/lua/stack.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <type_traits>

namespace signorini::bind {

/// Converts a checked value: double, int, bool, std::string, VectorX (a point), MatrixX (points in columns), two
/// numbers (an interval), or a vector of numbers, integers or strings; gaps in numbers are nan.
template <class T> T to(lua_State* L, int index);
template <> double to(lua_State* L, int index);
template <> int to(lua_State* L, int index);
template <> bool to(lua_State* L, int index);
template <> std::string to(lua_State* L, int index);
template <> std::string_view to(lua_State* L, int index); ///< as long as the value is on the stack
template <> std::vector<double> to(lua_State* L, int index);
template <> std::vector<int> to(lua_State* L, int index);
template <> std::vector<std::string> to(lua_State* L, int index);
template <> std::array<double, 2> to(lua_State* L, int index);
template <> std::array<int, 2> to(lua_State* L, int index);
template <> VectorX to(lua_State* L, int index);
template <> MatrixX to(lua_State* L, int index);

/// A table of named arguments.
///
///     const Arguments a(L);
///     const double radius = a.get<double>("radius");
class Arguments {
public:
  /// The table at `index`: 1, of methods 2. `path`: name of a nested table in messages ("friction").
  explicit Arguments(lua_State* L, int index = 1, std::string path = "");

  /// True if there is a value, given or default.
  bool has(const char* key) const;
  template <class T> T get(const char* key) const {
    T value = to<T>(L_, push(key));
    lua_pop(L_, 1);
    return value;
  }
  /// Reads the values that are present into variables: alternating names and variables.
  ///
  ///     a.read("title", options.title, "range", options.range);
  template <class T, class... Rest> void read(const char* key, T& place, Rest&&... rest) const {
    if (has(key)) place = get<typename Plain<T>::type>(key);
    if constexpr (sizeof...(rest) > 0) read(std::forward<Rest>(rest)...);
  }
  template <class T> T get(const char* key, T otherwise) const { return has(key) ? get<T>(key) : otherwise; }
  /// True if there is a value of this type of Lua, such as LUA_TSTRING.
  bool is(const char* key, int type) const;
  /// The object of a registered type, as a reference into its userdata.
  template <class T> T& object(const char* key) const {
    T& found = read_object<T>(L_, push(key), {name(key)});
    lua_pop(L_, 1);
    return found;
  }
  /// A nested table of named arguments, which stays on the stack.
  Arguments table(const char* key) const;
  /// Calls `visit` for each entry of a table with names as keys, sorted by name; `index`: stack index of the value,
  /// `path`: its name in messages.
  void each(const char* key,
            const std::function<void(const std::string& name, int index, const std::string& path)>& visit) const;
  /// Calls `visit` for each entry of a list, counted from 0.
  void list(const char* key, const std::function<void(int i, int index, const std::string& path)>& visit) const;

  /// Pushes the raw value (nil if it is missing) and returns its stack index.
  int push(const char* key) const;
  /// The name of an argument in messages: "friction.mu".
  std::string name(const char* key) const;
  const std::string& path() const { return path_; }
  lua_State* state() const { return L_; }
  int index() const { return index_; }

  /// Throws for errors that the function's table cannot express: "sg.f: E must be <expected>, got <value>: <cure>".
  [[noreturn]] void refuse(const char* key, const std::string& expected, const std::string& cure = "") const;
  /// Throws with the joined parts as message, after the path.
  template <class... Parts> [[noreturn]] void fail(const Parts&... parts) const {
    bind::fail(path_.empty() ? "" : path_ + ": ", parts...);
  }

private:
  template <class T> struct Plain { using type = T; };
  template <class T> struct Plain<std::optional<T>> { using type = T; };

  lua_State* L_;
  int index_;
  std::string path_;
};

/// The value of a choice, by its name among the names of all values in their order.
template <class Enum> Enum choice(const std::string& name, std::initializer_list<const char*> names) {
  const auto found = std::find(names.begin(), names.end(), name);
  require(found != names.end(), "unknown choice '", name, "'");
  return static_cast<Enum>(found - names.begin());
}

// ── C++ functions as Lua calls them ──────────────────────────────────────────────────────────────────────────────────

/// An argument of a C++ function at a stack index: an object by reference, also if a shared pointer holds it, a table
/// of named arguments, the stack itself, or a value.
template <class T> decltype(auto) argument(lua_State* L, int index) {
  using Plain = std::remove_cvref_t<T>;
  if constexpr (std::is_same_v<Plain, lua_State*>)
    return Plain(L);
  else if constexpr (std::is_same_v<Plain, Arguments>)
    return Arguments(L, index);
  else if constexpr (Registered<Plain>)
    return read_object<Plain>(L, index);
  else if constexpr (Registered<std::shared_ptr<Plain>>)
    return *read_object<std::shared_ptr<Plain>>(L, index);
  else if constexpr (Registered<std::shared_ptr<const Plain>>)
    return *read_object<std::shared_ptr<const Plain>>(L, index);
  else
    return to<Plain>(L, index);
}

template <class Result, class... Parts> int call_plain(lua_State* L, Result (*function)(Parts...)) {
  const auto called = [&]<std::size_t... I>(std::index_sequence<I...>)->Result {
    return function(argument<Parts>(L, static_cast<int>(I) + 1)...);
  };
  if constexpr (std::is_void_v<Result>) {
    called(std::index_sequence_for<Parts...>());
    return 0;
  } else if constexpr ((std::is_same_v<Parts, lua_State*> || ...)) {
    return called(std::index_sequence_for<Parts...>());
  } else {
    push(L, called(std::index_sequence_for<Parts...>()));
    return 1;
  }
}

/// Wraps a C++ function for Lua: its parameters are the arguments in order, for methods preceded by the object; its
/// result is pushed. If its last parameter is the stack, it pushes results itself and returns their number.
///
///     {"translate", call<nurbs::translate>},
template <auto function> int call(lua_State* L) {
  return call_plain(L, +function);
}

/// The name of an argument as a template parameter.
template <std::size_t N> struct Name {
  char letters[N];

  constexpr Name(const char (&name)[N]) { std::copy_n(name, N, letters); }
};

/// A named argument: an object by reference, or a value.
template <class T> decltype(auto) named(const Arguments& a, const char* name) {
  if constexpr (Registered<T>)
    return a.object<T>(name);
  else
    return a.get<T>(name);
}

/// The result of a C++ function for the arguments of these names.
template <class Result, class... Parts, class... Names>
Result result_of(Result (*function)(Parts...), const Arguments& a, const Names&... names) {
  return function(named<std::remove_cvref_t<Parts>>(a, names.letters)...);
}

/// Pushes this result.
///
///     {"line", made<nurbs::line, "from", "to">},
template <auto function, Name... names> int made(lua_State* L) {
  push(L, result_of(+function, Arguments(L), names...));
  return 1;
}

} // namespace signorini::bind
