#include "model/stability/modes.hpp"

#include "base/error.hpp"
#include "model/constants.hpp"
#include "model/stability/inertia.hpp"
#include "model/stability/mass_matrix.hpp"
#include "model/stability/rigid_modes.hpp"
#include "model/stability/subspace_iteration.hpp"
#include "model/steps/equilibrium.hpp"
#include "os/interrupt.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::model {

namespace {

template <int D> Eigenproblem eigenproblem_of(Model<D>& model) {
  System<D>& system = model.system;
  Message why;
  const solve::Outcome outcome = evaluate(model, {.initial = {gap_rounding * largest_position(model)}}, why);
  const SparseTangent& tangent = system.assembly.tangent();
  Eigenproblem problem{tangent.pattern, tangent.values, {}};
  rollback(model);
  require(outcome == solve::Outcome::converged, "model.step.no_residual", {{"why", why}});
  problem.symmetric = solve::is_symmetric(problem.pattern, problem.stiffness.data());
  problem.mass = mass_matrix(system.scene, system.unknowns, problem.pattern);
  // An obstacle that nothing holds does not move.
  double largest = 0;
  for (int i = 0; i < problem.pattern.size; ++i)
    largest = std::max(largest, std::abs(problem.stiffness[problem.pattern.find(i, i)]));
  for (const UnconstrainedObstacle& motion : system.unconstrained_obstacles()) {
    const int i = system.unknowns.unknown(motion.dof);
    problem.stiffness[problem.pattern.find(i, i)] += neutral_stiffness * largest;
  }
  return problem;
}

/// The search for modes of one state.
template <int D> class Search {
public:
  Search(Model<D>& model, Eigenproblem problem)
      : model_(model), problem_(std::move(problem)),
        kind_(model.linear.kind() == solve::LinearKind::mumps ? solve::LinearKind::mumps : solve::LinearKind::umfpack) {
    for (double& value : magnitudes_ = problem_.stiffness) value = std::abs(value);
    for (int i = 0; i < system().unknowns.free_displacements(); ++i) {
      const auto k = static_cast<std::size_t>(problem_.pattern.find(i, i));
      if (problem_.mass[k] > 0) highest_ = std::max(highest_, magnitudes_[k] / problem_.mass[k]);
      massive_ += problem_.mass[k] > 0;
    }
  }

  int massive() const { return massive_; }

  /// The Ritz pairs of which the first `count` have converged, by the real part of κ.
  RitzPairs find(int count, int vectors) {
    SubspaceIteration iteration(kind_, problem_, vectors);
    const double below = shift_below();
    advance(iteration, below, estimates, [](const RitzPairs&) { return false; });
    // Far enough below the modes that rigid motions, whose (K − σM)⁻¹ is largest, leave their digits
    const RitzPairs first = by_value(iteration.pairs());
    const auto values = first.values.real();
    Eigen::Index last = count - 1;
    const double spread = values(values.size() - 1) - values(0);
    while (last + 1 < values.size() && values(last) - values(0) <= 1e-6 * spread) ++last;
    const double shift = values(0) - std::max(0.25 * (values(last) - values(0)), -below);
    advance(iteration, shift, most_rounds, [&](const RitzPairs& pairs) { return has_converged(pairs, count); });
    shift_ = shift;
    return by_value(iteration.pairs());
  }

  bool has_converged(const RitzPairs& pairs, int count) const {
    for (int k = 0; k < count; ++k)
      if (!(pairs.errors(k) <= std::max(accuracy, rounding(pairs, k) / distance(pairs, k)))) return false;
    return true;
  }

  /// True if κ is zero up to rounding error.
  bool is_neutral(const RitzPairs& pairs, Eigen::Index k) const {
    return std::abs(pairs.values(k)) <= rounding(pairs, k);
  }

  /// κ, real where its imaginary part is below the error.
  std::complex<double> value(const RitzPairs& pairs, Eigen::Index k) const {
    const std::complex<double> value = pairs.values(k);
    return std::abs(value.imag()) <= accuracy * distance(pairs, k) ? value.real() : value;
  }

  /// True if the symmetric part of K is positive definite, but for motions without stiffness.
  bool is_definite_at(double shift) const {
    std::vector<double> values = problem_.shifted(shift);
    if (!problem_.symmetric) values = solve::symmetrized(problem_.pattern, std::move(values));
    return is_definite(displacement_stiffness(system(), problem_.pattern, values), kind_);
  }
  bool is_definite_at_zero() const { return is_definite_at(-smallest_shift * highest_); }

  /// Modes that are missing among the first ones, at least `count`: 0 if there is none; nothing if that is undecided.
  std::optional<int> missing(const RitzPairs& pairs, int count) const {
    const auto values = pairs.values.real();
    if (count == massive_) return 0;
    int most = count;
    double gap = 0;
    const auto known = std::min<int>(count + 4, static_cast<int>(values.size()) - 1);
    for (int m = count; m <= known && pairs.errors(m - 1) <= roughly; ++m) {
      const double own = (values(m) - values(m - 1)) / std::max(std::abs(values(m)), std::abs(values(m - 1)));
      if (own > gap) most = m, gap = own;
    }
    if (gap < smallest_gap) return std::nullopt;
    const double between = 0.5 * (values(most - 1) + values(most));
    const auto negative =
        negative_eigenvalues(displacement_stiffness(system(), problem_.pattern, problem_.shifted(between)), kind_);
    if (!negative || *negative < most) return std::nullopt;
    return *negative - most;
  }

  const Eigenproblem& problem() const { return problem_; }

private:
  /// Rounds before the shift is set by the values found.
  static constexpr int estimates = 4, most_rounds = 200;
  /// Largest error of a pair, see RitzPairs, and of pairs next to the last one.
  static constexpr double accuracy = 1e-8, roughly = 1e-3;
  /// Rounding error of κ: multiple of the machine precision of |φ|ᵀ |K| |φ|; of rigid motions it is below 1.
  static constexpr double roundings = 100;
  /// σ relative to the largest K_ii/M_ii at which factors of the stiffness of a free body are definite.
  static constexpr double smallest_shift = 1e-12;
  /// Relative distance of two values between which modes can be counted: above the error of constraint_stiffness.
  static constexpr double smallest_gap = 10 / constraint_stiffness;

  System<D>& system() const { return model_.system; }

  double rounding(const RitzPairs& pairs, Eigen::Index k) const {
    const int displacements = system().unknowns.free_displacements();
    VectorX size = VectorX::Zero(problem_.pattern.size);
    size.head(displacements) = pairs.vectors.col(k).head(displacements).cwiseAbs();
    return roundings * std::numeric_limits<double>::epsilon() *
           size.dot(times(problem_.pattern, magnitudes_, size).col(0));
  }

  double distance(const RitzPairs& pairs, Eigen::Index k) const { return std::abs(pairs.values(k) - shift_); }

  /// A σ < 0 at which the symmetric part of K − σM is positive definite: below all real parts of κ.
  double shift_below() const {
    constexpr double most = 1e4;
    double shift = -smallest_shift * highest_;
    while (!is_definite_at(shift)) {
      shift *= 10;
      require(-shift < most * highest_, "model.modes.obstacle");
    }
    return shift;
  }

  template <class Done> void advance(SubspaceIteration& iteration, double shift, int rounds, const Done& done) {
    shift_ = shift;
    require(iteration.shift(shift), "model.modes.singular");
    for (int round = 0; round < rounds; ++round) {
      require(!interrupted(), "model.modes.interrupted");
      require(iteration.advance(), "model.modes.singular");
      if (done(iteration.pairs())) return;
    }
  }

  static RitzPairs by_value(const RitzPairs& pairs) {
    std::vector<int> order;
    for (int k = 0; k < pairs.values.size(); ++k)
      if (std::isfinite(std::abs(pairs.values(k)))) order.push_back(k);
    std::ranges::stable_sort(order, std::less(), [&](int k) { return pairs.values(k).real(); });
    return {pairs.values(order), pairs.vectors(Eigen::all, order), pairs.errors(order)};
  }

  Model<D>& model_;
  Eigenproblem problem_;
  solve::LinearKind kind_;
  std::vector<double> magnitudes_; ///< |K|
  double highest_ = 0, shift_ = 0; ///< largest K_ii/M_ii, σ
  int massive_ = 0;                ///< unknowns with mass
};

/// The longest displacement of a control point is 1, and the first component about as long as the longest one positive.
template <int D> VectorX scaled(const Unknowns<D>& unknowns, const VectorX& mode) {
  constexpr double about = 0.999;
  VectorX shape = VectorX::Zero(mode.size());
  shape.head(unknowns.free_displacements()) = mode.head(unknowns.free_displacements());
  const double longest =
      unknowns.spread(shape).head(unknowns.obstacles()).reshaped(D, Eigen::AutoSize).colwise().norm().maxCoeff();
  const double largest = shape.lpNorm<Eigen::Infinity>();
  const auto first = std::ranges::find_if(shape, [&](double value) { return std::abs(value) >= about * largest; });
  return shape / (*first > 0 ? longest : -longest);
}

/// Names the rigid motions among the pairs, by pair.
template <int D> std::vector<Message> take_rigid_motions(Model<D>& model, const Search<D>& search, RitzPairs& pairs) {
  std::vector<int> neutral;
  for (int k = 0; k < pairs.values.size(); ++k)
    if (search.is_neutral(pairs, k)) neutral.push_back(k);
  MatrixX motions = pairs.vectors(Eigen::all, neutral);
  const std::vector<Message> names = name_rigid_modes(model, search.problem(), motions);
  pairs.vectors(Eigen::all, neutral) = motions;
  std::vector<Message> all(static_cast<std::size_t>(pairs.values.size()));
  for (std::size_t k = 0; k < names.size(); ++k) all[neutral[k]] = names[k];
  return all;
}

/// True if the last of the first `count` values is complex, and its conjugate one the next.
template <int D> bool splits_pair(const Search<D>& search, const RitzPairs& pairs, int count) {
  int complex_values = 0;
  for (int k = 0; k < count; ++k) complex_values += search.value(pairs, k).imag() != 0;
  return complex_values % 2 != 0;
}

/// Adds the first pairs, sets `stable`, and says what is not known of an unsymmetric tangent.
template <int D> void take(Modes& modes, Model<D>& model, const Search<D>& search, RitzPairs& pairs, int count) {
  const std::vector<Message> names = take_rigid_motions(model, search, pairs);
  bool grows = false, neutral = false; // of motions that deform bodies
  for (int k = 0; k < count; ++k) {
    const std::complex<double> value = search.value(pairs, k);
    modes.list.push_back({value, scaled(model.system.unknowns, pairs.vectors.col(k)), names[k]});
    const bool is_neutral = search.is_neutral(pairs, k);
    grows = grows || (!is_neutral && (value.real() < 0 || value.imag() != 0));
    neutral = neutral || (is_neutral && names[k].code.empty());
  }
  if (grows) modes.stable = false;
  if (!grows && !neutral && search.is_definite_at_zero()) modes.stable = true;
  if (!modes.symmetric)
    modes.warnings.emplace_back(modes.stable == true ? "model.modes.flutter" : "model.modes.unsymmetric");
}

} // namespace

