#pragma once
// Input and output of scenes in parts, so that two scenes can be compared.

#include "model/steps/model.hpp"
#include "os/archive.hpp"

namespace signorini::model {

inline auto members(ScenePart& part) {
  auto& [name, bytes] = part;
  return std::tie(name, bytes);
}

/// All parts of a model's scene, as it was before layers followed the contact. A region of a contact is stored as the
/// list of its contact points.
template <int D> std::vector<ScenePart> scene_parts(const Model<D>& model);
/// The scene of these parts; a model of it gives bitwise equal results. Throws Error if they are inconsistent.
template <int D> Scene<D> read_scene(const std::vector<ScenePart>& parts, const ArchiveLimits& limits = {});

} // namespace signorini::model
