#include "bind/scene/layer.hpp"

#include "base/words.hpp"
#include "bind/lua/functions.hpp"
#include "bind/scene/scene_builder.hpp"
#include "nurbs/constants.hpp"
#include "solid/quadrature.hpp"

#include <algorithm>

namespace signorini::bind {

namespace {

/// Per direction along a face, whether each element is in the layer.
using Strips = std::vector<std::vector<bool>>;

/// The directions of the patch along its contact faces, with the borders of their elements.
struct FaceElements {
  std::vector<int> directions;
  std::vector<std::vector<double>> breaks;

  FaceElements(const nurbs::Patch& patch, const nurbs::Plan& plan) {
    for (int d = 0; d < patch.parametric_dimension(); ++d)
      if (d != plan.contact.front().direction) {
        directions.push_back(d);
        breaks.push_back(nurbs::element_breaks(patch, plan, d));
      }
  }

  Strips none() const {
    Strips result;
    for (const auto& one : breaks) result.emplace_back(one.size() - 1, false);
    return result;
  }
};

/// The elements that a range of parameters overlaps by more than rounding error.
std::vector<bool> elements_in(const Arguments& a, const std::string& name, const std::array<double, 2>& range,
                              const std::vector<double>& breaks) {
  const double first = breaks.front(), last = breaks.back(), slack = nurbs::rounding * (last - first);
  if (!(range[0] >= first - slack && range[1] <= last + slack))
    a.fail(name, " must be in ", number(first), " … ", number(last), ", the parameters along the contact face, got {",
           number(range[0]), ", ", number(range[1]), "}");
  std::vector<bool> result;
  for (std::size_t e = 0; e + 1 < breaks.size(); ++e)
    result.push_back(range[0] < breaks[e + 1] - slack && range[1] > breaks[e] + slack);
  return result;
}

/// True if the user's function on top of the stack is true at a place.
bool is_true_at(const Arguments& a, const VectorX& place) {
  lua_State* L = a.state();
  lua_pushvalue(L, -1);
  push(L, place);
  lua_call(L, 1, 1);
  if (!lua_isboolean(L, -1))
    a.fail("layer must return true or false, got ", describe(L, -1), ": return a comparison, as in return X[1] <= 150");
  const bool result = lua_toboolean(L, -1) != 0;
  lua_pop(L, 1);
  return result;
}

/// The smallest strips with all elements of a face in which the user's function is true at a Gauss point, five per
/// direction.
Strips strips_where(const Arguments& a, const nurbs::Patch& patch, const FaceElements& along, nurbs::Side side) {
  constexpr int points = 5;
  const std::size_t count = along.directions.size();
  Strips result = along.none();
  VectorX xi(patch.parametric_dimension());
  const nurbs::KnotVector& across = patch.direction(side.direction);
  xi(side.direction) = side.at_end ? across.last() : across.first();
  VectorX low, high; // the box of the points that are asked
  bool any = false;
  std::array<std::size_t, 2> e{};
  const std::size_t second = count > 1 ? result[1].size() : 1;
  a.push("layer");
  for (e[1] = 0; e[1] < second; ++e[1])
    for (e[0] = 0; e[0] < result[0].size(); ++e[0]) {
      std::vector<solid::QuadratureRule> rules;
      for (std::size_t k = 0; k < count; ++k)
        rules.push_back(solid::gauss_legendre(points, along.breaks[k][e[k]], along.breaks[k][e[k] + 1]));
      const MatrixX inside = solid::tensor_product(rules).points;
      for (Eigen::Index q = 0; q < inside.cols(); ++q) {
        for (std::size_t k = 0; k < count; ++k) xi(along.directions[k]) = inside(static_cast<Eigen::Index>(k), q);
        const VectorX place = nurbs::evaluate(patch, xi);
        low = low.size() == 0 ? place : VectorX(low.cwiseMin(place));
        high = high.size() == 0 ? place : VectorX(high.cwiseMax(place));
        if (!is_true_at(a, place)) continue;
        for (std::size_t k = 0; k < count; ++k) result[k][e[k]] = true;
        any = true;
        break;
      }
    }
  lua_pop(a.state(), 1);
  if (!any)
    a.fail("layer must return true somewhere on contact face '", nurbs::name_of(side),
           "', got false at all Gauss points: X is the undeformed position, here between ", position_text(low), " and ",
           position_text(high));
  return result;
}

/// The layer's strips on each contact face; all elements without the argument.
std::vector<Strips> strips_of(const Arguments& a, const nurbs::Patch& patch, const nurbs::Plan& plan,
                              const FaceElements& along) {
  std::vector<Strips> result;
  if (!a.has("layer")) {
    Strips all = along.none();
    for (auto& one : all) one.assign(one.size(), true);
    return std::vector<Strips>(plan.contact.size(), all);
  }
  if (a.is("layer", LUA_TFUNCTION)) {
    for (const nurbs::Side& side : plan.contact) result.push_back(strips_where(a, patch, along, side));
    return result;
  }
  Strips strips;
  if (along.directions.size() == 1)
    strips.push_back(elements_in(a, "layer", a.get<std::array<double, 2>>("layer"), along.breaks.front()));
  else
    a.list("layer", [&](int i, int index, const std::string& path) {
      strips.push_back(elements_in(a, path, to<std::array<double, 2>>(a.state(), index), along.breaks[i]));
    });
  return std::vector<Strips>(plan.contact.size(), strips);
}

/// The borders of `parts` equal parts of the elements of direction k that are in the layer of any face.
std::vector<double> subdivided(const std::vector<Strips>& faces, const FaceElements& along, std::size_t k, int parts) {
  std::vector<double> result;
  const std::vector<double>& breaks = along.breaks[k];
  for (std::size_t e = 0; e + 1 < breaks.size(); ++e)
    if (std::any_of(faces.begin(), faces.end(), [&](const Strips& one) { return one[k][e]; }))
      for (int i = 1; i < parts; ++i) result.push_back(breaks[e] + (breaks[e + 1] - breaks[e]) * i / parts);
  return result;
}

/// One entry of layer_knots at a stack index: a number of parts, or the knots.
std::vector<double> knots_at(lua_State* L, int index, const std::vector<Strips>& faces, const FaceElements& along,
                             std::size_t k) {
  return lua_istable(L, index) ? to<std::vector<double>>(L, index) : subdivided(faces, along, k, to<int>(L, index));
}

} // namespace

void read_layer(const Arguments& a, const nurbs::Patch& patch, nurbs::Plan& plan) {
  const bool ranges = a.has("layer"), knots = a.has("layer_knots");
  if (!ranges && !knots) return;
  const bool layered =
      std::any_of(plan.labels.begin(), plan.labels.end(), [](const nurbs::Label& label) { return label.layer; });
  if (ranges && !layered && !knots)
    a.fail("layer is where the degree is raised, but order '", plan.labels.front().text,
           "' has no layer: give a label with one, such as N2-N2.2, or layer_knots");
  const FaceElements along(patch, plan);
  const std::vector<Strips> faces = strips_of(a, patch, plan, along);
  if (ranges && layered) plan.raised = faces;
  if (!knots) return;
  lua_State* L = a.state();
  const int index = a.push("layer_knots");
  const bool per_direction = along.directions.size() > 1 && lua_istable(L, index);
  for (std::size_t k = 0; k < along.directions.size(); ++k) {
    if (per_direction) lua_rawgeti(L, index, static_cast<lua_Integer>(k) + 1);
    plan.layer_knots.push_back(knots_at(L, per_direction ? lua_gettop(L) : index, faces, along, k));
  }
  lua_settop(L, index - 1);
}

} // namespace signorini::bind
