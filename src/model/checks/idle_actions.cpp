#include "model/checks/idle_actions.hpp"

#include "model/checks/axis.hpp"
#include "model/scene/turning.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::model {

namespace {

/// Forces and stiffnesses below this fraction of the largest are rounding error.
constexpr double negligible = 1e-12;

/// Adds the degrees of freedom whose values are not rounding error.
void add_acting(const VectorX& values, std::vector<int>& dofs) {
  const double least = negligible * values.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < values.size(); ++i)
    if (std::abs(values(i)) > least) dofs.push_back(static_cast<int>(i));
}

/// The degrees of freedom on which a load acts: in the components with a value at the start, in all if there is none
/// yet; a pressure that follows the deformation in all, because its direction may change.
template <int D> std::vector<int> loaded(const System<D>& system, const Drive& drive) {
  const auto components = static_cast<Eigen::Index>(drive.components.size());
  const VectorX start = system.drives.start().segment(drive.first, components);
  VectorX targets = VectorX::Zero(system.drives.start().size());
  targets.segment(drive.first, components) = start.isZero(0) || !system.scene.loads[drive.load].values.empty()
                                                 ? VectorX(VectorX::Ones(components))
                                                 : VectorX((start.array() != 0).template cast<double>());
  VectorX force = system.drives.force(targets);
  system.followers.add_force(VectorX::Zero(system.unknowns.dofs()), targets, force);
  std::vector<int> dofs;
  add_acting(force, dofs);
  if (system.scene.loads[drive.load].kind != LoadKind::follower_pressure) return dofs;
  std::vector<int> all;
  for (const int dof : dofs)
    for (int c = 0; c < D; ++c) all.push_back(dof - dof % D + c);
  return all;
}

template <int D> std::vector<int> sprung(const System<D>& system, int support) {
  VectorX stiffness = VectorX::Zero(system.unknowns.dofs());
  for (const auto& part : system.springs.parts())
    if (part.support == support) stiffness(part.dofs) += part.stiffness.diagonal();
  std::vector<int> dofs;
  add_acting(stiffness, dofs);
  return dofs;
}

/// The names of the supports that prescribe some of these displacements: "supports.bed, supports.grip".
template <int D> std::string holders(const System<D>& system, const std::vector<int>& dofs) {
  std::string names;
  for (std::size_t s = 0; s < system.scene.supports.size(); ++s) {
    const Support<D>& support = system.scene.supports[s];
    const auto holds = [&](int dof) {
      return support.constraint[dof % D] != Constraint::free &&
             std::ranges::binary_search(system.unknowns.of_support(static_cast<int>(s), dof % D), dof);
    };
    const auto holds_obstacle = [&](int obstacle) {
      return std::ranges::any_of(dofs, [&](int dof) {
        const int component = dof - system.unknowns.obstacle_offset(obstacle);
        return component >= 0 && component < D && holder_of(system.scene, obstacle, component) == &support;
      });
    };
    if (std::ranges::any_of(dofs, holds) || std::ranges::any_of(support.obstacles, holds_obstacle))
      names += (names.empty() ? "supports." : ", supports.") + support.name;
  }
  return names;
}

/// True if f does not change in a rotation: ∇f·(a × r) = 0 at all points of its mesh.
template <int D> bool is_round(const contact::LevelSet<D>& level_set, const Vec<D>& center, const Vec<D>& axis) {
  const auto& points = level_set.compiled->mesh.points;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Vec<D> arm = points.col(i) - center, gradient = (*level_set.compiled)(points.col(i)).gradient;
    Vec<D> way;
    if constexpr (D == 2)
      way = Vec<2>(-arm(1), arm(0));
    else
      way = axis.cross(arm);
    if (std::abs(gradient.dot(way)) > 1e-9 * gradient.norm() * arm.norm()) return false;
  }
  return true;
}

