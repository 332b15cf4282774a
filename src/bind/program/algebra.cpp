// Small dense problems of linear algebra for the library in lua/. Matrices are lists of columns.

#include "base/box_least_squares.hpp"
#include "base/dense.hpp"
#include "bind/lua/arguments.hpp"
#include "bind/lua/functions.hpp"
#include "bind/lua/open.hpp"

#include <cmath>
#include <limits>

namespace signorini::bind {

namespace {

/// core.singular_values(a): a table { u, values, v }, see base/dense.hpp.
int singular_values(lua_State* L) {
  const MatrixX a = to<MatrixX>(L, 1);
  require(a.size() > 0, "core.singular_values: the matrix is empty");
  const dense::SingularValues found = dense::singular_values(a);
  push_fields(L, "u", found.u, "values", found.values, "v", found.v);
  return 1;
}

/// Numbers that are not finite in Lua, which are nan here, are no limits.
VectorX limits(const VectorX& values, double none) {
  return values.unaryExpr([none](double value) { return std::isnan(value) ? none : value; });
}

/// core.box_least_squares(a, b, low, high), see base/box_least_squares.hpp.
VectorX box(const MatrixX& a, const VectorX& b, const VectorX& low, const VectorX& high) {
  require(a.size() > 0 && b.size() == a.rows() && low.size() == a.cols() && high.size() == a.cols(),
          "core.box_least_squares: sizes of the arguments do not fit");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return box_least_squares(a, b, limits(low, -infinity), limits(high, infinity));
}

} // namespace

void open_algebra(lua_State* L) {
  register_functions(L, "core", {{"singular_values", wrap<singular_values>}, {"box_least_squares", call<box>}});
}

} // namespace signorini::bind
