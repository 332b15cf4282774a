#include "model/symmetry.hpp"

#include "base/index.hpp"
#include "model/changed_space.hpp"
#include "model/cost.hpp"

#include <numeric>
#include <set>

namespace signorini::model {

namespace {

using nurbs::Side;
using nurbs::Space1D;

/// A mirror under trial.
struct MirrorPlane {
  int axis;
  double place, length; ///< length: what differences of coordinates are measured against
};

bool same_both_ways(const Space1D& space) {
  const std::vector<double>& breaks = space.breaks();
  const double sum = space.first() + space.last(), limit = symmetry_tolerance * (space.last() - space.first());
  const int last = space.elements() - 1;
  for (int e = 0; e <= last; ++e)
    if (std::abs(breaks[at(e)] + breaks[at(last + 1 - e)] - sum) > limit || space.degree(e) != space.degree(last - e) ||
        space.smoothness()[at(e)] != space.smoothness()[at(last + 1 - e)])
      return false;
  return true;
}

/// Whether column i of weighted points is the mirror image of column partner(i), for all.
bool mirrors(const MatrixX& homogeneous, const MirrorPlane& plane, const std::vector<int>& partner) {
  const Eigen::Index last = homogeneous.rows() - 1;
  for (Eigen::Index i = 0; i < homogeneous.cols(); ++i) {
    VectorX image = homogeneous.col(partner[static_cast<std::size_t>(i)]);
    image(plane.axis) = 2 * plane.place * image(last) - image(plane.axis);
    const VectorX difference = (image - homogeneous.col(i)).cwiseAbs();
    if (difference.head(last).maxCoeff() > symmetry_tolerance * plane.length || difference(last) > symmetry_tolerance)
      return false;
  }
  return true;
}

/// The partner of every function of a row when direction d is turned round.
std::vector<int> turned_round(const nurbs::Row& patch, int d) {
  int stride = 1;
  for (int e = 0; e < d; ++e) stride *= patch.direction(e).functions();
  const int count = patch.direction(d).functions();
  std::vector<int> partner(at(patch.functions()));
  for (int f = 0; f < patch.functions(); ++f) {
    const int i = f / stride % count;
    partner[at(f)] = f + (count - 1 - 2 * i) * stride;
  }
  return partner;
}

/// The partner of every function of a body when direction d is turned round; nothing where its knots do not allow it.
std::optional<std::vector<int>> turned_round(const nurbs::Discretisation& space, int d) {
  const int rows = static_cast<int>(space.rows().size());
  std::vector<int> partner;
  if (d == space.through()) {
    if (!same_both_ways(space.stack())) return std::nullopt;
    for (int j = 0; j < rows; ++j) {
      const auto &row = space.rows()[at(j)], &other = space.rows()[at(rows - 1 - j)];
      if (row.directions() != other.directions()) return std::nullopt;
      for (int i = 0; i < row.functions(); ++i) partner.push_back(space.first_function(rows - 1 - j) + i);
    }
    return partner;
  }
  const int along = space.in_row(d);
  for (int j = 0; j < rows; ++j) {
    const nurbs::Row& row = space.rows()[at(j)];
    if (!same_both_ways(row.direction(along))) return std::nullopt;
    for (int f : turned_round(row, along)) partner.push_back(space.first_function(j) + f);
  }
  return partner;
}

/// What turning a parametric direction round does to a body.
struct Turn {
  int direction;
  std::vector<int> partner; ///< of every function
};

std::optional<Turn> find_turn(const nurbs::Discretisation& space, const MirrorPlane& plane) {
  for (int d = 0; d < space.parametric_dimension(); ++d)
    if (auto partner = turned_round(space, d); partner && mirrors(space.homogeneous(), plane, *partner))
      return Turn{d, std::move(*partner)};
  return std::nullopt;
}

/// Whether an obstacle is its own mirror image.
struct Symmetric {
  const MirrorPlane& plane;

