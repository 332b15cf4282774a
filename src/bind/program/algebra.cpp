// Small dense problems of linear algebra for the library in lua/. Matrices are lists of columns.

#include "base/box_least_squares.hpp"
#include "base/dense.hpp"
#include "bind/lua/arguments.hpp"
#include "bind/lua/functions.hpp"
#include "bind/lua/open.hpp"

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

/// core.box_least_squares(a, b, low, high), see base/box_least_squares.hpp.
VectorX box(const MatrixX& a, const VectorX& b, const VectorX& low, const VectorX& high) {
  require(a.size() > 0 && b.size() == a.rows() && low.size() == a.cols() && high.size() == a.cols(),
          "core.box_least_squares: sizes of the arguments do not fit");
  return box_least_squares(a, b, low, high);
}

} // namespace

void open_algebra(lua_State* L) {
  register_functions(L, "core", {{"singular_values", wrap<singular_values>}, {"box_least_squares", call<box>}});
}

} // namespace signorini::bind
