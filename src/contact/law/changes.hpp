#pragma once
// Constants of a contact that a load path changes; they are part of its state.

#include <optional>

namespace signorini::contact {

/// Constants at the start of a path.
struct Start {
  bool active = true;
  double offset = 0;         ///< gap at which the faces touch
  bool interference = false; ///< the overlap of the initial shapes is allowed, to be closed along the path
};

/// Constants that differ from those of the scene. `overlap`: fraction of the initial overlap that remains allowed.
struct Changes {
  std::optional<bool> active = {};
  std::optional<double> offset = {}, normal = {}, tangential = {}, friction = {};
  double overlap = 1;
  bool operator==(const Changes&) const = default;
};

} // namespace signorini::contact
