#pragma once
// Size and stiffness of the material at a face, which scale contact.

#include "model/scene/scene.hpp"

namespace signorini::model {

/// Harmonic mean size of the elements of a face, in the part in which a contact acts, in the reference configuration:
/// meshes are graded towards the places that come into contact, and their many small elements count most. `points`: of
/// quadrature per element and direction.
template <int D>
double element_size(const Scene<D>& scene, const Faces& faces, int points, const contact::Region<D>& where = {});

/// Length of a face per function along it.
template <int D> double pitch(const Scene<D>& scene, const Faces& faces);

/// Small-strain Young's modulus of the face's body.
template <int D> double youngs_modulus(const Scene<D>& scene, const Faces& faces);
/// Young's modulus of the softer body of a contact.
template <int D> double softer_modulus(const Scene<D>& scene, const Contact<D>& contact);

} // namespace signorini::model