template <int D> Modes free_modes(Model<D>& model, int count) {
  constexpr int extra = 8;
  require(settled(model), "model.modes.pending");
  Search<D> search(model, eigenproblem_of(model));
  count = std::min(count, search.massive());
  require(count > 0, "model.modes.none");
  Modes modes{{}, search.problem().symmetric, {}, {}, {}};
  RitzPairs pairs;
  std::optional<int> missing;
  for (int vectors = count + extra, tries = 0; tries < 2; ++tries) {
    pairs = search.find(count, std::min(vectors, search.massive()));
    count = std::min(count, static_cast<int>(pairs.values.size()));
    if (count < pairs.values.size() && splits_pair(search, pairs, count)) ++count;
    if (!search.has_converged(pairs, count))
      modes.warnings.push_back(Message("model.modes.accuracy", {{"error", pairs.errors.head(count).maxCoeff()}}));
    missing = modes.symmetric ? search.missing(pairs, count) : std::nullopt;
    if (!missing || missing == 0) break;
    vectors += 2 * *missing + extra;
  }
  if (missing) modes.complete = missing == 0;
  if (modes.symmetric && !modes.complete) modes.warnings.emplace_back("model.modes.uncounted");
  if (modes.complete == false) modes.warnings.push_back(Message("model.modes.missing", {{"count", *missing}}));
  take(modes, model, search, pairs, count);
  if (model.system.scene.kind == solid::Kind::axisymmetric) modes.warnings.emplace_back("model.modes.axisymmetric");
  return modes;
}

template Modes free_modes(Model<2>&, int);
template Modes free_modes(Model<3>&, int);

} // namespace signorini::model
