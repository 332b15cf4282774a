#include "solve/linear.hpp"

#include "base/error.hpp"
#include "solve/band_order.hpp"
#include "solve/banded.hpp"
#include "solve/cholesky.hpp"
#include "solve/condensed.hpp"
#include "solve/values.hpp"

#include <klu.h>
#include <umfpack.h>

#include <algorithm>
#include <utility>

namespace signorini::solve {

namespace {

constexpr std::pair<LinearKind, const char*> names[] = {
    {LinearKind::automatic, "auto"},  {LinearKind::klu, "klu"},       {LinearKind::umfpack, "umfpack"},
    {LinearKind::cholmod, "cholmod"}, {LinearKind::banded, "banded"}, {LinearKind::condensed, "condensed"}};

/// KLU (Davis & Palamadai Natarajan, ACM TOMS 37, 2010): a refactorisation keeps the pivots of the last full one and
/// costs a fraction of it; growth of the factors tells when the pivots no longer fit.
class Klu final : public LinearSolver {
public:
  explicit Klu(const Pattern& pattern) : pattern_(pattern), right_(static_cast<std::size_t>(pattern.size)) {
    klu_defaults(&common_);
    common_.btf = 0;      // the tangent is structurally symmetric and irreducible
    common_.ordering = 0; // approximate minimum degree
    common_.scale = -1;   // none: pivots are compared within a column, where the entries are of one kind
    symbolic_ = klu_analyze(pattern_.size, pattern_.starts.data(), pattern_.rows.data(), &common_);
    require(symbolic_ != nullptr || pattern_.size == 0, "the sparse solver could not analyse the tangent (KLU status ",
            common_.status, ")");
  }
  ~Klu() override {
    klu_free_numeric(&numeric_, &common_);
    klu_free_symbolic(&symbolic_, &common_);
  }

  bool factor(const double* values) override {
    values_ = const_cast<double*>(values); // KLU reads the values only
    refactored_ = numeric_ &&
                  klu_refactor(pattern_.starts.data(), pattern_.rows.data(), values_, symbolic_, numeric_, &common_) &&
                  common_.status == KLU_OK && regular();
    return refactored_ || factor_with_pivots();
  }

  bool solve(double* b) override {
    if (refactored_) {
      // Kept pivots can be bad ones for the new values: then K x = b is missed, and new pivots are taken.
      std::copy_n(b, pattern_.size, right_.data());
      if (!klu_solve(symbolic_, numeric_, pattern_.size, 1, b, &common_)) return false;
      if (relative_residual(pattern_, values_, b, right_.data(), difference_) <= 1e-8) return true;
      std::copy(right_.begin(), right_.end(), b);
      if (!factor_with_pivots()) return false;
    }
    return klu_solve(symbolic_, numeric_, pattern_.size, 1, b, &common_);
  }
  LinearKind kind() const override { return LinearKind::klu; }

private:
  bool factor_with_pivots() {
    refactored_ = false;
    klu_free_numeric(&numeric_, &common_);
    numeric_ = klu_factor(pattern_.starts.data(), pattern_.rows.data(), values_, symbolic_, &common_);
    return numeric_ != nullptr && common_.status == KLU_OK && regular();
  }

  bool regular() { return klu_rcond(symbolic_, numeric_, &common_) && common_.rcond > least_pivot; }

  Pattern pattern_;
  std::vector<double> right_, difference_;
  double* values_ = nullptr;
  bool refactored_ = false;
  klu_common common_{};
  klu_symbolic* symbolic_ = nullptr;
  klu_numeric* numeric_ = nullptr;
};

/// UMFPACK (Davis, ACM TOMS 30, 2004). Its analysis looks at values too, so it waits for the first real matrix.
class Umfpack final : public LinearSolver {
public:
  explicit Umfpack(const Pattern& pattern) : pattern_(pattern), scratch_(static_cast<std::size_t>(pattern.size)) {
    umfpack_di_defaults(control_);
    control_[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC; // the pattern is symmetric
    control_[UMFPACK_ORDERING] = UMFPACK_ORDERING_METIS;
    control_[UMFPACK_IRSTEP] = 0;
  }
  ~Umfpack() override {
    umfpack_di_free_numeric(&numeric_);
    umfpack_di_free_symbolic(&symbolic_);
  }

  bool factor(const double* values) override {
    values_ = values;
    const int *starts = pattern_.starts.data(), *rows = pattern_.rows.data();
    if (!symbolic_) {
      const int status =
          umfpack_di_symbolic(pattern_.size, pattern_.size, starts, rows, values, &symbolic_, control_, nullptr);
      require(status == UMFPACK_OK, "the sparse solver could not analyse the tangent (UMFPACK status ", status, ")");
    }
    umfpack_di_free_numeric(&numeric_);
    double info[UMFPACK_INFO];
    return umfpack_di_numeric(starts, rows, values, symbolic_, &numeric_, control_, info) == UMFPACK_OK &&
           info[UMFPACK_RCOND] > least_pivot;
  }

  bool solve(double* b) override {
    const int status = umfpack_di_solve(UMFPACK_A, pattern_.starts.data(), pattern_.rows.data(), values_,
                                        scratch_.data(), b, numeric_, control_, nullptr);
    std::copy(scratch_.begin(), scratch_.end(), b);
    return status == UMFPACK_OK;
  }
  LinearKind kind() const override { return LinearKind::umfpack; }

private:
  Pattern pattern_;
  std::vector<double> scratch_;
  const double* values_ = nullptr;
  double control_[UMFPACK_CONTROL];
  void* symbolic_ = nullptr;
  void* numeric_ = nullptr;
};

} // namespace

LinearKind linear_kind(const std::string& name) {
  std::string known;
  for (const auto& [kind, kind_name] : names) {
    if (name == kind_name) return kind;
    known += text(known.empty() ? "'" : ", '", kind_name, "'");
  }
  fail("linear: unknown solver '", name, "'; known are ", known);
}

std::string name_of(LinearKind kind) {
  for (const auto& [known, name] : names)
    if (kind == known) return name;
  return "";
}

LinearKind symmetric_choice(const Pattern& pattern) {
  const double width = band_width(pattern, band_order(pattern));
  return width * width <= 4.0 * pattern.size ? LinearKind::banded : LinearKind::cholmod;
}

std::unique_ptr<LinearSolver> make_solver(LinearKind kind, const Pattern& pattern, const Condensation* condensation) {
  if (kind == LinearKind::automatic) kind = pattern.size <= klu_limit ? LinearKind::klu : LinearKind::umfpack;
  if (kind == LinearKind::klu) return std::make_unique<Klu>(pattern);
  if (kind == LinearKind::umfpack) return std::make_unique<Umfpack>(pattern);
  if (kind == LinearKind::cholmod) return make_cholesky(pattern);
  if (kind == LinearKind::banded) return make_banded(pattern);
  require(condensation != nullptr, "linear: the solver 'condensed' needs a matrix that is constant but for contact, as "
                                   "bodies that are all linear elastic have; take 'auto'");
  return make_condensed(pattern, *condensation);
}

} // namespace signorini::solve
