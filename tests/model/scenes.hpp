#pragma once
// Scenes for tests: the published ironing problem, and small scenes of one body.

#include "model/results/results.hpp"
#include "model/steps/arc.hpp"
#include "model/steps/load_step.hpp"
#include "nurbs/plan.hpp"
#include "nurbs/random_patch.hpp"
#include "nurbs/shapes.hpp"
#include "solid/linear_elastic.hpp"
#include "solid/neo_hookean.hpp"

namespace signorini::model::test {

inline std::shared_ptr<const solid::Body<2>> make_body(const nurbs::Patch& patch, std::vector<int> elements,
                                                       const std::string& label, const std::string& contact,
                                                       const solid::Material& material,
                                                       std::optional<int> thickness_degree = 1,
                                                       solid::Kind kind = solid::Kind::plane_strain) {
  return std::make_shared<const solid::Body<2>>(
      std::make_shared<const nurbs::Discretization>(
          patch, nurbs::test::plan_of(std::move(elements), contact, label, thickness_degree)),
      material, kind);
}

inline SupportedControlPoints face_points(const Scene<2>& scene, int body, const std::string& face) {
  return {body, scene.bodies[body].body->space().face_functions(nurbs::side_of(face, 2))};
}

enum Supports { bed, grip };
/// Index of the ironing problem's only drive.
inline constexpr int drive_of_grip = 0;

/// 2D frictional ironing (thesis 7.1) at mesh m1: the die's flat ends are driven, the slab's bottom is clamped.
inline Scene<2> ironing(const std::string& label) {
  Scene<2> scene;
  const nurbs::Patch arc = nurbs::half_annulus(0.3, 0.5, Eigen::Vector2d(0.75, 1.5));
  scene.bodies.push_back({"die", make_body(arc, {6, 2}, label, "south", solid::neo_hookean(1000, 0.3))});
  const nurbs::Patch block = nurbs::rectangle(3, 1, Eigen::Vector2d(0, 0));
  scene.bodies.push_back({"slab", make_body(block, {8, 3}, label, "north", solid::neo_hookean(1, 0.3))});
  scene.supports.push_back({"bed", {face_points(scene, 1, "south")}, {Constraint::fixed, Constraint::fixed}});
  scene.supports.push_back({"grip",
                            {face_points(scene, 0, "west"), face_points(scene, 0, "east")},
                            {Constraint::driven, Constraint::driven}});
  const nurbs::Side south = nurbs::side_of("south", 2), north = nurbs::side_of("north", 2);
  const int degree = scene.bodies[0].body->space().face(south).direction(0).degree();
  scene.contacts.push_back(
      {"interface", {0, south}, FaceReference{1, north}, contact::InterfaceLaw{100, 100, 0.2}, 3 * (degree + 1)});
  return scene;
}

/// The ironing problem with another slab.
inline Scene<2> ironing_on(nurbs::Discretization slab) {
  Scene<2> scene = ironing("N2");
  const solid::Material material = scene.bodies[1].body->material();
  scene.bodies[1].body = std::make_shared<const solid::Body<2>>(std::move(slab), material);
  scene.supports[0].on = {face_points(scene, 1, "south")};
  return scene;
}

/// Degrees of a slab's contact row by element, to be used with nurbs::test::strip(3, …).
inline const std::vector<int> mixed_degrees{2, 4, 2, 3, 4, 2, 2, 4};

/// The control point of a body at X.
inline SupportedControlPoints corner(const Scene<2>& scene, int body, const Vec<2>& place) {
  const MatrixX points = scene.bodies[body].body->space().points();
  Eigen::Index function;
  (points.colwise() - place).colwise().norm().minCoeff(&function);
  return {body, {static_cast<int>(function)}};
}

/// A unit square of one material with given supports on its faces.
struct Grip {
  const char *name, *face;
  std::array<Constraint, 2> constraint;
};
inline Scene<2> square(const std::vector<Grip>& grips, const solid::Material& material = solid::neo_hookean(1, 0.3)) {
  Scene<2> scene;
  scene.bodies.push_back(
      {"block", make_body(nurbs::rectangle(1, 1, Eigen::Vector2d(0, 0)), {2, 2}, "N2", "north", material)});
  for (const Grip& grip : grips)
    scene.supports.push_back({grip.name, {face_points(scene, 0, grip.face)}, grip.constraint});
  return scene;
}

inline solve::NewtonReport step_to(Model<2>& model, int drive, double x, double y, const StepOptions& options = {}) {
  set_target(model, drive, 0, x);
  set_target(model, drive, 1, y);
  return solve_step(model, options);
}

/// Solves step 1 … 296 of the published path: 46 steps of pressing to −0.23, then 250 of sliding to 1.5.
inline solve::NewtonReport ironing_step(Model<2>& model, int step, const StepOptions& options = {}) {
  const double press = std::min(step, 46) / 46.0, slide = std::max(step - 46, 0) / 250.0;
  return step_to(model, drive_of_grip, 1.5 * slide, -0.23 * press, options);
}

} // namespace signorini::model::test
