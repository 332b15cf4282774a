#pragma once
// Scenes in files, part by part, so that two of them can be compared.

#include "base/archive.hpp"
#include "model/model.hpp"

namespace signorini::model {

/// A part of a scene as users call it ("body 'slab'", "the kind of scene"), and its bytes.
struct ScenePart {
  std::string name, bytes;
};
inline auto members(ScenePart& part) {
  auto& [name, bytes] = part;
  return std::tie(name, bytes);
}

/// All parts of a model's scene. Of a contact that a region limits, the points that are left are kept.
template <int D> std::vector<ScenePart> scene_parts(const Model<D>& model);
/// The scene again, to make a model of that has the same bits.
template <int D> Scene<D> read_scene(const std::vector<ScenePart>& parts);

} // namespace signorini::model
