// A user-defined contact formulation: one pressure per slave element as additional unknown, without friction.
#include "model/scenes.hpp"

#include "model/bench.hpp"
#include "model/files/checkpoint.hpp"
#include "text_of.hpp"

#include <cmath>

namespace signorini::model {
namespace own_formulation_test {

using namespace test;
using contact::Block;
using contact::ContactState;

constexpr double stiffness = 100; ///< c, pressure per length: scales the unknowns, results do not depend on it

/// With z_e = p_e/c, ḡ_e the mean gap of slave element e, all per reference area:
///   f = ∓∫ R_A c z_e n̄ dA,   0 = −c ∫ g dA if z_e − ḡ_e > 0, otherwise 0 = −c ∫ z_e dA.
class ElementPressures final : public contact::Formulation<2> {
public:
  explicit ElementPressures(contact::ContactSetting<2> setting) : Formulation(std::move(setting)) {}

  int extra_unknowns() const override { return slave().elements(); } // pressures
  bool has_potential() const override { return false; } // unsymmetric where open: 0 = −c ∫ z_e dA is independent of u
  double stiffness(const contact::History<2>&, double) const override { return 0; }
  int parts() const override { return 1; }
  void gather(const contact::Trial<2>&, bool) override {}

  void evaluate_part(int, const contact::Trial<2>& trial, bool) override {
    for (std::size_t first = 0, last; first < points_.size(); first = last) {
      const int element = points_.list[first].element;
      std::vector<contact::FacePoint<2>> feet;
      double area = 0, sum = 0; // A_e, ∫ g dA
      for (last = first; last < points_.size() && points_.list[last].element == element; ++last) {
        contact::Projection<2>& projection = trial.present.points[last].projection;
        contact::PointResult<2>& result = trial.present.results[last];
        result = {};
        result.position = position(points_, slave(), last);
        feet.emplace_back();
        projection = master().project(result.position, projection, feet.back());
        master().functions(feet.back(), 1);
        result.gap = projection.gap;
        area += weight(last);
        sum += weight(last) * projection.gap;
      }
      const double z = trial.extra[element];
      const bool touches = z - sum / area > 0;
      for (std::size_t i = first; i < last; ++i) add(i, feet[i - first], trial, z, touches);
    }
  }

private:
  double weight(std::size_t i) const { return points_.list[i].weight * points_.list[i].reference_area; }

  Block& block_of(int slave_element, int master_element) {
    for (Block& block : blocks_)
      if (block.slave_element == slave_element && block.master_element == master_element) return block;
    Block block{slave_element, master_element, -1, {slave_element}};
    block.rows = block.columns = 2 * (slave().functions_on(slave_element) + master().functions_on(master_element)) + 1;
    block.force.assign(static_cast<std::size_t>(block.rows), 0);
    block.matrix.assign(static_cast<std::size_t>(block.rows * block.columns), 0);
    blocks_.push_back(block);
    return blocks_.back();
  }

