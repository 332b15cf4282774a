#include "model/warnings/undeclared_obstacle.hpp"

#include "model/checks/constants.hpp"

#include <algorithm>
#include <optional>
#include <set>

namespace signorini::model {

namespace {

/// An obstacle at present and at the start.
template <int D> struct PlacedObstacle {
  int number;
  const Contact<D>& contact; ///< the first one with it
  const contact::Master<D>&now, start;
  double radius; ///< of a full ball, cylinder or torus; otherwise 0
};

/// True if a face is the slave of a contact with an obstacle.
template <int D> bool declares(const Scene<D>& scene, const FaceReference& face, int obstacle) {
  return std::any_of(scene.contacts.begin(), scene.contacts.end(), [&](const Contact<D>& contact) {
    const auto* master = std::get_if<ObstacleReference>(&contact.master);
    return master && master->obstacle == obstacle && contact.slave.contains(face);
  });
}

/// How deep a place lies behind an obstacle; nothing if its closest point is not between the ends.
template <int D> std::optional<double> depth_behind(const contact::Master<D>& master, const Vec<D>& x) {
  contact::FaceGeometry<D> foot;
  contact::FaceCoordinates<D> rate;
  const contact::Projection<D> found = master.project(x, {}, foot);
  if (found.foot == contact::Foot::none || master.fade(found.xi, rate) < 1) return {};
  return -found.gap;
}

/// True if a border of a facet passes through a curve or surface, not around its end.
template <int D> bool crosses(const contact::Master<D>& master, const Facet<D>& facet) {
  for (std::size_t i = 0; i < (D == 2 ? 1 : D); ++i) {
    const Vec<D>&a = facet.corners[i], &b = facet.corners[(i + 1) % D];
    const auto from = depth_behind(master, a), to = depth_behind(master, b);
    if (!from || !to || (*from > 0) == (*to > 0)) continue;
    const auto between = depth_behind<D>(master, a + *from / (*from - *to) * (b - a));
    if (between && std::abs(*between) < crossing_distance * (b - a).norm()) return true;
  }
  return false;
}

/// By side of a body: true if it crosses a curve or surface.
template <int D> Sides<D> crossing_sides(const contact::Master<D>& master, const Outline<D>& outline) {
  const contact::Surface<D>& surface = *master.surface();
  Vec<D> low, high;
  bounds(surface.bezier(0), low, high);
  for (int e = 1; e < surface.elements(); ++e) {
    Vec<D> lower, upper;
    bounds(surface.bezier(e), lower, upper);
    low = low.cwiseMin(lower);
    high = high.cwiseMax(upper);
  }
  Sides<D> crossing;
  for (const Facet<D>& facet : outline.facets()) {
    bool& found = crossing[number_of(facet.side)];
    const Vec<D> beyond = (low - facet.middle).cwiseMax(facet.middle - high).cwiseMax(0.0);
    if (!found && beyond.norm() <= facet.radius) found = crosses(master, facet);
  }
  return crossing;
}

/// The outlines of bodies before the first step, made when they are needed first.
template <int D> class StartOutlines {
public:
  explicit StartOutlines(const Scene<D>& scene) : scene_(scene), outlines_(scene.bodies.size()) {}
  const Outline<D>& operator[](int body) {
    auto& outline = outlines_[body];
    const nurbs::Discretization& space = scene_.bodies[body].body->space();
    return outline ? *outline : outline.emplace(space, space.points());
  }

private:
  const Scene<D>& scene_;
  std::vector<std::optional<Outline<D>>> outlines_;
};

/// A place of a body behind an obstacle, or of an obstacle in a body.
template <int D> struct Penetrating {
  double depth = 0;
  nurbs::Side side{};
  Vec<D> position = Vec<D>::Zero();
};

/// The deepest place of a body's faces that are not slaves of contacts with the obstacle.
template <int D>
Penetrating<D> deepest_behind(const PresentOutlines<D>& outlines, int body, const PlacedObstacle<D>& obstacle,
                              StartOutlines<D>& start) {
  const std::vector<Facet<D>>& facets = outlines[body].facets();
  Sides<D> examined(true);
  if (obstacle.now.surface()) examined = crossing_sides(obstacle.now, outlines[body]);
  for (const nurbs::Side side : nurbs::sides(D))
    if (outlines.within(body, side) || declares(outlines.scene(), {body, side}, obstacle.number))
      examined[number_of(side)] = false;
  Penetrating<D> deepest;
  for (std::size_t i = 0; i < facets.size(); i += Outline<D>::stride) {
    const Facet<D>& facet = facets[i];
    if (!examined[number_of(facet.side)]) continue;
    const double allowed = outlines.allowed(body, facet);
    if (depth_behind(obstacle.now, facet.middle).value_or(0) <= std::max(allowed, deepest.depth) ||
        depth_behind(obstacle.start, start[body].facets()[i].middle).value_or(0) > allowed)
      continue;
    for (const Vec<D>& corner : facet.corners)
      if (const double depth = depth_behind(obstacle.now, corner).value_or(0); depth > deepest.depth)
        deepest = {depth, facet.side, corner};
  }
  return deepest;
}

/// The deepest corner of faces that are slaves of contacts with an obstacle, of a body and those joined with it.
template <int D>
double declared_behind(const PresentOutlines<D>& outlines, int body, const PlacedObstacle<D>& obstacle) {
  double depth = 0;
  for (int b = 0; b < outlines.bodies(); ++b)
    for (const Facet<D>& facet : outlines[b].facets()) {
      if (!outlines.joined(b, body) || !declares(outlines.scene(), {b, facet.side}, obstacle.number)) continue;
      for (const Vec<D>& corner : facet.corners)
        depth = std::max(depth, depth_behind(obstacle.now, corner).value_or(0));
    }
  return depth;
}

/// Places of an obstacle that should not be in a body. Always its middle: of a ball its center, of a cylinder or torus
/// the points of its axis or circle closest to the body. `all`: points of its surface, too.
template <int D>
std::vector<Vec<D>> places_of(const contact::Master<D>& master, double radius, const Outline<D>& outline, bool all) {
  std::vector<Vec<D>> places;
  if (const contact::Surface<D>* surface = all ? master.surface() : nullptr) {
    std::vector<double> grid;
    for (int e = 0; e < surface->elements(); ++e) {
      std::size_t count = 1;
      for (int alpha = 0; alpha < D - 1; ++alpha) count *= 3 * (surface->degree(e, alpha) + 1);
      grid.resize(D * count);
      sample(surface->bezier(e), grid.data());
      for (std::size_t k = 0; k < count; ++k) {
        Vec<D>& place = places.emplace_back();
        for (int i = 0; i < D; ++i) place(i) = grid[i * count + k];
      }
    }
  }
  if (master.surface() || (radius == 0 && !all)) return places;
  for (std::size_t i = 0; i < outline.facets().size(); i += Outline<D>::stride) {
    contact::FaceGeometry<D> foot;
    master.project(outline.facets()[i].middle, {}, foot);
    if (all) places.push_back(foot.position);
    if (radius > 0) places.push_back(foot.position - radius * master.normal(foot));
  }
  return places;
}

/// The deepest place of an obstacle in a body in which it was not at the start.
template <int D>
Penetrating<D> deepest_inside(const PresentOutlines<D>& outlines, int body, const PlacedObstacle<D>& obstacle,
                              StartOutlines<D>& start, bool all) {
  const Outline<D>& outline = outlines[body];
  const std::vector<Vec<D>> places = places_of(obstacle.now, obstacle.radius, outline, all);
  std::optional<std::vector<Vec<D>>> before;
  Penetrating<D> deepest;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vec<D>& place = places[i];
    if (!outline.boxes(place) || outline.layers(place) < 1 || outline.winding(place) < 0.5) continue;
    const auto nearest =
        outline.nearest(place, [&](const Facet<D>& facet) { return !outlines.within(body, facet.side); });
    if (!nearest.facet || nearest.distance <= std::max(deepest.depth, outlines.allowed(body, *nearest.facet))) continue;
    if (!before) before = places_of(obstacle.start, obstacle.radius, start[body], all);
    if (start[body].winding((*before)[i]) < 0.5) deepest = {nearest.distance, nearest.facet->side, place};
  }
  return deepest;
}

template <int D>
void warn_of(const Model<D>& model, const PresentOutlines<D>& outlines, int body, const PlacedObstacle<D>& obstacle,
             StartOutlines<D>& start, std::vector<Message>& warnings) {
  const Scene<D>& scene = model.system.scene;
  if (const Penetrating<D> found = deepest_behind(outlines, body, obstacle, start);
      found.depth > 0 && found.depth > declared_behind(outlines, body, obstacle)) {
    warnings.push_back(Message("model.warning.behind_obstacle", {{"contact", obstacle.contact.name},
                                                                 {"face", face_message(scene, {body, found.side})},
                                                                 {"depth", found.depth},
                                                                 {"at", found.position}}));
    return;
  }
  const DeclaredContacts declared = declared_contacts(model, [&](const Contact<D>& contact) {
    const auto* master = std::get_if<ObstacleReference>(&contact.master);
    return master && master->obstacle == obstacle.number && contact.slave.on(body);
  });
  const bool any = !declared.first.empty();
  if (any && !declared.everywhere) return;
  if (const Penetrating<D> found = deepest_inside(outlines, body, obstacle, start, declared.active == 0);
      found.depth > 0)
    warnings.push_back(Message("model.warning.obstacle_inside",
                               {{"contact", obstacle.contact.name},
                                {"body", scene.bodies[body].name},
                                {"face", face_message(scene, {body, found.side})},
                                {"depth", found.depth},
                                {"at", found.position},
                                {"hint", Message(any ? "model.overlap.between" : "model.overlap.define")}}));
}

} // namespace

template <int D>
void warn_of_obstacles(const Model<D>& model, const PresentOutlines<D>& outlines, std::vector<Message>& warnings) {
  const Scene<D>& scene = model.system.scene;
  StartOutlines<D> start(scene);
  std::set<int> examined;
  for (std::size_t k = 0; k < scene.contacts.size(); ++k) {
    const auto* master = std::get_if<ObstacleReference>(&scene.contacts[k].master);
    if (!master || !examined.insert(master->obstacle).second) continue;
    const contact::Obstacle<D>& shape = scene.obstacles[master->obstacle];
    const PlacedObstacle<D> obstacle{master->obstacle, scene.contacts[k], model.system.contacts[k]->master(),
                                     contact::Master<D>(shape), full_radius<D>(shape)};
    for (int b = 0; b < outlines.bodies(); ++b) warn_of(model, outlines, b, obstacle, start, warnings);
  }
}

template void warn_of_obstacles<2>(const Model<2>&, const PresentOutlines<2>&, std::vector<Message>&);
template void warn_of_obstacles<3>(const Model<3>&, const PresentOutlines<3>&, std::vector<Message>&);

} // namespace signorini::model
