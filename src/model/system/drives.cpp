#include "model/system/drives.hpp"

#include "base/error.hpp"
#include "model/scene/rotation.hpp"
#include "model/scene/turning.hpp"
#include "solid/load.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

namespace signorini::model {

namespace {

constexpr double radians_per_degree = std::numbers::pi / 180;

/// Components of a support that a path controls.
template <int D> std::vector<std::string> moved_components(const Support<D>& support) {
  if (support.shaped()) return {"factor"};
  std::vector<std::string> names;
  for (int c = 0; c < D; ++c)
    if (support.constraint[c] == Constraint::driven) names.push_back(component_name(c));
  if (support.turns()) names.emplace_back("angle");
  return names;
}

template <int D> std::vector<std::string> load_components(const Load& load) {
  if (!load.values.empty()) return {"factor"};
  if (load.pressure()) return {"pressure"};
  if (load.kind == LoadKind::moment) return {"moment"};
  std::vector<std::string> names;
  const char* prefix = load.kind == LoadKind::body_force ? "b" : load.kind == LoadKind::point_force ? "p" : "";
  for (int c = 0; c < D; ++c) names.push_back(prefix + component_name(c));
  return names;
}

/// The values of the next points of a load's function, components × points.
MatrixX next_values(const Load& load, Eigen::Index& used, int components, Eigen::Index points) {
  const Eigen::Index first = std::exchange(used, used + components * points);
  return Eigen::Map<const MatrixX>(load.values.data() + first, components, points);
}

} // namespace

template <int D>
Drives<D>::Drives(const Scene<D>& scene, const Unknowns<D>& unknowns) : scene_(scene), unknowns_(unknowns) {
  int count = 0;
  const auto add = [&](Drive drive) {
    drive.first = count;
    count += std::ssize(drive.components);
    if (!drive.components.empty()) all_.push_back(std::move(drive));
  };
  for (int s = 0; s < std::ssize(scene.supports); ++s) {
    const Support<D>& support = scene.supports[s];
    add({support.name, s, -1, 0, moved_components(support)});
  }
  for (int l = 0; l < std::ssize(scene.loads); ++l)
    add({scene.loads[l].name, -1, l, 0, load_components<D>(scene.loads[l])});

  start_ = VectorX::Zero(count);
  loads_ = MatrixX::Zero(unknowns.dofs(), count);
  for (const Drive& drive : all_) {
    if (drive.support >= 0) {
      follow(drive.support, drive);
      continue;
    }
    const Load& load = scene.loads[drive.load];
    for (int k = 0; k < std::ssize(drive.components); ++k) {
      start_(drive.first + k) = load.start[k];
      if (load.kind == LoadKind::follower_pressure) continue; // model/system/follower_loads.hpp
      add_unit_load(load, k, loads_.col(drive.first + k));
    }
  }
}

/// Adds the force of a load for a unit target k.
template <int D> void Drives<D>::add_unit_load(const Load& load, int k, Eigen::Ref<VectorX> force) const {
  const auto add = [&](int body, const VectorX& unit) { force.segment(unknowns_.offset(body), unit.size()) += unit; };
  Eigen::Index used = 0; // of a function's values
  for (const FaceReference& face : load.on) {
    const solid::Body<D>& body = *scene_.bodies[face.body].body;
    if (load.values.empty())
      add(face.body,
          load.pressure() ? solid::pressure_load(body, face.side) : solid::traction_load(body, face.side, k));
    else
      add(face.body, solid::distributed_load(
                         body, face.side,
                         next_values(load, used, load.pressure() ? 1 : D, solid::face_point_count(body, face.side))));
  }
  for (const int index : load.bodies) {
    const solid::Body<D>& body = *scene_.bodies[index].body;
    const auto count = static_cast<Eigen::Index>(body.tables().points());
    add(index, load.values.empty() ? solid::body_load(body, k)
                                   : solid::distributed_load(body, next_values(load, used, D, count)));
  }
  for (const PointShare& point : load.points)
    force(unknowns_.offset(point.body) + D * point.function + k) += point.share;
  for (const int obstacle : load.obstacles) {
    if (load.kind != LoadKind::moment) force(unknowns_.obstacle_offset(obstacle) + k) += 1;
    for (const FreeAngle<D>& angle : unknowns_.free_angles())
      if (load.kind == LoadKind::moment && angle.obstacle == obstacle) force(angle.dof) += 1 / angle.arm;
  }
}

template <int D> int Drives<D>::target(int drive, int component) const {
  require(drive >= 0 && drive < std::ssize(all_), "model.drive.unknown", {{"drive", drive}, {"count", all_.size()}});
  const Drive& found = all_[drive];
  require(component >= 0 && component < std::ssize(found.components), "model.drive.component",
          {{"drive", found.name}, {"component", component}, {"count", found.components.size()}});
  return found.first + component;
}

/// The displacement of a degree of freedom of a support with a shape: that of its control point, or of the one at the
/// same place that the support holds.
template <int D> double Drives<D>::shape_of(const Support<D>& support, int body, int function, int component) const {
  const auto place = [&](int b, int f) -> Vec<D> {
    const auto point = scene_.bodies[b].body->space().homogeneous().col(f);
    return point.template head<D>() / point(D);
  };
  const Vec<D> here = place(body, function);
  double nearest = std::numeric_limits<double>::infinity(), value = 0;
  for (const SupportedControlPoints& points : support.on)
    for (std::size_t i = 0; i < points.functions.size(); ++i) {
      const double own = points.shape[D * i + component];
      if (points.body == body && points.functions[i] == function) return own;
      const double distance = (place(points.body, points.functions[i]) - here).norm();
      if (distance >= nearest) continue;
      nearest = distance;
      value = own;
    }
  return value;
}

/// Adds the degrees of freedom that a support moves.
template <int D> void Drives<D>::follow(int s, const Drive& drive) {
  const Support<D>& support = scene_.supports[s];
  const int angle = support.turns() ? drive.first + static_cast<int>(drive.components.size()) - 1 : -1;
  for (int c = 0, next = drive.first; c < D; ++c) {
    const bool driven = support.constraint[c] == Constraint::driven;
    const int target = !driven ? -1 : support.shaped() ? drive.first : next++;
    if (!driven && !support.rotates) continue;
    for (const int dof : unknowns_.of_support(s, c)) {
      if (dof >= unknowns_.obstacles()) {
        if (driven) followers_.push_back({dof, c, target, -1, Vec<D>::Zero(), Vec<D>::Zero(), 1});
        continue;
      }
      std::size_t body = scene_.bodies.size() - 1;
      while (dof < unknowns_.offset(static_cast<int>(body))) --body;
      const nurbs::Discretization& space = scene_.bodies[body].body->space();
      const int function = (dof - unknowns_.offset(static_cast<int>(body))) / D;
      const auto point = space.homogeneous().col(function);
      const double shape = support.shaped() ? shape_of(support, static_cast<int>(body), function, c) : 1;
      followers_.push_back(
          {dof, c, target, angle, point.template head<D>() / point(D) - support.center, support.axis, shape});
    }
  }
  if (angle < 0) return;
  for (const int obstacle : support.obstacles) {
    const double arm = turn_of(scene_, obstacle)->turning.arm;
    for (int i = 0, dof = unknowns_.obstacle_offset(obstacle) + D; i < D; ++i)
      for (int c = 0; c < D; ++c, ++dof)
        followers_.push_back({dof, c, -1, angle, arm * Vec<D>::Unit(i), support.axis, 1});
  }
}

template <int D> VectorX Drives<D>::displacement(const VectorX& targets) const {
  VectorX result = VectorX::Zero(unknowns_.dofs());
  for (const Follower& f : followers_) {
    double& u = result(f.dof);
    u = f.target >= 0 ? f.shape * targets(f.target) : 0;
    if (f.angle >= 0) u += turned<D>(targets(f.angle) * radians_per_degree, f.axis, f.arm)(f.component);
  }
  return result;
}

template <int D> VectorX Drives<D>::rate(const VectorX& targets, const VectorX& direction) const {
  VectorX result = VectorX::Zero(unknowns_.dofs());
  for (const Follower& f : followers_) {
    double& u = result(f.dof);
    u = f.target >= 0 ? f.shape * direction(f.target) : 0;
    if (f.angle >= 0)
      u += radians_per_degree * direction(f.angle) *
           rotation_rate<D>(targets(f.angle) * radians_per_degree, f.axis, f.arm, 1)(f.component);
  }
  return result;
}

template <int D> VectorX Drives<D>::force(const VectorX& targets) const {
  return loads_ * targets;
}

template <int D> double Drives<D>::moment(int support, const VectorX& targets, const VectorX& force) const {
  // With a unit rate of the angle in radians, M = f · ∂u/∂θ.
  for (const Drive& drive : all_) {
    if (drive.support != support || !scene_.supports[support].turns()) continue;
    VectorX turn = VectorX::Zero(targets.size());
    turn(drive.first + static_cast<int>(drive.components.size()) - 1) = 1 / radians_per_degree;
    return rate(targets, turn).dot(force);
  }
  return 0;
}

template <int D> VectorX Drives<D>::only(int load, const VectorX& targets) const {
  VectorX own = VectorX::Zero(targets.size());
  for (const Drive& drive : all_)
    if (drive.load == load) {
      const auto size = static_cast<Eigen::Index>(drive.components.size());
      own.segment(drive.first, size) = targets.segment(drive.first, size);
    }
  return own;
}

template <int D> Vec<D> face_centroid(const solid::Body<D>& body, nurbs::Side side) {
  // ∫ X dA / ∫ dA = Σ_A X_A ∫ R_A dA / Σ_A ∫ R_A dA
  const VectorX unit = solid::traction_load(body, side, 0);
  const MatrixX points = body.space().points();
  Vec<D> moment = Vec<D>::Zero();
  double area = 0;
  for (int a = 0; a < body.functions(); ++a) {
    moment += unit(D * a) * points.col(a);
    area += unit(D * a);
  }
  require(area > 0, "model.face.no_area", {{"face", nurbs::name_of(side)}});
  return moment / area;
}

template class Drives<2>;
template class Drives<3>;
template Vec<2> face_centroid<2>(const solid::Body<2>&, nurbs::Side);
template Vec<3> face_centroid<3>(const solid::Body<3>&, nurbs::Side);

} // namespace signorini::model
