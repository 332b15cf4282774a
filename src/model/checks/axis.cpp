#include "model/checks/axis.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::model {

namespace {

/// Radii and displacements below this fraction of a body's size are rounding error.
constexpr double on_axis = 1e-12;

} // namespace

template <int D> std::vector<char> radial_on_axis(const System<D>& system) {
  std::vector<char> held(system.unknowns.dofs(), 0);
  if (system.scene.kind != solid::Kind::axisymmetric) return held;
  for (std::size_t b = 0; b < system.scene.bodies.size(); ++b) {
    const MatrixX points = system.scene.bodies[b].body->space().points();
    const double least = on_axis * points.row(0).cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < points.cols(); ++i)
      held[system.unknowns.offset(static_cast<int>(b)) + D * static_cast<int>(i)] = points(0, i) <= least;
  }
  return held;
}

template <int D> Message off_axis(const System<D>& system, int drive, const std::vector<double>& values) {
  const Drive& moving = system.drives.all()[drive];
  if (system.scene.kind != solid::Kind::axisymmetric || moving.support < 0) return {};
  VectorX targets = VectorX::Zero(system.drives.start().size());
  for (std::size_t k = 0; k < std::min(values.size(), moving.components.size()); ++k)
    targets(moving.first + static_cast<int>(k)) = values[k];
  const VectorX moved = system.drives.displacement(targets);
  const Support<D>& support = system.scene.supports[moving.support];
  const double least = on_axis * system.extent; // a body on the axis has no larger radii
  for (const int obstacle : support.obstacles)
    if (const double across = moved(system.unknowns.obstacle_offset(obstacle)); std::abs(across) > least)
      return Message("model.axis.obstacle", {{"support", support.name}, {"across", across}});
  for (const SupportedControlPoints& part : support.on) {
    const NamedBody<D>& named = system.scene.bodies[part.body];
    for (const int function : part.functions) {
      const int dof = system.unknowns.offset(part.body) + D * function;
      if (std::abs(moved(dof)) <= least) continue;
      const auto point = named.body->space().homogeneous().col(function);
      const Vec<D> place = point.template head<D>() / point(D);
      if (place(0) <= least)
        return Message("model.axis.body",
                       {{"support", support.name},
                        {"body", named.name},
                        {"at", place},
                        {"across", moved(dof)},
                        {"turns", Message(support.turns() ? "model.axis.turn" : "model.axis.drive")}});
    }
  }
  return {};
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template std::vector<char> radial_on_axis(const System<D>&);                                                         \
  template Message off_axis(const System<D>&, int, const std::vector<double>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
