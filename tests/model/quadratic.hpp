#pragma once
// Newton's method on a model converges quadratically: measured from starts that the test makes.

#include "model/arc.hpp"
#include "model/load_step.hpp"
#include "model/results.hpp"
#include "told.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace signorini::model::test {

/// States of all contact points and the elements that they lie in: where these are the same, the residual is a smooth
/// function of the displacement.
template <int D> std::vector<int> smooth_piece(const Model<D>& model) {
  std::vector<int> result;
  for (std::size_t k = 0; k < model.system.contacts.size(); ++k) {
    for (const auto& point : model.present.contacts[k].results) result.push_back(static_cast<int>(point.state));
    for (const auto& block : model.system.contacts[k]->blocks())
      result.insert(result.end(), {block.slave_element, block.master_element, block.slip_element});
  }
  return result;
}

/// Call it after a step that has converged, before it is accepted. Starts Newton's method at u + h d, u the solution
/// and d half as the step went, half as u itself, so that gaps and slips change, and looks at the residual r(h) after
/// one iteration: it is of order h² with the consistent tangent, of order h with any other. h is 1/8, 1/64 …
/// 1/32768; left out are those where contact points change their states or elements on the way. Rounding error adds
/// some ε |K| |x|. Returns how many pairs of h were compared; the solution is restored.
template <int D> int compare_starts(Model<D>& model) {
  const VectorX whole = model.system.unknowns.gather(model.present.displacement),
                last = whole - model.system.unknowns.gather(model.accepted.displacement);
  const VectorX direction = last + last.norm() / whole.norm() * whole;
  Message why;
  const auto piece = [&] {
    EXPECT_EQ(evaluate(model, why), solve::Outcome::converged) << bare_text(why);
    return smooth_piece(model);
  };
  const std::vector<int> solution = piece();
  double stiffness = model.system.assembly.diagonal_norm(),
         position = model.present.displacement.template lpNorm<Eigen::Infinity>();
  for (std::size_t k = 0; k < model.system.contacts.size(); ++k)
    stiffness = std::max(stiffness, model.system.contacts[k]->stiffness(model.present.contacts[k], 1));
  for (const auto& body : model.system.scene.bodies)
    position = std::max(position, body.body->space().points().cwiseAbs().maxCoeff());
  const double rounding = std::numeric_limits<double>::epsilon() * stiffness * position;

  constexpr double factor = 8, least = 32; // of 64, what r(h) falls by
  constexpr int sizes = 5;
  StepOptions exact; // linear solutions: an iterative solver's tolerance is no part of this
  exact.linear = solve::LinearKind::umfpack;
  int pairs = 0;
  double before = 0; // r(8 h), 0 where its piece is another one
  for (int k = 1; k <= sizes; ++k) {
    const double h = std::pow(factor, -k);
    move_by(model, h * direction);
    const bool begins = piece() == solution;
    iterate(model, exact);
    const bool same = piece() == solution && begins;
    const double after = model.unbalanced.norm();
    const solve::NewtonReport back = solve_step(model, exact);
    EXPECT_EQ(back.outcome, solve::Outcome::converged) << told(back.messages);
    if (same && before > 0) {
      EXPECT_LT(after, before / least + 30 * rounding) << "h = " << h;
      ++pairs;
    }
    before = same ? after : 0;
  }
  return pairs;
}

} // namespace signorini::model::test
