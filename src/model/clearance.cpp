#include "model/clearance.hpp"

#include "base/error.hpp"
#include "base/index.hpp"
#include "base/words.hpp"
#include "model/thickness.hpp"

#include <Eigen/Geometry>

#include <algorithm>

namespace signorini::model {

namespace {

double size_of(const MatrixX& points) {
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

/// Whether x lies inside a plane body: its boundary, as a polygon, winds around x.
bool inside(const nurbs::Discretisation& space, const Vec<2>& x) {
  constexpr int pieces = 8; // per element: a chord's sagitta is below 1 % of an arc of 90°
  const MatrixX points = space.points();
  double angle = 0;
  for (const nurbs::Side side : {nurbs::Side{0, false}, {0, true}, {1, false}, {1, true}})
    for (int f = 0; f < space.elements_on(side); ++f) {
      const int e = space.element_behind(side, f), d = 1 - side.direction;
      const auto along = space.interval(e, d);
      const auto place = [&](int piece) -> Vec<2> {
        VectorX xi(2);
        xi(d) = along[0] + (along[1] - along[0]) * piece / pieces;
        xi(1 - d) = space.interval(e, 1 - d)[side.at_end ? 1 : 0];
        return space.basis(e, xi).combine(points) - x;
      };
      for (int piece = 0; piece < pieces; ++piece) {
        const Vec<2> a = place(piece), b = place(piece + 1);
        angle += nurbs::outward_sign(side) * std::atan2(a(0) * b(1) - a(1) * b(0), a.dot(b));
      }
    }
  return std::abs(angle) > 1; // 2π inside, 0 outside
}

/// Solid angle of a triangle seen from the origin (A. van Oosterom and J. Strackee, IEEE Trans. Biomed. Eng. 30, 1983).
double solid_angle(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c) {
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

/// Whether x lies inside a solid: its boundary, as triangles, fills the full solid angle around x.
bool inside(const nurbs::Discretisation& space, const Vec<3>& x) {
  constexpr int pieces = 4; // per element and direction
  const MatrixX points = space.points();
  double angle = 0;
  for (int e = 0; e < space.elements(); ++e)
    for (int d = 0, stride = 1; d < 3; stride *= space.elements(d), ++d)
      for (bool at_end : {false, true}) {
        if (e / stride % space.elements(d) != (at_end ? space.elements(d) - 1 : 0)) continue;
        const int u = (d + 1) % 3, v = (d + 2) % 3;
        const auto iu = space.interval(e, u), iv = space.interval(e, v);
        std::array<Vec<3>, (pieces + 1) * (pieces + 1)> grid;
        for (int j = 0; j <= pieces; ++j)
          for (int i = 0; i <= pieces; ++i) {
            VectorX xi(3);
            xi(d) = space.interval(e, d)[at_end ? 1 : 0];
            xi(u) = iu[0] + (iu[1] - iu[0]) * i / pieces;
            xi(v) = iv[0] + (iv[1] - iv[0]) * j / pieces;
            grid[at(i + (pieces + 1) * j)] = space.basis(e, xi).combine(points) - x;
          }
        for (int j = 0; j < pieces; ++j)
          for (int i = 0; i < pieces; ++i) {
            const std::size_t k = at(i + (pieces + 1) * j);
            const Vec<3>&a = grid[k], &b = grid[k + 1], &c = grid[k + pieces + 2], &f = grid[k + pieces + 1];
            angle += (at_end ? 1 : -1) * (solid_angle(a, b, c) + solid_angle(a, c, f));
          }
      }
  return std::abs(angle) > 1; // 4π inside, 0 outside
}

/// "12.5 %".
std::string percent(double part) {
  return text(std::round(1000 * part) / 10, " %");
}

constexpr double meant = 0.01;   // an overlap by more than this part of the thickness is worth a warning
constexpr double mistaken = 0.2; // and by more than this an error

/// Checks two bodies whose deepest contact point penetrates; returns a warning, or nothing.
template <int D>
std::string check_overlap(const Scene<D>& scene, const Contact<D>& contact, const FaceReference& master,
                          const contact::PointResult<D>& deepest) {
  const double depth = -deepest.gap, behind = thickness(scene, master);
  const double part = depth / std::min(thickness(scene, contact.slave), behind);
  if (part <= meant) return "";
  const std::string what =
      text("contacts.", contact.name, ": ", face_in_words(scene, contact.slave), " penetrates ",
           face_in_words(scene, master), " by ", number(depth), " before the first step, at ",
           coordinates(deepest.position), ", which is ", percent(part), " of the thickness of the thinner body");
  // Behind the whole of the master's body: its back is what the slave sees.
  constexpr double all = 0.9;
  const std::string other = nurbs::name_of({master.side.direction, !master.side.at_end});
  require(part <= mistaken, what, ", more than ", percent(mistaken), ". Hint: ",
          depth > all * behind ? text("the master may be the wrong face, with its normal pointing away from the slave; "
                                      "did you mean face '",
                                      other, "'?")
                               : "move the bodies apart; if they are in place, the slave or the master is the wrong "
                                 "face, or its normal is reversed");
  return text(what, ". Hint: the first step removes an overlap that is meant (an interference fit); otherwise move the "
                    "bodies apart, or check that both faces are the right ones and no normal is reversed");
}

} // namespace

template <int D>
std::vector<std::string> check_clearance(const Scene<D>& scene, const std::vector<contact::History<D>>& contacts) {
  constexpr double tolerated = 0.01;
  std::vector<std::string> warnings;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Contact<D>& contact = scene.contacts[k];
    const auto& results = contacts[k].results;
    const auto& deepest =
        *std::min_element(results.begin(), results.end(), [](const auto& a, const auto& b) { return a.gap < b.gap; });
    const NamedBody<D>& named = scene.bodies[at(contact.slave.body)];
    if (const auto* face = std::get_if<FaceReference>(&contact.master)) {
      const std::string warning = deepest.gap < 0 ? check_overlap(scene, contact, *face, deepest) : "";
      if (!warning.empty()) warnings.push_back(warning);
      continue;
    }
    const contact::Obstacle<D>& obstacle = scene.obstacles[at(std::get<ObstacleReference>(contact.master).obstacle)];
    // A thin body lies behind an obstacle before it is 1 % of its length deep.
    const double size = size_of(named.body->space().points());
    require(deepest.gap > -tolerated * size &&
                (deepest.gap >= 0 || deepest.gap > -mistaken * thickness(scene, contact.slave)),
            "contacts: the obstacle of '", contact.name, "' is inside body '", named.name,
            "' at the start: the face reaches ", -deepest.gap, " deep into it at ", coordinates(deepest.position),
            "; move the obstacle out, or turn its normal round",
            std::holds_alternative<nurbs::Patch>(obstacle) ? " by patch:reverse(1)" : "");
    // The face of a body that only touches a plane turned round has no gap that tells; the body's middle does.
    if (const auto* plane = std::get_if<contact::Plane<D>>(&obstacle)) {
      const Vec<D> middle = named.body->reference_point(named.body->elements() / 2, 0);
      require(plane->normal.dot(middle - plane->point) > 0, "contacts: the obstacle of '", contact.name,
              "' holds the middle of body '", named.name, "' at the start, ", coordinates(middle),
              "; turn the plane's normal round: it points out of the obstacle, towards the body");
    }
    if (const auto* ball = std::get_if<contact::Ball<D>>(&obstacle))
      require(!inside(named.body->space(), ball->centre), "contacts: the obstacle of '", contact.name,
              "' is inside body '", named.name, "' at the start: its centre ", coordinates(ball->centre),
              " lies in the body; move the obstacle out");
  }
  return warnings;
}

template std::vector<std::string> check_clearance<2>(const Scene<2>&, const std::vector<contact::History<2>>&);
template std::vector<std::string> check_clearance<3>(const Scene<3>&, const std::vector<contact::History<3>>&);

} // namespace signorini::model
