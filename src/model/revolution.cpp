#include "model/revolution.hpp"

#include "base/index.hpp"
#include "model/changed_space.hpp"
#include "model/cost.hpp"
#include "model/symmetry.hpp"

namespace signorini::model {

namespace {

using nurbs::Discretisation;
using nurbs::Side;

/// An axis under trial.
struct Axis {
  int axis;
  std::array<int, 2> across; ///< the two other components
  double length;             ///< what differences of coordinates are measured against
};

/// Points of a body with the unit tangents along its parametric directions; zero where the map collapses.
struct Samples {
  std::vector<Vec<3>> points;
  std::vector<Mat<3>> tangents; ///< one per column
};

Samples take_samples(const Discretisation& space) {
  // Two places in each element, with no symmetry.
  static const Vec<3> inside[] = {{0.37, 0.59, 0.71}, {0.83, 0.21, 0.44}};
  const MatrixX points = space.points();
  Samples samples;
  for (int e = 0; e < space.elements(); ++e)
    for (const Vec<3>& share : inside) {
      const nurbs::ElementBasis basis = space.basis(e, space.parameter(e, share));
      Vec<3> point = Vec<3>::Zero();
      Mat<3> tangent = Mat<3>::Zero();
      for (std::size_t a = 0; a < basis.functions.size(); ++a) {
        const auto i = static_cast<Eigen::Index>(a);
        point += basis.values(i) * points.col(basis.functions[a]);
        tangent += points.col(basis.functions[a]) * basis.gradients.col(i).transpose();
      }
      tangent.colwise().normalize();
      samples.points.push_back(point);
      samples.tangents.push_back(tangent);
    }
  return samples;
}

/// Where the axis pierces the plane across it if direction d runs on circles about it: the least-squares solution of
/// t·(x − c) = 0, when it solves all.
std::optional<Eigen::Vector2d> find_centre(const Samples& samples, int d, const Axis& axis) {
  const auto across = [&](const Vec<3>& vector) {
    return Eigen::Vector2d(vector(axis.across[0]), vector(axis.across[1]));
  };
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < samples.points.size(); ++i) {
    if (std::abs(samples.tangents[i](axis.axis, d)) > symmetry_tolerance) return std::nullopt;
    const Eigen::Vector2d tangent = across(samples.tangents[i].col(d));
    normal += tangent * tangent.transpose();
    right += tangent * tangent.dot(across(samples.points[i]));
  }
  constexpr double straight = 1e-6; // tangents that are all alike belong to no circle
  if (normal.determinant() < straight * normal.trace() * normal.trace()) return std::nullopt;
  const Eigen::Vector2d centre = normal.inverse() * right;
  for (std::size_t i = 0; i < samples.points.size(); ++i)
    if (std::abs(across(samples.tangents[i].col(d)).dot(across(samples.points[i]) - centre)) >
        symmetry_tolerance * axis.length)
      return std::nullopt;
  return centre;
}

/// Directions and centre for all bodies, wherever supports and contacts are.
std::optional<Revolution> find_shape(const std::vector<Samples>& bodies, const Axis& axis) {
  Revolution found{axis.axis, Vec<3>::Zero(), {}};
  for (const Samples& samples : bodies) {
    std::optional<Eigen::Vector2d> centre;
    int d = 0;
    while (d < 3 && !(centre = find_centre(samples, d, axis))) ++d;
    if (!centre) return std::nullopt;
    for (std::size_t k = 0; k < 2; ++k) {
      double& coordinate = found.centre(axis.across[k]);
      if (found.directions.empty()) coordinate = (*centre)(static_cast<Eigen::Index>(k));
      if (std::abs(coordinate) <= symmetry_tolerance * axis.length) coordinate = 0;
      // The least squares of small sectors lose a digit.
      if (std::abs(coordinate - (*centre)(static_cast<Eigen::Index>(k))) > 10 * symmetry_tolerance * axis.length)
        return std::nullopt;
    }
    found.directions.push_back(d);
  }
  return found;
}

/// What holds the degrees of freedom of a body: 0 nothing, 1 a support that fixes, 2 + i drive i.
std::vector<int> holders(const Model<3>& model, int body) {
  const Scene<3>& scene = model.system.scene;
  const Unknowns<3>& unknowns = model.system.unknowns;
  std::vector<int> holder(at(3 * scene.bodies[at(body)].body->functions()));
  for (int i = 0; i < static_cast<int>(holder.size()); ++i)
    holder[at(i)] = unknowns.unknown(unknowns.offset(body) + i) < 0;
  for (std::size_t s = 0; s < scene.supports.size(); ++s)
    for (const Held& held : scene.supports[s].on)
      for (int function : held.functions)
        for (int c = 0; c < 3; ++c)
          if (held.body == body && scene.supports[s].hold[at(c)] == Hold::driven)
            holder[at(3 * function + c)] = 2 + static_cast<int>(s);
  return holder;
}

/// The functions of lines along direction d: each list one line, from start to end.
std::vector<std::vector<int>> lines_along(const Discretisation& space, int d) {
  std::vector<Place> all = places(space);
  std::vector<std::pair<Place, int>> order;
  for (int f = 0; f < space.functions(); ++f) {
    Place rest = all[at(f)];
    rest[at(d)] = 0;
    order.emplace_back(rest, f);
  }
  std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::vector<int>> lines;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || order[i].first != order[i - 1].first) lines.emplace_back();
    lines.back().push_back(order[i].second);
  }
  return lines;
}

