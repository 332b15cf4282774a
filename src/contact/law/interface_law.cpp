#include "contact/law/interface_law.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::contact {

void check(const InterfaceLaw& law) {
  if (law.adhesion) return check(*law.adhesion);
  require(law.pressure || law.normal > 0, "contact.penalty.normal", {{"value", law.normal}});
  require(law.friction >= 0, "contact.penalty.friction", {{"value", law.friction}});
  require(!may_rub(law) || law.tangential > 0, "contact.penalty.tangential", {{"value", law.tangential}});
  const bool directed = law.ellipse || (law.coefficient && law.coefficient->of_cosine);
  require(!directed || law.along, "contact.friction.no_axis");
  require(directed || !law.along, "contact.friction.idle_axis");
  if (law.along) require(law.along->norm() > 0, "contact.friction.zero_axis");
  if (law.ellipse) require(law.ellipse->minCoeff() > 0, "contact.friction.ellipse", {{"value", *law.ellipse}});
}

InterfaceLaw changed(InterfaceLaw law, const Changes& changes) {
  law.normal = changes.normal.value_or(law.normal);
  law.tangential = changes.tangential.value_or(law.tangential);
  law.friction = changes.friction.value_or(law.friction);
  return law;
}

InterfaceLaw scaled(InterfaceLaw law, double factor) {
  law.normal *= factor;
  law.tangential *= factor;
  return law;
}

double stiffness(const InterfaceLaw& law, double gap, const Vec<3>& place) {
  if (law.adhesion) return stiffness(*law.adhesion, gap);
  const double normal = law.pressure ? std::abs((*law.pressure)(gap, place).rate) : law.normal;
  return -std::max(normal, law.friction > 0 ? law.tangential : 0);
}

double limit_before(double limit, double mu_before, double mu, double held) {
  return mu < mu_before ? std::max(mu / mu_before * limit, held) : limit;
}

} // namespace signorini::contact
