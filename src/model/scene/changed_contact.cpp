#include "model/scene/changed_contact.hpp"

#include "base/error.hpp"

namespace signorini::model {

template <int D> void check_changes(const Contact<D>& contact, const contact::Changes& changes) {
  const auto& [active, offset, normal, tangential, friction, overlap] = changes;
  const contact::InterfaceLaw* law = contact.own || contact.method.law.adhesion ? nullptr : &contact.method.law;
  require(law || !(offset || normal || tangential || friction), "model.contact.adhesive", {{"contact", contact.name}});
  require(!contact.method.bond || !(active || offset), "model.contact.cohesive", {{"contact", contact.name}});
  require(!normal || has_penalty(*law), "model.contact.pressure", {{"contact", contact.name}});
  require(!(tangential || friction) || may_rub(*law), "model.contact.no_friction", {{"contact", contact.name}});
  require(!friction || !(law->coefficient || law->ellipse), "model.contact.formula", {{"contact", contact.name}});
  require(overlap == 1 || contact.start.interference, "model.contact.no_interference", {{"contact", contact.name}});
  require(overlap >= 0 && overlap <= 1, "model.contact.overlap", {{"value", overlap}});
  if (law) contact::check(contact::changed(*law, changes));
}

template void check_changes(const Contact<2>&, const contact::Changes&);
template void check_changes(const Contact<3>&, const contact::Changes&);

} // namespace signorini::model