  bool close(double a, double b) const { return std::abs(a - b) <= symmetry_tolerance * plane.length; }
  template <int D> bool operator()(const contact::Plane<D>& flat) const {
    return std::abs(flat.normal(plane.axis)) <= symmetry_tolerance;
  }
  template <int D> bool operator()(const contact::Ball<D>& ball) const {
    return close(ball.centre(plane.axis), plane.place);
  }
  bool operator()(const contact::Cylinder& cylinder) const {
    const double along = std::abs(cylinder.axis(plane.axis));
    return along >= 1 - symmetry_tolerance ||
           (along <= symmetry_tolerance && close(cylinder.point(plane.axis), plane.place));
  }
  bool operator()(const nurbs::Patch& patch) const {
    const nurbs::Row row = nurbs::make_row(patch);
    for (int d = 0; d < row.parametric_dimension(); ++d)
      if (same_both_ways(row.direction(d)) && mirrors(row.homogeneous(), plane, turned_round(row, d))) return true;
    return false;
  }
};

/// Which of a support's targets moves it along an axis; −1: none.
template <int D> int driven_component(const Support<D>& support, int axis) {
  if (support.hold[at(axis)] != Hold::driven) return -1;
  return static_cast<int>(std::count(support.hold.begin(), support.hold.begin() + axis, Hold::driven));
}

/// The supports that drive along the normal, which must stay; nothing where supports break the symmetry anyway.
template <int D>
std::optional<std::vector<int>> supports_fit(const Model<D>& model, const MirrorPlane& plane,
                                             const std::vector<Turn>& turns) {
  using Functions = std::set<std::pair<int, int>>; // body, function
  const auto maps = [&](const Functions& functions) {
    return std::all_of(functions.begin(), functions.end(), [&](const auto& entry) {
      return functions.contains({entry.first, turns[at(entry.first)].partner[at(entry.second)]});
    });
  };
  const Scene<D>& scene = model.system.scene;
  std::vector<int> driven;
  std::array<Functions, D> fixed; // by component: of all supports together
  for (int s = 0; s < static_cast<int>(scene.supports.size()); ++s) {
    const Support<D>& support = scene.supports[at(s)];
    const int along = driven_component(support, plane.axis);
    if (support.rotates || accepted_value(model, s, -1, along) != 0) return std::nullopt;
    if (along >= 0) driven.push_back(s);
    Functions own;
    for (const Held& held : support.on)
      for (int function : held.functions) own.emplace(held.body, function);
    for (std::size_t c = 0; c < D; ++c) {
      if (support.hold[c] == Hold::driven && !maps(own)) return std::nullopt;
      if (support.hold[c] == Hold::fixed) fixed[c].insert(own.begin(), own.end());
    }
  }
  if (!std::all_of(fixed.begin(), fixed.end(), maps)) return std::nullopt;
  return driven;
}

template <int D> bool loads_fit(const Model<D>& model, const MirrorPlane& plane, const std::vector<Turn>& turns) {
  const auto& loads = model.system.scene.loads;
  for (int l = 0; l < static_cast<int>(loads.size()); ++l) {
    const Load& load = loads[at(l)];
    if (!load.pressure && accepted_value(model, -1, l, plane.axis) != 0) return false;
    for (FaceReference face : load.on) {
      if (face.side.direction == turns[at(face.body)].direction) face.side.at_end = !face.side.at_end;
      if (std::find(load.on.begin(), load.on.end(), face) == load.on.end()) return false;
    }
  }
  return true;
}

/// Whether the points that a region leaves to a contact map onto each other.
template <int D>
bool region_fits(const contact::Formulation<D>& formulation, const Contact<D>& contact, int direction) {
  const std::size_t alpha =
      direction < contact.slave.side.direction ? at(direction) : static_cast<std::size_t>(direction - 1);
  const contact::Surface<D>& slave = formulation.slave();
  const auto turned = [&](int number, int first, int count) { // numbers run fastest along the first direction
    if (D == 2) return count - 1 - number;
    const int i = number % first, j = number / first;
    return alpha == 0 ? count - 1 - i + first * j : i + first * (count - 1 - j);
  };
  std::set<std::pair<int, int>> points;
  for (const contact::ContactPoint& point : formulation.points().list) points.insert({point.element, point.number});
  const int elements = slave.direction(static_cast<int>(alpha)).elements();
  return std::all_of(points.begin(), points.end(), [&](const auto& point) {
    return points.contains({turned(point.first, slave.direction(0).elements(), elements),
                            turned(point.second, contact.points, contact.points)});
  });
}

template <int D> bool contacts_fit(const Model<D>& model, const MirrorPlane& plane, const std::vector<Turn>& turns) {
  const Scene<D>& scene = model.system.scene;
  for (std::size_t k = 0; k < scene.contacts.size(); ++k) {
    const Contact<D>& contact = scene.contacts[k];
    const auto turns_over = [&](const FaceReference& face) {
      return face.side.direction == turns[at(face.body)].direction;
    };
    if (turns_over(contact.slave)) return false;
    if (const auto* master = std::get_if<FaceReference>(&contact.master)) {
      if (turns_over(*master)) return false;
    } else {
      const int obstacle = std::get<ObstacleReference>(contact.master).obstacle;
      if (!std::visit(Symmetric{plane}, scene.obstacles[at(obstacle)])) return false;
    }
    if (limited(model, static_cast<int>(k)) &&
        !region_fits(*model.system.contacts[k], contact, turns[at(contact.slave.body)].direction))
      return false;
  }
  return true;
}

/// The numbers of a half's functions along a direction: those that live on elements that begin before the middle.
std::vector<int> half(const Space1D& space) {
  const double middle = (space.first() + space.last()) / 2, limit = symmetry_tolerance * (space.last() - space.first());
  const auto behind = std::lower_bound(space.breaks().begin(), space.breaks().end(), middle - limit);
  const int last = static_cast<int>(behind - space.breaks().begin()) - 1;
  std::vector<int> images(at(space.functions_on(last).back() + 1));
  for (std::size_t i = 0; i < images.size(); ++i)
    images[i] = std::min(static_cast<int>(i), (space.functions() - 1) / 2);
  return images;
}

ChangedSpace beside(const nurbs::Discretisation& space, const std::set<int>& directions) {
  ChangedSpace part;
  std::vector<int> rows(space.rows().size());
  std::iota(rows.begin(), rows.end(), 0);
  if (directions.contains(space.through())) rows = half(space.stack());
  const ChangedSpace whole = unchanged(space);
  for (int row : rows) {
    part.push_back(whole[at(row)]);
    for (int a = 0; a < static_cast<int>(part.back().along.size()); ++a)
      if (directions.contains(a < space.through() ? a : a + 1))
        part.back().along[at(a)] = half(space.rows()[at(row)].direction(a));
  }
  return part;
}

} // namespace

template <int D> std::vector<Mirror> find_mirrors(const Model<D>& model) {
  const Scene<D>& scene = model.system.scene;
  constexpr double far = std::numeric_limits<double>::infinity();
  Vec<D> lower = Vec<D>::Constant(far), upper = Vec<D>::Constant(-far);
  for (const auto& body : scene.bodies) {
    const MatrixX points = body.body->space().points();
    lower = lower.cwiseMin(points.rowwise().minCoeff());
    upper = upper.cwiseMax(points.rowwise().maxCoeff());
  }
  std::vector<Mirror> found;
  for (int axis = scene.kind == solid::Kind::axisymmetric ? 1 : 0; axis < D; ++axis) {
    const MirrorPlane plane{axis, (lower(axis) + upper(axis)) / 2, (upper - lower).maxCoeff()};
    std::vector<Turn> turns;
    for (const auto& body : scene.bodies) {
      auto turn = find_turn(body.body->space(), plane);
      if (!turn) break;
      turns.push_back(std::move(*turn));
    }
    if (turns.size() < scene.bodies.size() || !loads_fit(model, plane, turns) || !contacts_fit(model, plane, turns))
      continue;
    auto driven = supports_fit(model, plane, turns);
    if (!driven) continue;
    Mirror mirror{
        axis, std::abs(plane.place) <= symmetry_tolerance * plane.length ? 0 : plane.place, {}, std::move(*driven)};
    for (const Turn& turn : turns) mirror.directions.push_back(turn.direction);
    found.push_back(std::move(mirror));
  }
  return found;
}

template <int D> int unknowns_beside(const Model<D>& model, const std::vector<Mirror>& mirrors) {
  int count = 0;
  for (int b = 0; b < static_cast<int>(model.system.scene.bodies.size()); ++b) {
    const nurbs::Discretisation& space = model.system.scene.bodies[at(b)].body->space();
    std::set<int> directions;
    for (const Mirror& mirror : mirrors) directions.insert(mirror.directions[at(b)]);
    const ChangedSpace part = beside(space, directions);
    // Number of the last function along direction d in the line through a place.
    const auto last = [&](int d, const Place& place) {
      if (d == space.through()) return static_cast<int>(part.size()) - 1;
      const ChangedRow& row = part[at(place[at(space.through())])];
      return static_cast<int>(row.along[at(space.in_row(d))].size()) - 1;
    };
    const MatrixX points = space.points();
    const double limit = symmetry_tolerance * points.cwiseAbs().maxCoeff();
    count += count_free(space, part, D, [&](int component, int function, const Place& place) {
      for (const Mirror& mirror : mirrors) {
        if (component != mirror.axis) continue;
        const int number = place[at(mirror.directions[at(b)])];
        if (number == last(mirror.directions[at(b)], place)) return true;
        // A ring that is cut ends in the plane at its other end, too.
        if (number == 0 && std::abs(points(component, function) - mirror.place) <= limit) return true;
      }
      return model.system.unknowns.unknown(model.system.unknowns.offset(b) + D * function + component) < 0;
    });
  }
  return count;
}

template std::vector<Mirror> find_mirrors(const Model<2>&);
template std::vector<Mirror> find_mirrors(const Model<3>&);
template int unknowns_beside(const Model<2>&, const std::vector<Mirror>&);
template int unknowns_beside(const Model<3>&, const std::vector<Mirror>&);

} // namespace signorini::model
