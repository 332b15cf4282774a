#include "contact/method/method.hpp"

#include "base/error.hpp"

#include <utility>

namespace signorini::contact {

template <int D> std::unique_ptr<Formulation<D>> make_formulation(const Method& method, ContactSetting<D> setting) {
  const auto& [law, multipliers, pass, bond, unknown] = method;
  const bool solved = law.enforcement == Enforcement::multipliers;
  if (setting.master.set()) {
    require(!multipliers && !bond, "contact.set.points");
    require(!law.coefficient || !law.coefficient->of_cosine, "contact.set.cosine");
  }
  // Where penetrations vanish, nothing makes the pressures of the two faces equal.
  require(!solved || pass == Pass::full, "contact.enforcement.half_passes");
  require(!solved || has_penalty(law), "contact.enforcement.pressure");
  if (bond) return std::make_unique<CohesiveContact<D>>(setting, law, *bond);
  require(!solved || multipliers, "contact.enforcement.points");
  if (solved) return std::make_unique<MultiplierContact<D>>(std::move(setting), law, *multipliers, unknown);
  if (multipliers) return std::make_unique<MortarContact<D>>(setting, law, *multipliers, pass);
  return std::make_unique<GaussPointContact<D>>(std::move(setting), law, pass);
}

template std::unique_ptr<Formulation<2>> make_formulation(const Method&, ContactSetting<2>);
template std::unique_ptr<Formulation<3>> make_formulation(const Method&, ContactSetting<3>);

} // namespace signorini::contact
