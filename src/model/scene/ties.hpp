#pragma once
// The ties of a scene: construction and warnings.

#include "model/scene/scene.hpp"

namespace signorini::model {

/// Throws Error if a tie's faces do not coincide or do not face each other.
template <int D> contact::Ties<D> make_ties(const Scene<D>& scene);

/// Warns about faces that are tied in part only, and about wholly tied faces in contact with others.
template <int D> void warn_of_ties(const Scene<D>& scene, const contact::Ties<D>& ties, std::vector<Message>& warnings);

/// E/h of the softer body of a tie, h the size of the elements behind its face.
template <int D> double tied_stiffness(const Scene<D>& scene, const Tie& tie);

} // namespace signorini::model
