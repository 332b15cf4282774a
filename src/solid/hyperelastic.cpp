#include "solid/hyperelastic.hpp"

#include "base/dense.hpp"
#include "base/error.hpp"
#include "solid/energy.hpp"
#include "solid/kernel_wide.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace signorini::solid {

namespace {

/// Formulas of the energy and of its first and second derivatives, in this order; the second ones for v ≤ w, row by
/// row.
std::vector<int> with_derivatives(symbolic::Graph& graph, int energy) {
  const int count = std::ssize(graph.variables());
  std::vector<int> all{energy};
  for (int v = 0; v < count; ++v) all.push_back(symbolic::derivative(graph, energy, v));
  for (int v = 0; v < count; ++v)
    for (int w = v; w < count; ++w) all.push_back(symbolic::derivative(graph, all[v + 1], w));
  return all;
}

EnergyProgram program_of(const Energy& energy) {
  const symbolic::Tape& tape = energy.derivatives;
  EnergyProgram program{};
  program.code = tape.code.data();
  program.registers = tape.registers;
  program.invariants = energy.variables;
  program.slopes_end = tape.ends[energy.variables - 1];
  program.curvatures_end = tape.ends.back();
  program.fibers = energy.formula.fibers.empty() ? nullptr : energy.formula.fibers.front().data();
  std::size_t next = 0;
  for (int v = 0; v < energy.variables; ++v) program.slopes[v] = tape.outputs[next++];
  for (int v = 0; v < energy.variables; ++v)
    for (int w = v; w < energy.variables; ++w)
      program.curvatures[v][w] = program.curvatures[w][v] = tape.outputs[next++];
  return program;
}

std::vector<double> invariants(const EnergyFormula& formula, const Mat<3>& f) {
  const Mat<3> c = f.transpose() * f;
  const double trace = c.trace();
  std::vector<double> values{trace, 0.5 * (trace * trace - c.squaredNorm()), f.determinant()};
  for (const Vec<3>& fiber : formula.fibers) values.push_back((f * fiber).squaredNorm());
  return values;
}

void check(const EnergyFormula& formula) {
  require(formula.fibers.size() <= most_fibers, "solid.energy.fibers",
          {{"count", formula.fibers.size()}, {"most", most_fibers}});
  for (std::size_t i = 0; i < formula.fibers.size(); ++i)
    require(formula.fibers[i].allFinite() && formula.fibers[i].norm() > 0, "solid.energy.direction",
            {{"number", i + 1}});
}

/// Throws Error unless the energy has the same value for all orders of the stretches.
void check_symmetry(const Energy& energy) {
  const std::vector<double> stretches{1.3, 0.9, 1.1};
  const double expected = symbolic::evaluate(energy.value, stretches).front();
  for (const std::vector<double>& order : {std::vector{0.9, 1.3, 1.1}, {1.3, 1.1, 0.9}, {1.1, 0.9, 1.3}}) {
    const double value = symbolic::evaluate(energy.value, order).front();
    require(std::abs(value - expected) <= 1e-10 * (std::abs(expected) + std::abs(value)), "solid.energy.asymmetric",
            {{"first", expected}, {"stretches", stretches}, {"second", value}, {"order", order}});
  }
}

/// The elastic constants at F = I.
ElasticConstants constants_of(const Hyperelastic& law) {
  const Mat<3> unit = Mat<3>::Identity(), stress = law.stress(unit);
  const Moduli moduli = law.moduli(unit);
  const double energy = law.energy(unit);
  require(std::isfinite(energy) && stress.allFinite() && moduli.allFinite(), "solid.energy.not_finite",
          {{"energy", energy}});
  require(stress.cwiseAbs().maxCoeff() <= 1e-10 * moduli.cwiseAbs().maxCoeff(), "solid.energy.stress",
          {{"stress", Vec<3>(stress.diagonal())}});
  // The average over all directions: K = c_iijj/9, μ = (3 c_ijij − c_iijj)/30 with c the symmetric part.
  double bulk = 0, shear = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      bulk += moduli(4 * i, 4 * j) / 9;
      shear += (3 * (moduli(3 * i + j, 3 * i + j) + moduli(3 * i + j, 3 * j + i)) / 2 - moduli(4 * i, 4 * j)) / 30;
    }
  const double softest = dense::symmetric_eigenvalues(strain_moduli(moduli))(0);
  require(softest > 1e-12 * moduli.cwiseAbs().maxCoeff(), "solid.energy.moduli", {{"bulk", bulk}, {"shear", shear}});
  return {9 * bulk * shear / (3 * bulk + shear), (3 * bulk - 2 * shear) / (6 * bulk + 2 * shear), bulk - 2 * shear / 3,
          shear};
}

} // namespace