  void add(std::size_t i, const contact::FacePoint<2>& foot, const contact::Trial<2>& trial, double z, bool touches) {
    using Force = contact::LocalForce<2>;
    contact::PointResult<2>& result = trial.present.results[i];
    contact::LocalGeometry<2> geometry;
    geometry.slave = result.position;
    geometry.slave_tangent = tangents(points_, slave(), i);
    geometry.master = &foot;
    geometry.foot = contact::Foot::regular;
    geometry.gap = result.gap;
    geometry.normal = master().normal(foot);
    Eigen::Matrix<double, 1, Force::columns> shift;
    const contact::GapRows<2> rows = gap_rows(geometry, shift);

    Block& block = block_of(points_.list[i].element, foot.element);
    const int ns = slave().functions_on(block.slave_element), nm = master().functions_on(foot.element);
    const int last = block.columns - 1;
    Eigen::Map<VectorX> force(block.force.data(), block.rows);
    Eigen::Map<Eigen::Matrix<double, -1, -1, Eigen::RowMajor>> matrix(block.matrix.data(), block.rows, block.columns);
    // Derivatives with respect to control points: xˢ, x̄ᵐ, τ are sums with these factors.
    MatrixX nodes = MatrixX::Zero(Force::columns, block.columns);
    const double* r = points_.functions(i);
    for (int c = 0; c < 2; ++c) {
      for (int b = 0; b < ns; ++b) nodes(c, 2 * b + c) = r[b];
      for (int b = 0; b < nm; ++b) {
        nodes(Force::master_column + c, 2 * (ns + b) + c) = foot.value[b];
        nodes(Force::tangent_column + c, 2 * (ns + b) + c) = foot.derivative[0][b];
      }
    }
    const double w = weight(i), pressure = own_formulation_test::stiffness * z;
    const Eigen::RowVectorXd gap = rows.gap * nodes, foot_shift = shift * nodes;
    const MatrixX normal = rows.normal * nodes;
    for (int a = 0; a < ns + nm; ++a) {
      const std::size_t m = static_cast<std::size_t>(a - ns);
      const double share = a < ns ? -r[a] : foot.value[m]; // −R_A, R̄_A
      force.segment<2>(2 * a) += w * share * pressure * geometry.normal;
      matrix.middleRows<2>(2 * a) += w * share * pressure * normal;
      matrix.col(last).segment<2>(2 * a) += w * share * own_formulation_test::stiffness * geometry.normal;
      if (a >= ns) matrix.middleRows<2>(2 * a) += w * pressure * foot.derivative[0][m] * geometry.normal * foot_shift;
    }
    force(last) -= own_formulation_test::stiffness * w * (touches ? result.gap : z);
    if (touches)
      matrix.row(last) -= own_formulation_test::stiffness * w * gap;
    else
      matrix(last, last) -= own_formulation_test::stiffness * w;

    result.state = touches ? ContactState::stick : ContactState::open;
    result.pressure = pressure;
    result.area = w;
    result.force = w * pressure * geometry.normal;
  }
};

contact::FormulationFactory<2> element_pressures() {
  return [](contact::ContactSetting<2> setting) { return std::make_unique<ElementPressures>(std::move(setting)); };
}

enum Grips { floor, lid };

/// Two stacked blocks with free sides. If both are equally wide, two slave elements lie on each master element, so that
/// the integrals are exact.
Scene<2> blocks(const solid::Material& material, double width) {
  Scene<2> scene;
  scene.bodies.push_back(
      {"lower", make_body(nurbs::rectangle(2, 1, Eigen::Vector2d(0, 0)), {3, 2}, "N2", "north", material)});
  scene.bodies.push_back(
      {"upper", make_body(nurbs::rectangle(width, 1, Eigen::Vector2d(0, 1)), {6, 2}, "N2", "south", material)});
  scene.supports = {
      {"floor", {face_points(scene, 0, "south")}, {Constraint::free, Constraint::fixed}},
      {"lid", {face_points(scene, 1, "north")}, {Constraint::free, Constraint::driven}},
      {"left", {face_points(scene, 0, "west"), face_points(scene, 1, "west")}, {Constraint::fixed, Constraint::free}}};
  scene.contacts = {{"between", {1, nurbs::side_of("south", 2)}, FaceReference{0, nurbs::side_of("north", 2)}, {}, 4}};
  scene.contacts[0].own = element_pressures();
  return scene;
}

/// Nominal stress of a block with free sides between smooth plates, with stretch `f` normal to them: P_xx = 0 gives
/// F_xx.
double uniaxial(const solid::Material& material, double f) {
  const auto stress = [&](double g) { return material.stress(Eigen::Vector3d(g, f, 1).asDiagonal().toDenseMatrix()); };
  double low = 1, high = 2;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (stress(middle)(0, 0) > 0 ? high : low) = middle;
  }
  return stress(low)(1, 1);
}

TEST(OwnFormulation, MultipliersMakeTwoBlocksDeformAsOne) {
  const solid::Material material = solid::neo_hookean(1, 0.3);
  Model<2> model(blocks(material, 2));
  EXPECT_EQ(model.system.unknowns.dofs(), model.system.unknowns.displacements() + 6);
  for (double down : {0.1, 0.3, 0.5}) {
    set_target(model, 0, 0, -down);
    const auto report = solve_step(model, {});
    ASSERT_EQ(report.outcome, solve::Outcome::converged) << text_of(report.messages);
    EXPECT_LE(report.iterations, 8);
    accept(model);
    const double exact = uniaxial(material, 1 - down / 2);
    EXPECT_NEAR(reaction(model, lid)(1), 2 * exact, 1e-9);
    for (const auto& point : model.present.contacts[0].results) {
      EXPECT_NEAR(point.pressure, -exact, 1e-9);
      EXPECT_NEAR(point.gap, 0, 1e-12);
    }
  }
  // A roll-back restores the multipliers, too.
  const VectorX before = model.accepted.displacement;
  set_target(model, 0, 0, -0.8);
  solve_step(model, {});
  rollback(model);
  EXPECT_EQ(model.present.displacement, before);
  // After separation the pressures are zero.
  set_target(model, 0, 0, 0.1);
  ASSERT_EQ(solve_step(model, {}).outcome, solve::Outcome::converged);
  accept(model);
  EXPECT_NEAR(reaction(model, lid).norm(), 0, 1e-10);
  EXPECT_NEAR(model.accepted.displacement.tail<6>().norm(), 0, 1e-12);
}

TEST(OwnFormulation, TangentIsTheResidualsDerivative) {
  nurbs::test::Random random(4);
  Bench bench(blocks(solid::neo_hookean(1, 0.3), 1.5));
  int compared = 0, touching = 0;
  for (int trial = 0; trial < 8; ++trial) {
    VectorX u(bench.unknowns.dofs());
    for (int i = 0; i < u.size(); ++i) u(i) = nurbs::test::uniform(random, -0.02, 0.02);
    for (int i = 0; i < 6; ++i) u(u.size() - 1 - i) = nurbs::test::uniform(random, -0.02, 0.05); // z
    compared += compare(bench, u);
    touching += resultant(bench.present.contacts[0]).active > 0;
  }
  EXPECT_GE(compared, 4);
  EXPECT_GE(touching, 4);
}

TEST(OwnFormulation, CannotBeSaved) {
  Model<2> model(blocks(solid::neo_hookean(1, 0.3), 2));
  EXPECT_ERROR(content(model, snapshot(model)), "model.archive.own_formulation");
}

} // namespace own_formulation_test
} // namespace signorini::model
