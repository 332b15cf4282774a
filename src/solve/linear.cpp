#include "solve/linear.hpp"

#include "base/error.hpp"
#include "solve/automatic.hpp"
#include "solve/band_order.hpp"
#include "solve/banded.hpp"
#include "solve/cholesky.hpp"
#include "solve/condensed.hpp"
#include "solve/kept.hpp"
#include "solve/klu.hpp"
#include "solve/umfpack.hpp"

#include <utility>

namespace signorini::solve {

namespace {

constexpr std::pair<LinearKind, const char*> names[] = {
    {LinearKind::automatic, "auto"},  {LinearKind::klu, "klu"},       {LinearKind::umfpack, "umfpack"},
    {LinearKind::cholmod, "cholmod"}, {LinearKind::banded, "banded"}, {LinearKind::condensed, "condensed"},
    {LinearKind::kept, "kept"}};

} // namespace

std::vector<std::string> linear_names() {
  std::vector<std::string> all;
  for (const auto& [kind, name] : names) all.emplace_back(name);
  return all;
}

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
  if (kind == LinearKind::automatic) return make_automatic(pattern);
  if (kind == LinearKind::klu) return make_klu(pattern);
  if (kind == LinearKind::umfpack) return make_umfpack(pattern);
  if (kind == LinearKind::kept) return make_kept(pattern);
  if (kind == LinearKind::cholmod) return make_cholesky(pattern);
  if (kind == LinearKind::banded) return make_banded(pattern);
  require(condensation != nullptr, "linear: the solver 'condensed' needs a matrix that is constant but for contact, as "
                                   "bodies that are all linear elastic have; take 'auto'");
  return make_condensed(pattern, *condensation);
}

} // namespace signorini::solve