/// True if an obstacle is round about the axis of its free angle, so that only friction turns it.
template <int D> bool is_round(const Scene<D>& scene, const FreeAngle<D>& angle) {
  const contact::Obstacle<D>& shape = scene.obstacles[angle.obstacle];
  const Vec<D> center = turn_of(scene, angle.obstacle)->turning.center;
  const double tolerance = negligible * angle.arm;
  if (const auto* ball = std::get_if<contact::Ball<D>>(&shape)) {
    Vec<D> arm = ball->center - center;
    if constexpr (D == 3) arm -= angle.axis * angle.axis.dot(arm);
    return arm.norm() <= tolerance;
  }
  if (const auto* level_set = std::get_if<contact::LevelSet<D>>(&shape))
    return is_round<D>(*level_set, center, angle.axis);
  if constexpr (D == 3) {
    const auto coaxial = [&](const Vec<3>& point, const Vec<3>& axis) {
      return axis.cross(angle.axis).norm() <= negligible && (point - center).cross(angle.axis).norm() <= tolerance;
    };
    if (const auto* cylinder = std::get_if<contact::Cylinder>(&shape)) return coaxial(cylinder->point, cylinder->axis);
    if (const auto* torus = std::get_if<contact::Torus>(&shape)) return coaxial(torus->center, torus->axis);
    if (const auto* plane = std::get_if<contact::Plane<3>>(&shape))
      return plane->normal.cross(angle.axis).norm() <= negligible;
  }
  return false;
}

/// Warns of free angles of round obstacles that are in contact without friction.
template <int D> void warn_of_idle_angles(const System<D>& system, std::vector<Message>& warnings) {
  for (const FreeAngle<D>& angle : system.unknowns.free_angles()) {
    const auto rubs = [&](const Contact<D>& contact) {
      const auto* master = std::get_if<ObstacleReference>(&contact.master);
      const contact::InterfaceLaw* law = contact.own || contact.method.law.adhesion ? nullptr : &contact.method.law;
      return master && master->obstacle == angle.obstacle && (!law || may_rub(*law) || contact.method.bond);
    };
    if (is_round(system.scene, angle) && std::ranges::none_of(system.scene.contacts, rubs))
      warnings.push_back(
          Message("model.warning.idle_angle", {{"support", support_of(system.scene, angle.obstacle, "angle")}}));
  }
}

} // namespace

template <int D> void warn_of_idle_actions(const System<D>& system, std::vector<Message>& warnings) {
  warn_of_idle_angles(system, warnings);
  if (system.scene.loads.empty() && system.springs.parts().empty()) return;
  const std::vector<char> on_axis = radial_on_axis(system);
  const auto warn = [&](const std::vector<int>& dofs, const Message& action) {
    if (dofs.empty() && system.scene.kind != solid::Kind::axisymmetric)
      warnings.push_back(Message("model.warning.idle_no_area", {{"action", action}}));
    else if (std::ranges::all_of(dofs, [&](int dof) { return on_axis[dof] != 0; }))
      warnings.push_back(Message("model.warning.idle_on_axis", {{"action", action}}));
    else if (std::ranges::all_of(dofs, [&](int dof) { return on_axis[dof] != 0 || system.unknowns.unknown(dof) < 0; }))
      warnings.push_back(Message("model.warning.idle", {{"action", action}, {"supports", holders(system, dofs)}}));
  };
  for (const Drive& drive : system.drives.all()) {
    if (drive.load < 0) continue;
    const Load& load = system.scene.loads[drive.load];
    if (!load.values.empty() && std::ranges::all_of(load.values, [](double value) { return value == 0; }))
      warnings.push_back(Message("model.warning.zero_function", {{"load", load.name}}));
    else if (load.kind != LoadKind::body_force)
      warn(loaded(system, drive), Message("model.action.load", {{"name", drive.name}}));
  }
  for (std::size_t s = 0; s < system.scene.supports.size(); ++s)
    if (!system.scene.supports[s].spring_faces.empty())
      warn(sprung(system, static_cast<int>(s)),
           Message("model.action.springs", {{"name", system.scene.supports[s].name}}));
}

template void warn_of_idle_actions(const System<2>&, std::vector<Message>&);
template void warn_of_idle_actions(const System<3>&, std::vector<Message>&);

} // namespace signorini::model
