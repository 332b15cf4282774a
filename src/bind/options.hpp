#pragma once
// Named arguments: the one table that a function of the language takes.

#include "bind/stack.hpp"

#include <functional>
#include <limits>
#include <optional>

namespace signorini::bind {

/// Reads a table of named arguments. A key that is not in `known` is an error at once that lists the known ones.
///
///     Options o(L, 1, {"E", "nu"});
///     const double E = o.positive("E", "Young's modulus");
///     const double nu = o.number("nu", "Poisson's ratio", 0.3);   // with a default: may be left out
///
/// Readers without a default throw when the argument is missing. `meaning` says what the argument stands for.
class Options {
public:
  /// The table at `index`; `positional` allows a list part beside the names.
  /// `path` names a nested table in messages ("friction").
  Options(lua_State* L, int index, std::vector<std::string> known, bool positional = false, std::string path = "");

  bool has(const char* key) const;
  /// The name of this table in messages; empty for a function's own arguments.
  const std::string& path() const { return path_; }

  double number(const char* key, const char* meaning, std::optional<double> otherwise = {}) const;
  double positive(const char* key, const char* meaning, std::optional<double> otherwise = {}) const;
  double non_negative(const char* key, const char* meaning, std::optional<double> otherwise = {}) const;
  int integer(const char* key, const char* meaning, int low, int high = std::numeric_limits<int>::max(),
              std::optional<int> otherwise = {}) const;
  bool flag(const char* key, const char* meaning, std::optional<bool> otherwise = {}) const;
  std::string string(const char* key, const char* meaning, std::optional<std::string> otherwise = {}) const;
  std::string choice(const char* key, const char* meaning, const std::vector<std::string>& choices,
                     std::optional<std::string> otherwise = {}) const;
  std::vector<double> numbers(const char* key, const char* meaning,
                              std::optional<std::vector<double>> otherwise = {}) const;
  /// A point or vector with low … high coordinates.
  VectorX point(const char* key, const char* meaning, int low = 2, int high = 3,
                std::optional<VectorX> otherwise = {}) const;
  MatrixX points(const char* key, const char* meaning) const;

  /// The object of a registered type, by reference into its userdata.
  template <class T> T& object(const char* key, const char* meaning) const {
    return read_object<T>(L_, push_value(key), argument(key, meaning));
  }

  /// A nested table of named arguments.
  Options table(const char* key, std::vector<std::string> known) const;
  /// Calls `visit` for each entry of a table whose keys are names, sorted by name; `index` is the value's position on
  /// the stack, which is put back after each call. The argument names the entry in messages.
  void each(const char* key, const char* meaning,
            const std::function<void(const std::string& name, int index, const Argument& entry)>& visit) const;

  /// Pushes the raw value and returns its position on the stack (a nil when it is missing).
  int push_value(const char* key) const;
  /// How messages name an argument: "friction.mu".
  Argument argument(const char* key, const char* meaning = "") const;

private:
  template <class T, class Read>
  T read(const char* key, const char* meaning, const std::optional<T>& otherwise, Read reader) const;

  lua_State* L_;
  int index_;
  std::vector<std::string> known_;
  std::string path_;
};

} // namespace signorini::bind
