#include "model/stability/inertia.hpp"

#include "solve/definite.hpp"

#include <algorithm>

namespace signorini::model {

namespace {

/// The sizes of multipliers that displacement_stiffness() lumps: those of contacts whose multipliers are unknowns.
template <int D> std::vector<int> multiplier_sizes(const System<D>& system) {
  std::vector<int> sizes(system.unknowns.dofs() - system.unknowns.displacements(), 0);
  for (std::size_t k = 0; k < system.contacts.size(); ++k) {
    const auto& law = system.contacts[k]->parameters().law;
    if (!law || law->enforcement != contact::Enforcement::multipliers) continue;
    const auto first = sizes.begin() + (system.unknowns.of_contact(k).extra - system.unknowns.displacements());
    std::fill_n(first, system.contacts[k]->extra_unknowns(), contact::may_rub(*law) ? D : 1);
  }
  return sizes;
}

} // namespace

template <int D>
Stiffness displacement_stiffness(const System<D>& system, const solve::Pattern& pattern,
                                 const std::vector<double>& values) {
  return displacement_stiffness(pattern, values, system.unknowns.free_displacements(), multiplier_sizes(system));
}

std::optional<int> negative_eigenvalues(const Stiffness& k, solve::LinearKind kind) {
  if (kind != solve::LinearKind::mumps) return solve::negative_eigenvalues(k.pattern, k.values);
  const auto solver = solve::make_solver(kind, k.pattern);
  if (!solver->factor(k.values.data()) || solver->statistics().negative < 0) return std::nullopt;
  return solver->statistics().negative;
}

bool is_definite(const Stiffness& k, solve::LinearKind kind) {
  if (kind == solve::LinearKind::mumps) return negative_eigenvalues(k, kind) == 0;
  return solve::is_positive_definite(k.pattern, k.values);
}

template Stiffness displacement_stiffness(const System<2>&, const solve::Pattern&, const std::vector<double>&);
template Stiffness displacement_stiffness(const System<3>&, const solve::Pattern&, const std::vector<double>&);

} // namespace signorini::model
