#include "model/results/profile.hpp"

#include "model/scene/element_size.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::model {

namespace {

/// Appends the components of a vector to separate lists.
template <int D> void append(const Vec<D>& v, std::array<std::vector<double>*, 3> lists) {
  for (std::size_t i = 0; i < D; ++i) lists[i]->push_back(v(static_cast<int>(i)));
}

} // namespace

template <int D> Profile profile(const Model<D>& model, int contact) {
  const contact::Formulation<D>& formulation = *model.system.contacts[contact];
  const contact::History<D>& history = model.present.contacts[contact];
  Profile result;
  const std::vector<double> gaps = contact::gaps(formulation, history);
  const std::vector<char> inside = contact_area(model, contact, history).inside;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (!acts(formulation.points(), history, i)) continue;
    const auto& point = history.results[i];
    append<D>(formulation.points().reference[i], {&result.reference_x, &result.reference_y, &result.reference_z});
    result.gap.push_back(std::isinf(gaps[i]) ? std::nan("") : gaps[i]); // without a foot in a set of faces
    if (is_set(model.system.scene.contacts[contact])) {
      const FaceReference& face =
          model.system.scene.contacts[contact].slave[formulation.slave().sheet(formulation.points().list[i].element)];
      result.face.push_back(model.system.scene.bodies[face.body].name + "." + nurbs::name_of(face.side));
    }
    result.inside.push_back(inside[i]);
    if (const auto* bonds = formulation.bonds()) {
      result.damage.push_back(bonds->damage(history, i));
      if (bonds->law.formula) result.mix.push_back(mix(history.bonds[i]));
    }
    if (formulation.parameters().rubs()) {
      result.mu.push_back(point.mu);
      result.slip.push_back(history.points[i].slipped);
    }
    if (formulation.parameters().wears()) result.worn.push_back(history.points[i].worn);
    const bool is_held = touches(point.state) || point.state == contact::ContactState::bonded;
    append<D>(position(formulation, history, i), {&result.x, &result.y, &result.z});
    result.area.push_back(point.area);
    result.pressure.push_back(point.pressure);
    if constexpr (D == 2) {
      // t_T is tangential to the master, at a small angle to the slave's tangent, which gives only the sign.
      result.traction.push_back(
          is_held ? std::copysign(point.friction.norm(), point.friction.dot(point.tangents.col(0))) : 0.0);
    } else {
      result.traction.push_back(point.friction.norm());
      append<D>(point.friction, {&result.traction_x, &result.traction_y, &result.traction_z});
    }
    result.state.push_back(contact::name_of(point.state));
  }
  return result;
}

template <int D>
contact::ContactArea contact_area(const Model<D>& model, std::size_t contact, const contact::History<D>& history) {
  const Scene<D>& scene = model.system.scene;
  const Contact<D>& own = scene.contacts[contact];
  const bool reference = own.method.multipliers && own.method.pass == contact::Pass::full;
  return contact::contact_area(*model.system.contacts[contact], history, reference, softer_modulus(scene, own));
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template Profile profile(const Model<D>&, int);                                                                      \
  template contact::ContactArea contact_area(const Model<D>&, std::size_t, const contact::History<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
