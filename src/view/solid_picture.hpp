#pragma once
// Pictures of solids: lit surfaces with element borders, cut open where asked, seen in parallel projection.

#include "view/camera.hpp"
#include "view/cut.hpp"
#include "view/picture.hpp"
#include "view/rigid.hpp"

namespace signorini::view {

/// One state of a model of solids.
struct SolidPanel {
  std::string title;
  std::vector<Solid> bodies;
  std::vector<Rigid> obstacles = {};
  std::optional<CutPlane> cut = {};  ///< of bodies and obstacles
  std::vector<PointMark> marks = {}; ///< drawn on top of all that is in front of them
  Names names = {};
  std::vector<PointVector> vectors = {}; ///< beside those of the bodies
  std::vector<Window> windows = {};      ///< for what is tessellated here: obstacles that are no RigidSurface
};

/// As PictureOptions, with a camera; `region`, a box in space, takes the place of `crop`: the picture ends where the
/// box seen from the camera ends.
struct SolidOptions : PictureOptions {
  Camera camera = view::camera("iso");
  std::optional<Bounds> region = {};
};

/// As those of plane panels, all states seen by one camera. Axes are shown by three arrows.
Plate make_plate(const std::vector<SolidPanel>& panels, const SolidOptions& options);
void align(SolidOptions& options, const std::vector<SolidPanel>& panels);

void check_part(const std::vector<SolidPanel>& panels, const SolidOptions& options, const std::string& argument);

/// Throws Error when all states are cut and nothing is taken away from any.
void check_cuts(const std::vector<SolidPanel>& panels);

} // namespace signorini::view
