#include "model/warnings/resolution.hpp"

#include "contact/method/peak.hpp"
#include "model/constants.hpp"
#include "model/scene/element_size.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace signorini::model {

namespace {

/// How a contact's pressures vary along the slave face.
struct PressureSpace {
  bool at_points = true, reduced = false; ///< otherwise at multipliers
  double functions = 0;                   ///< per element, if they are not those of the face
  double stiffness = 0, ratio = 0;        ///< E/h, and ε_N h/E
};

/// Empty for laws whose pressures are not those of contact alone.
template <int D> std::optional<PressureSpace> pressure_space(const Model<D>& model, int index) {
  const contact::Formulation<D>& formulation = *model.system.contacts[index];
  const Contact<D>& contact = model.system.scene.contacts[index];
  const auto& [law, multipliers, pass, bond, unknown] = contact.method;
  if (!penalty_law(contact) || bond) return std::nullopt;
  PressureSpace space{!multipliers, multipliers == contact::MultiplierSpace::reduced};
  if (multipliers == contact::MultiplierSpace::linear) space.functions = 1.0 / unknown.joined;
  space.stiffness = model.system.stiffness[index];
  space.ratio = model.present.penalty_factor * formulation.parameters().penalty(model.present.contacts[index].changes) /
                space.stiffness;
  return space;
}

/// Functions per element that a face has along a direction: p − k with functions C^k at the element's borders.
double functions_per_element(const nurbs::Space1D& direction, int element) {
  int smoothness = -1;
  for (const int end : {element, element + 1})
    if (end > 0 && end < direction.elements()) smoothness = std::max(smoothness, direction.smoothness()[end]);
  return std::max(1, direction.degree(element) - std::max(smoothness, 0));
}

/// The least number of functions in a zone whose peak is within 10 % of closed forms.
double least_functions(const PressureSpace& space, int degree) {
  if (!space.at_points) return space.reduced ? peak_functions_reduced : peak_functions_mortar;
  if (degree == 1) return peak_functions_linear * space.ratio / default_penalty_ratio;
  return peak_functions * std::sqrt(std::max(space.ratio, default_penalty_ratio) / default_penalty_alone);
}

/// The narrowest extent of a contact's zone, with the least one, in elements; the largest pressure, and the largest
/// mean over an element.
struct Narrow {
  double width, least, peak, mean;
};
/// Empty if the zone is wide enough, or if the mean, which needs a smaller width, confirms the peak.
template <int D> std::optional<Narrow> narrow_zone(const Model<D>& model, int index, const PressureSpace& space) {
  const auto& formulation = *model.system.contacts[index];
  const contact::Surface<D>& slave = formulation.slave();
  const contact::History<D>& history = model.present.contacts[index];
  const double least_pressure =
      contact_rounding * youngs_modulus(model.system.scene, model.system.scene.contacts[index].slave);
  const auto zone = contact::peak_zone(formulation, history);
  Narrow found{0, 0, resultant(history).max_pressure, contact::mean_pressure(formulation.points(), history)};
  if (!zone || found.peak <= least_pressure) return std::nullopt;
  double most = 1;
  for (int a = 0; a < D - 1; ++a) {
    const contact::ZoneExtent& extent = zone->extent[a];
    if (extent.edges == 2) continue;
    const double width = (1 + extent.edges) * extent.elements;
    const double functions = space.functions > 0
                                 ? space.functions
                                 : functions_per_element(slave.along(zone->element, a), slave.index(zone->element, a));
    const double least = least_functions(space, slave.degree(zone->element, a)) / functions;
    if (width / least >= most) continue;
    most = width / least;
    found.width = width;
    found.least = least;
  }
  const bool confirmed = found.width >= mean_elements && found.peak <= (1 + peak_error) * found.mean;
  return most < 1 && !confirmed ? std::optional(found) : std::nullopt;
}

} // namespace

template <int D> bool is_narrow(const Model<D>& model, int contact) {
  const auto space = pressure_space(model, contact);
  return space && narrow_zone(model, contact, *space);
}

template <int D> void warn_of_narrow_contacts(const Model<D>& model, std::vector<Message>& warnings) {
  for (int k = 0; k < std::ssize(model.system.scene.contacts); ++k) {
    const auto space = pressure_space(model, k);
    const auto narrow = space ? narrow_zone(model, k, *space) : std::nullopt;
    if (!narrow) continue;
    // The penalty at which this width would do
    const double part = narrow->width / narrow->least, enough = space->ratio * part * part;
    Message remedy;
    if (space->at_points && enough >= default_penalty_ratio)
      remedy = Message("model.narrow.penalty", {{"penalty", enough * space->stiffness}});
    warnings.push_back(Message("model.warning.narrow", {{"contact", model.system.scene.contacts[k].name},
                                                        {"width", narrow->width},
                                                        {"least", std::ceil(narrow->least)},
                                                        {"peak", narrow->peak},
                                                        {"mean", narrow->mean},
                                                        {"remedy", remedy}}));
  }
}

template bool is_narrow(const Model<2>&, int);
template bool is_narrow(const Model<3>&, int);
template void warn_of_narrow_contacts(const Model<2>&, std::vector<Message>&);
template void warn_of_narrow_contacts(const Model<3>&, std::vector<Message>&);

} // namespace signorini::model
