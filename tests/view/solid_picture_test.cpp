#include "view/solid_picture.hpp"

#include "messages.hpp"
#include "scenes.hpp"
#include "solid_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace signorini::view {
namespace {

double wave(const Vec<3>& x) {
  return std::sin(2 * x[0]) * std::cos(x[1]) + 0.3 * x[2];
}

TEST(SolidPictureLook, DrawsPicturesToLookAt) {
  const std::string folder = std::getenv("LOOK") ? std::getenv("LOOK") : scratch("");
  const Solid block = mapped_solid(block_map({0, 0, 0}, {4, 2, 1}), {8, 4, 2}, 6, wave);
  const Solid shell = mapped_solid(shell_map(0.5, 1), {4, 4, 2}, 8, wave);
  SolidOptions options;
  options.trim = true;
  options.title = "Block, load step 3";
  options.field_label = "displacement u_z";
  draw_solids({{"", {block}}}, options, folder + "/block.png");
  SolidPanel cut{"", {block}, {RigidBall{{2, 1, 1.9}, 0.9}, RigidPlane{{0, 0, 0}, {0, 0, 1}}}};
  draw_solids({cut}, options, folder + "/rigid.png");
  cut.cut = CutPlane{{0, 0.9, 0}, {0, -1, 0}};
  draw_solids({cut}, options, folder + "/cut.png");
  draw_solids({{"", {shell}}}, options, folder + "/shell.png");
  Solid bent = block;
  bent.undeformed = block.skin, bent.undeformed_rim = block.rim;
  for (auto* lines : {&bent.mesh_lines, &bent.rim})
    for (SurfaceLine& l : *lines)
      for (Eigen::Index i = 0; i < l.points.cols(); ++i) l.points(2, i) += 0.3 * std::sin(l.points(0, i));
  for (Eigen::Index i = 0; i < bent.skin.points.cols(); ++i)
    bent.skin.points(2, i) += 0.3 * std::sin(bent.skin.points(0, i));
  bent.inside.clear();
  options.colormap = "coolwarm";
  draw_solids({{"start", {block}, {RigidCylinder{{2, 1, 2.5}, {0, 1, 0}, 1}}}, {"bent", {bent}}}, options,
              folder + "/sheet.png");
  options.region = Bounds{{1, 0, 0}, {2, 1, 1}};
  draw_solids({{"", {bent}}}, options, folder + "/crop.png");
  options.region.reset();
  for (const std::string& name : camera_names()) {
    options.camera = camera(name);
    options.size = {600, 400};
    options.title = name;
    draw_solids({{"", {block, shell}}}, options, folder + "/" + name + ".png");
  }
  options = SolidOptions();
  draw_solids({{"", {shell}, {}, CutPlane{{0, 0, 0.41}, {0.4, 0.2, 1}}}}, options, folder + "/shell_cut.png");
}

} // namespace
} // namespace signorini::view