/// The component along the normal of the plane through the axis in which these control points lie; −1: none.
int plane_of(const MatrixX& points, const std::vector<int>& functions, const Axis& axis, const Vec<3>& centre) {
  for (int c : axis.across)
    if (std::all_of(functions.begin(), functions.end(),
                    [&](int f) { return std::abs(points(c, f) - centre(c)) <= symmetry_tolerance * axis.length; }))
      return c;
  return -1;
}

/// Whether the supports of a body are the same all around, and hold the ends of a sector as symmetry planes.
bool held_all_around(const Model<3>& model, int body, const Revolution& revolution, const Axis& axis) {
  const Discretisation& space = model.system.scene.bodies[at(body)].body->space();
  const int d = revolution.directions[at(body)];
  const std::vector<int> holder = holders(model, body);
  const MatrixX points = space.points();
  const std::vector<std::vector<int>> lines = lines_along(space, d);
  // A line through a layer along the axis would be of several rows' spaces; along the circles each row has its own.
  if (d == space.through() && std::any_of(space.rows().begin(), space.rows().end(), [&](const nurbs::Row& row) {
        return row.functions() != space.rows().front().functions();
      }))
    return false;
  const std::vector<int> start = space.face_functions({d, false}), end = space.face_functions({d, true});
  const bool closed = std::all_of(lines.begin(), lines.end(), [&](const std::vector<int>& line) {
    return (points.col(line.front()) - points.col(line.back())).norm() <= symmetry_tolerance * axis.length;
  });
  const int first_plane = closed ? -1 : plane_of(points, start, axis, revolution.centre);
  const int last_plane = closed ? -1 : plane_of(points, end, axis, revolution.centre);
  if (!closed && (first_plane < 0 || last_plane < 0)) return false;
  return std::all_of(lines.begin(), lines.end(), [&](const std::vector<int>& line) {
    if (line.size() < 3) return false;
    const auto held = [&](int function, int c) { return holder[at(3 * function + c)]; };
    const bool across = held(line[1], axis.across[0]) != 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (held(line[i], axis.axis) != held(line.front(), axis.axis)) return false;
      for (int c : axis.across) {
        const bool by_plane = (i == 0 && c == first_plane) || (i + 1 == line.size() && c == last_plane);
        if (held(line[i], c) != (by_plane || across ? 1 : 0)) return false;
      }
    }
    return true;
  });
}

/// Whether an obstacle is one of revolution about the axis.
struct Revolves {
  const Axis& axis;
  const Vec<3>& centre;

