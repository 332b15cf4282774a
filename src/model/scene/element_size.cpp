#include "model/scene/element_size.hpp"

#include "model/scene/contact_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::model {

template <int D>
double element_size(const Scene<D>& scene, const Faces& faces, int points, const contact::Region<D>& where) {
  const contact::Surface<D> surface = faces.size() == 1 ? surface_of(scene, faces) : set_of(scene, faces);
  constexpr bool revolved = false; // sizes in the meridian plane
  const auto list = contact::ContactPoints<D>(surface, points, revolved, where).list;
  double elements = 0, inverse = 0;
  for (auto first = list.begin(), last = first; first != list.end(); first = last) {
    last = std::find_if(first, list.end(), [&](const auto& point) { return point.element != first->element; });
    double parametric = 1, area = 0, weight = 0;
    for (int d = 0; d < D - 1; ++d) {
      const auto [from, to] = surface.interval(first->element, d);
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

template <int D> double pitch(const Scene<D>& scene, const Faces& faces) {
  const contact::Surface<D> face = surface_of(scene, faces);
  double per_element = 1;
  for (int d = 0; d < D - 1; ++d)
    per_element *= static_cast<double>(face.direction(d).functions()) / face.direction(d).elements();
  return element_size(scene, faces, 2) / std::pow(per_element, 1.0 / (D - 1));
}

template <int D> double youngs_modulus(const Scene<D>& scene, const Faces& faces) {
  double least = std::numeric_limits<double>::infinity();
  for (const FaceReference& face : faces)
    least = std::min(least, scene.bodies[face.body].body->material().constants().youngs_modulus);
  return least;
}

template <int D> double softer_modulus(const Scene<D>& scene, const Contact<D>& contact) {
  const double slave = youngs_modulus(scene, contact.slave);
  const auto* master = std::get_if<Faces>(&contact.master);
  return master ? std::min(slave, youngs_modulus(scene, *master)) : slave;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template double element_size(const Scene<D>&, const Faces&, int, const contact::Region<D>&);                         \
  template double pitch(const Scene<D>&, const Faces&);                                                                \
  template double youngs_modulus(const Scene<D>&, const Faces&);                                                       \
  template double softer_modulus(const Scene<D>&, const Contact<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