Mat<6> strain_moduli(const Moduli& moduli) {
  constexpr int pairs[][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  return Mat<6>::NullaryExpr([&](Eigen::Index row, Eigen::Index column) -> double {
    const auto [i, k] = pairs[row];
    const auto [j, l] = pairs[column];
    const double sum = moduli(3 * i + k, 3 * j + l) + moduli(3 * k + i, 3 * j + l) + moduli(3 * i + k, 3 * l + j) +
                       moduli(3 * k + i, 3 * l + j);
    return sum / 4 * (row < 3 ? 1 : std::sqrt(2.0)) * (column < 3 ? 1 : std::sqrt(2.0));
  });
}

std::vector<std::string> variable_names(Measure measure, std::size_t fibers) {
  if (measure == Measure::stretches) return {"l1", "l2", "l3"};
  std::vector<std::string> names{"I1", "I2", "J"};
  for (std::size_t i = 0; i < fibers; ++i) names.push_back(text("I", 4 + 2 * i)); // I₅ is a·C² a
  return names;
}

Hyperelastic hyperelastic(EnergyFormula given) {
  check(given);
  std::tie(given.graph, given.energy) = symbolic::reduced(given.graph, given.energy);
  constexpr int most_nodes = 2000; // compilation is recursive
  require(given.graph.size() <= most_nodes, "solid.energy.size", {{"count", given.graph.size()}, {"most", most_nodes}});
  for (Vec<3>& fiber : given.fibers) // those of files are unit vectors already and keep their bits
    if (std::abs(fiber.norm() - 1) > 1e-15) fiber.normalize();
  auto energy = std::make_shared<Energy>(Energy{std::move(given), {}, {}, 0, {}, {}});
  EnergyFormula& formula = energy->formula;
  energy->variables = std::ssize(formula.graph.variables());
  symbolic::Graph derived = formula.graph;
  const std::vector<int> all = with_derivatives(derived, formula.energy);
  energy->value = symbolic::compile(derived, {all.front()}, true);
  energy->derivatives = symbolic::compile(derived, {all.begin() + 1, all.end()}, true);
  if (formula.measure == Measure::invariants) {
    energy->program = program_of(*energy);
    energy->respond[0] = energy_responses<2>().back();
    energy->respond[1] = energy_responses<3>().back();
  } else {
    check_symmetry(*energy);
  }
  Hyperelastic law;
  law.compiled = std::move(energy);
  static_cast<ElasticConstants&>(law) = constants_of(law);
  return law;
}

const EnergyFormula& Hyperelastic::formula() const {
  return compiled->formula;
}

double Hyperelastic::energy(const Mat<3>& f) const {
  const bool by_stretches = formula().measure == Measure::stretches;
  const std::vector<double> variables = by_stretches ? stretches_of(f) : invariants(formula(), f);
  return symbolic::evaluate(compiled->value, variables).front();
}

Mat<3> Hyperelastic::stress(const Mat<3>& f) const {
  return PointResponse<3>(respond<3>, this, f, {}, false).stress();
}

Moduli Hyperelastic::moduli(const Mat<3>& f) const {
  return PointResponse<3>(respond<3>, this, f, {}, true).moduli();
}

template <int D> void Hyperelastic::respond(const void* law, const PointBlock& block) {
  const Energy& energy = *static_cast<const Hyperelastic*>(law)->compiled;
  if (energy.formula.measure == Measure::stretches) return respond_by_stretches<D>(energy, block);
  energy.respond[D - 2](energy.program, block);
}

const Hyperelastic* hyperelastic_law(const Material& material) {
  return material.name() == Hyperelastic::name ? static_cast<const Hyperelastic*>(material.law()) : nullptr;
}

template void Hyperelastic::respond<2>(const void*, const PointBlock&);
template void Hyperelastic::respond<3>(const void*, const PointBlock&);
template Material::Material(Hyperelastic);

} // namespace signorini::solid
