#include "model/default_penalty.hpp"

#include "base/index.hpp"
#include "model/constants.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::model {

namespace {

/// Harmonic mean size of the slave elements inside the contact, in the reference configuration: meshes are graded
/// towards the places that come into contact, and their many small elements count most.
template <int D> double slave_element_size(const Scene<D>& scene, const Contact<D>& contact) {
  const contact::Surface<D> slave(scene.bodies[at(contact.slave.body)].body->space(), contact.slave.side);
  constexpr bool revolved = false; // sizes in the meridian plane
  const auto list = contact::ContactPoints<D>(slave, contact.points, revolved, contact.where).list;
  double elements = 0, inverse = 0;
  for (auto first = list.begin(), last = first; first != list.end(); first = last) {
    last = std::find_if(first, list.end(), [&](const auto& point) { return point.element != first->element; });
    double parametric = 1, area = 0, weight = 0;
    for (int d = 0; d < D - 1; ++d) {
      const auto [from, to] = slave.interval(first->element, d);
      parametric *= to - from;
    }
    for (auto point = first; point != last; ++point) {
      area += point->weight * point->reference_area;
      weight += point->weight;
    }
    // Share of an element e inside the contact, s = Σ w/|e|, its size, h^(D−1) = ∫ dA/s, and Σ s/h
    const double share = weight / parametric;
    elements += share;
    inverse += share / std::pow(area / share, 1.0 / (D - 1));
  }
  return elements / inverse;
}

template <int D> double youngs_modulus(const Scene<D>& scene, const FaceReference& face) {
  return scene.bodies[at(face.body)].body->material().constants().youngs_modulus;
}

template <int D> double default_penalty(const Scene<D>& scene, const Contact<D>& contact) {
  double softer = youngs_modulus(scene, contact.slave);
  if (const auto* face = std::get_if<FaceReference>(&contact.master))
    softer = std::min(softer, youngs_modulus(scene, *face));
  // ε = 10 E/h
  return default_penalty_ratio * softer / slave_element_size(scene, contact);
}

} // namespace

template <int D> void set_default_penalties(Scene<D>& scene) {
  for (Contact<D>& contact : scene.contacts) {
    contact::PenaltyLaw* law = contact::penalty_law(contact.method);
    if (!law || law->enforcement == contact::Enforcement::penalty) continue;
    const double usual = default_penalty(scene, contact);
    if (auto* mortar = std::get_if<contact::MortarLaw>(&contact.method)) mortar->scale = usual;
    if (law->normal == 0) {
      law->normal = usual;
      contact.default_penalty = true;
    }
    if (law->tangential == 0) law->tangential = law->normal;
  }
}

template void set_default_penalties(Scene<2>&);
template void set_default_penalties(Scene<3>&);

} // namespace signorini::model
