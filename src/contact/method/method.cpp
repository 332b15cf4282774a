#include "contact/method/method.hpp"

#include "base/error.hpp"
#include "contact/gauss/adhesive_contact.hpp"
#include "contact/gauss/penalty_contact.hpp"
#include "contact/mortar/multiplier_contact.hpp"

#include <utility>

namespace signorini::contact {

namespace {

template <int D> std::unique_ptr<Formulation<D>> make(const PenaltyLaw& law, ContactSetting<D> setting) {
  require(law.enforcement != Enforcement::multipliers, "contact.enforcement.points");
  return std::make_unique<PenaltyContact<D>>(std::move(setting), law);
}

template <int D> std::unique_ptr<Formulation<D>> make(const Adhesion& law, ContactSetting<D> setting) {
  return std::make_unique<AdhesiveContact<D>>(std::move(setting), law);
}

template <int D> std::unique_ptr<Formulation<D>> make(const MortarLaw& law, ContactSetting<D> setting) {
  if (law.penalty.enforcement == Enforcement::multipliers)
    return std::make_unique<MultiplierContact<D>>(std::move(setting), law);
  return std::make_unique<MortarContact<D>>(setting, law);
}

template <int D> std::unique_ptr<Formulation<D>> make(const HalfPass& pass, ContactSetting<D> setting) {
  // Where penetrations vanish, nothing makes the pressures of the two faces equal.
  require(pass.penalty.enforcement == Enforcement::penalty, "contact.enforcement.half_passes");
  if (pass.multipliers)
    return std::make_unique<MortarContact<D>>(setting, MortarLaw{pass.penalty, *pass.multipliers}, Pass::half);
  return std::make_unique<PenaltyContact<D>>(std::move(setting), pass.penalty, Pass::half);
}

template <int D> std::unique_ptr<Formulation<D>> make(const CohesiveLaw& law, ContactSetting<D> setting) {
  return std::make_unique<CohesiveContact<D>>(setting, law);
}

template <int D> std::unique_ptr<Formulation<D>> make(const FormulationFactory<D>& factory, ContactSetting<D> setting) {
  return factory(std::move(setting));
}

} // namespace

template <int D> std::unique_ptr<Formulation<D>> make_formulation(const Method<D>& method, ContactSetting<D> setting) {
  return std::visit([&](const auto& chosen) { return make<D>(chosen, std::move(setting)); }, method);
}

template std::unique_ptr<Formulation<2>> make_formulation(const Method<2>&, ContactSetting<2>);
template std::unique_ptr<Formulation<3>> make_formulation(const Method<3>&, ContactSetting<3>);

} // namespace signorini::contact