  bool on_axis(const Vec<3>& point) const {
    return std::all_of(axis.across.begin(), axis.across.end(),
                       [&](int c) { return std::abs(point(c) - centre(c)) <= symmetry_tolerance * axis.length; });
  }
  bool along(const Vec<3>& direction) const { return std::abs(direction(axis.axis)) >= 1 - symmetry_tolerance; }
  bool operator()(const contact::Plane<3>& plane) const { return along(plane.normal); }
  bool operator()(const contact::Ball<3>& ball) const { return on_axis(ball.centre); }
  bool operator()(const contact::Cylinder& cylinder) const { return along(cylinder.axis) && on_axis(cylinder.point); }
  bool operator()(const nurbs::Patch&) const { return false; }
};

bool actions_fit(const Model<3>& model, const Revolution& revolution, const Axis& axis) {
  const Scene<3>& scene = model.system.scene;
  const auto around = [&](const FaceReference& face) {
    return face.side.direction != revolution.directions[at(face.body)];
  };
  for (const Support<3>& support : scene.supports)
    if (support.rotates ||
        std::any_of(axis.across.begin(), axis.across.end(), [&](int c) { return support.hold[at(c)] == Hold::driven; }))
      return false;
  for (int l = 0; l < static_cast<int>(scene.loads.size()); ++l) {
    const Load& load = scene.loads[at(l)];
    if (!std::all_of(load.on.begin(), load.on.end(), around)) return false;
    if (!load.pressure && std::any_of(axis.across.begin(), axis.across.end(),
                                      [&](int c) { return accepted_value(model, -1, l, c) != 0; }))
      return false;
  }
  for (int k = 0; k < static_cast<int>(scene.contacts.size()); ++k) {
    const Contact<3>& contact = scene.contacts[at(k)];
    if (limited(model, k) || !around(contact.slave)) return false;
    if (const auto* master = std::get_if<FaceReference>(&contact.master)) {
      if (!around(*master)) return false;
    } else {
      const int obstacle = std::get<ObstacleReference>(contact.master).obstacle;
      if (!std::visit(Revolves{axis, revolution.centre}, scene.obstacles[at(obstacle)])) return false;
    }
  }
  return true;
}

double longest_side(const Scene<3>& scene) {
  double length = 0;
  for (const auto& body : scene.bodies) {
    const MatrixX points = body.body->space().points();
    length = std::max(length, (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).maxCoeff());
  }
  return length;
}

} // namespace

std::optional<Revolution> find_revolution(const Model<3>& model) {
  const Scene<3>& scene = model.system.scene;
  std::vector<Samples> bodies;
  for (const auto& body : scene.bodies) bodies.push_back(take_samples(body.body->space()));
  for (int e = 0; e < 3; ++e) {
    const Axis axis{e, {(e + 1) % 3, (e + 2) % 3}, longest_side(scene)};
    std::optional<Revolution> found = find_shape(bodies, axis);
    if (!found || !actions_fit(model, *found, axis)) continue;
    bool held = true;
    for (int b = 0; b < static_cast<int>(scene.bodies.size()); ++b)
      held = held && held_all_around(model, b, *found, axis);
    if (held) return found;
  }
  return std::nullopt;
}

int unknowns_of_section(const Model<3>& model, const Revolution& revolution) {
  int count = 0;
  const int e = revolution.axis, first = (e + 1) % 3, second = (e + 2) % 3;
  const double length = longest_side(model.system.scene);
  for (int b = 0; b < static_cast<int>(model.system.scene.bodies.size()); ++b) {
    const Discretisation& space = model.system.scene.bodies[at(b)].body->space();
    const int d = revolution.directions[at(b)];
    ChangedSpace section = unchanged(space);
    // The second function of each line: what planes at the ends hold does not count.
    if (d == space.through()) {
      section = {section[1]};
    } else {
      for (ChangedRow& row : section) row.along[at(space.in_row(d))] = {1};
    }
    const MatrixX points = space.points();
    const auto on_axis = [&](int function) {
      const Vec<3> arm = points.col(function) - revolution.centre;
      return std::hypot(arm(first), arm(second)) <= symmetry_tolerance * length;
    };
    count += count_free(space, section, 2, [&](int component, int function, const Place&) {
      if (component == 0 && on_axis(function)) return true;
      const int held = component == 0 ? first : e;
      return model.system.unknowns.unknown(model.system.unknowns.offset(b) + 3 * function + held) < 0;
    });
  }
  return count;
}

} // namespace signorini::model
