#include "model/steps/linear_solution.hpp"

#include "base/error.hpp"
#include "os/interrupt.hpp"
#include "solve/condensed.hpp"
#include "solve/values.hpp"

#include <algorithm>

namespace signorini::model {

namespace {

/// Relative residual at which a refined solution counts as that of its own factors, and that of each correction.
constexpr double refined_residual = 1e-12, refinement_tolerance = 1e-6;
constexpr int most_refinements = 5;

/// Sums of the statistics of two successive solvers; size and cost are those of the later one.
solve::SolverStatistics sum(const solve::SolverStatistics& before, const solve::SolverStatistics& now) {
  solve::SolverStatistics result = now;
  result.factorizations += before.factorizations;
  result.solutions += before.solutions;
  result.iterations += before.iterations;
  return result;
}

/// Constant factors of the bodies suit a tangent of which only the contacts' part changes; damping changes the rest.
bool can_condense(const LinearFacts& facts, bool damps) {
  return !damps && facts.constant_bulk;
}

} // namespace

template <int D> LinearFacts linear_facts(const System<D>& system) {
  const Scene<D>& scene = system.scene;
  const bool linear = std::ranges::all_of(scene.bodies, [](const auto& named) { return named.body->linear(); });
  const bool potential =
      std::ranges::all_of(system.contacts, [](const auto& contact) { return contact->has_potential(); });
  const bool multipliers =
      std::ranges::any_of(system.contacts, [](const auto& contact) { return contact->extra_unknowns() > 0; });
  return {linear && system.followers.empty() && !(scene.contacts.empty() && scene.ties.empty()), multipliers,
          potential && system.followers.conservative()};
}

solve::LinearKind first_choice(const LinearFacts& facts, bool damps) {
  if (can_condense(facts, damps)) return solve::LinearKind::condensed;
  return facts.potential ? solve::LinearKind::reuse : solve::LinearKind::automatic;
}

solve::LinearSolver& LinearSolution::solver(const Tangent& tangent, const LinearRequest& request) {
  const bool open = request.kind == solve::LinearKind::automatic;
  const bool condense = (open || request.kind == solve::LinearKind::condensed) && can_condense(facts_, request.damps);
  require(condense || request.kind != solve::LinearKind::condensed, "model.linear.condensed");
  // A solver with constant factors of the bodies cannot take damping into account, and reused factors of a damped
  // tangent would hide that the one without damping is singular.
  const bool same = solver_ && last_.kind == request.kind && last_.mumps == request.mumps &&
                    condense == (solver_->kind() == solve::LinearKind::condensed) &&
                    (last_.damps == request.damps || solver_->kind() != solve::LinearKind::reuse);
  const bool same_contacts = contact_version_ == tangent.contact_version;
  // A solver may survive a growing pattern, but constant factors have other contact unknowns within them.
  const bool fits = same && (!condense || same_contacts) &&
                    (pattern_version_ == tangent.pattern_version || solver_->adopt(tangent.pattern));
  if (!fits) {
    forget();
    if (condense) {
      const auto& values = tangent.constant;
      const solve::Condensation condensation{{values.begin(), values.begin() + tangent.pattern.entries()},
                                             tangent.contact_unknowns};
      solver_ = solve::make_solver(solve::LinearKind::condensed, tangent.pattern, {&condensation});
    } else {
      const solve::LinearKind kind = open ? first_choice(facts_, request.damps) : request.kind;
      solver_ = solve::make_solver(kind == solve::LinearKind::automatic ? beginning_ : kind, tangent.pattern,
                                   {.multipliers = facts_.multipliers, .mumps = request.mumps});
    }
  }
  if (!fits || !same_contacts) solver_->watch(tangent.contact_unknowns);
  pattern_version_ = tangent.pattern_version;
  contact_version_ = tangent.contact_version;
  last_ = request;
  return *solver_;
}

bool LinearSolution::factor(const Tangent& tangent, const LinearRequest& request) {
  if (tangent.pattern.size == 0) return true;
  const Factorization scope(tangent.pattern.size); // and the analysis before it
  return solver(tangent, request).factor(tangent.values.data());
}

bool LinearSolution::solve(VectorX& b, bool fully) {
  if (b.size() == 0) return true;
  return solver_->solve(b.data(), fully);
}

bool LinearSolution::solve_near(const Tangent& tangent, VectorX& b) {
  VectorX x = VectorX::Zero(b.size()), correction = b;
  std::vector<double> rest;
  for (int pass = 0; pass < most_refinements; ++pass) {
    if (!is_ready() || !solve_aside(correction, refinement_tolerance)) return false;
    x += correction;
    if (solve::relative_residual(tangent.pattern, tangent.values.data(), x.data(), b.data(), rest) <=
        refined_residual) {
      b = x;
      return true;
    }
    correction = Eigen::Map<const VectorX>(rest.data(), b.size());
  }
  return false;
}

bool LinearSolution::proves_definite(const Tangent& tangent) const {
  return solver_ && pattern_version_ == tangent.pattern_version && contact_version_ == tangent.contact_version &&
         solver_->proves_definite(tangent.values.data());
}

void LinearSolution::forget() {
  if (!solver_) return;
  past_ = sum(past_, solver_->statistics());
  past_kind_ = solver_->kind();
  if (last_.kind == solve::LinearKind::automatic && past_kind_ == solve::LinearKind::reuse) beginning_ = past_kind_;
  solver_.reset();
}

solve::SolverStatistics LinearSolution::statistics() const {
  return solver_ ? sum(past_, solver_->statistics()) : past_;
}

template LinearFacts linear_facts(const System<2>&);
template LinearFacts linear_facts(const System<3>&);

} // namespace signorini::model
