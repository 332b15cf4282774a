#pragma once
// Measurement of the quadratic convergence of Newton's method on a model, from starts made by the test.

#include "model/results/results.hpp"
#include "model/steps/arc.hpp"
#include "model/steps/equilibrium.hpp"
#include "model/steps/load_step.hpp"
#include "text_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace signorini::model::test {

/// States and elements of all contact points; as long as they do not change, the residual is a smooth function of the
/// displacement.
template <int D> std::vector<int> smooth_piece(const Model<D>& model) {
  std::vector<int> result;
  for (std::size_t k = 0; k < model.system.contacts.size(); ++k) {
    for (const auto& point : model.present.contacts[k].results) result.push_back(static_cast<int>(point.state));
    for (const auto& multiplier : model.present.contacts[k].multiplier_results)
      result.push_back(static_cast<int>(multiplier.state));
    for (const auto& block : model.system.contacts[k]->blocks())
      result.insert(result.end(), {block.slave_element, block.master_element, block.slip_element});
  }
  return result;
}

/// To be called after a step has converged, before it is accepted. Starts Newton's method at u + h d, u the solution
/// and d the mean of the step's increment and u, so that gaps and slips change, and checks the residual r(h) after one
/// iteration: it is of order h² with the consistent tangent, of order h with any other. h is 1/8, 1/64 … 1/32768,
/// without those where contact points change their states or elements. Rounding error adds about ε |K| |x|. Returns the
/// number of pairs of h compared; restores the solution.
template <int D> int compare_starts(Model<D>& model) {
  const VectorX whole = model.system.unknowns.gather(model.present.displacement),
                last = whole - model.system.unknowns.gather(model.accepted.displacement);
  const VectorX direction = last + last.norm() / whole.norm() * whole;
  Message why;
  const auto piece = [&] {
    EXPECT_EQ(evaluate(model, {}, why), solve::Outcome::converged) << bare_text(why);
    return smooth_piece(model);
  };
  const std::vector<int> solution = piece();
  double stiffness = model.system.assembly.tangent().diagonal_norm,
         position = model.present.displacement.template lpNorm<Eigen::Infinity>();
  for (std::size_t k = 0; k < model.system.contacts.size(); ++k)
    stiffness = std::max(stiffness, model.system.contacts[k]->stiffness(model.present.contacts[k], 1));
  for (const auto& body : model.system.scene.bodies)
    position = std::max(position, body.body->space().points().cwiseAbs().maxCoeff());
  const double rounding = std::numeric_limits<double>::epsilon() * stiffness * position;

  constexpr double factor = 8, least = 32; // least reduction of r(h), which is 64 in theory
  constexpr int sizes = 5;
  StepOptions exact; // direct linear solver, without the tolerance of an iterative one
  exact.linear = solve::LinearKind::umfpack;
  int pairs = 0;
  double before = 0; // r(8 h), 0 if its discrete state differs
  for (int k = 1; k <= sizes; ++k) {
    const double h = std::pow(factor, -k);
    move_by(model, h * direction);
    const bool begins = piece() == solution;
    iterate(model, exact);
    const bool same = piece() == solution && begins;
    const double after = model.unbalanced.norm();
    const solve::NewtonReport back = solve_step(model, exact);
    EXPECT_EQ(back.outcome, solve::Outcome::converged) << text_of(back.messages);
    if (same && before > 0) {
      EXPECT_LT(after, before / least + 30 * rounding) << "h = " << h;
      ++pairs;
    }
    before = same ? after : 0;
  }
  return pairs;
}

} // namespace signorini::model::test
