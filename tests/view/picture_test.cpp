#include "view/picture.hpp"

#include "messages.hpp"
#include "scenes.hpp"
#include "view/colorbar.hpp"
#include "view/figure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <unistd.h>

namespace signorini::view {
namespace picture_test {

std::vector<Body> rings() {
  return {bent_ring({0, 0}, 0.5, 1.0, 0, 6, 3), bent_ring({1.62, 1.1}, 0.4, 0.8, 180, 8, 2)};
}

/// Options of a picture of a quarter of the usual number of pixels, with which the time of drawing grows.
PictureOptions displacement() {
  PictureOptions options;
  options.size = {800, 500};
  options.title = "Two quarter rings, load step 160";
  options.field_label = "vertical displacement [mm]";
  return options;
}

std::string refusal(const std::vector<Body>& bodies, const PictureOptions& options = {},
                    const std::string& name = "no.png") {
  const std::string message = message_of([&] { draw_picture(bodies, options, scratch(name)); });
  EXPECT_FALSE(std::filesystem::exists(scratch(name)));
  return message;
}

/// Memory use, in megabytes.
double resident() {
  std::ifstream in("/proc/self/statm");
  double total = 0, pages = 0;
  in >> total >> pages;
  return pages * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

bool holds_x_socket() {
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    std::error_code ignored;
    if (std::filesystem::read_symlink(entry.path(), ignored).string().rfind("socket:", 0) == 0) return true;
  }
  return false;
}

TEST(Picture, GivesEqualBytesForEqualCalls) {
  draw_picture(rings(), displacement(), scratch("first.png"));
  PictureOptions other = displacement();
  other.size = {500, 600};
  draw_picture(rings(), other, scratch("other.png")); // a different size in between must not affect the next picture
  draw_picture(rings(), displacement(), scratch("second.png"));
  EXPECT_EQ(file_bytes(scratch("first.png")), file_bytes(scratch("second.png")));
  EXPECT_EQ(png_size(file_bytes(scratch("first.png"))), (std::array<int, 2>{800, 500}));
  EXPECT_EQ(png_size(file_bytes(scratch("other.png"))), (std::array<int, 2>{500, 600}));
}

// Run by the next test in another process.
TEST(Picture, DISABLED_DrawsForAnotherProcess) {
  const char* folder = std::getenv("SIGNORINI_DRAW_TO");
  ASSERT_NE(folder, nullptr);
  draw_picture(rings(), displacement(), std::string(folder) + "/process.png");
}

TEST(Picture, GivesEqualBytesInAnotherProcess) {
  draw_picture(rings(), displacement(), scratch("here.png"));
  const std::string folder = std::filesystem::path(scratch("process.png")).parent_path().string();
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string command =
      text("SIGNORINI_DRAW_TO='", folder, "' '", program,
           "' --gtest_also_run_disabled_tests --gtest_filter='*DrawsForAnotherProcess' >/dev/null");
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(file_bytes(scratch("process.png")), file_bytes(scratch("here.png")));
}

TEST(Picture, ChangesWithFieldLinesAndColors) {
  const auto bytes = [](const std::vector<Body>& bodies, const PictureOptions& options) {
    draw_picture(bodies, options, scratch("change.png"));
    return file_bytes(scratch("change.png"));
  };
  const std::string all = bytes(rings(), displacement());
  auto bodies = rings();
  bodies[0].skin.values[5] += 0.5;
  EXPECT_NE(bytes(bodies, displacement()), all);
  bodies = rings();
  bodies[1].mesh_lines.clear();
  EXPECT_NE(bytes(bodies, displacement()), all);
  PictureOptions cividis = displacement();
  cividis.colormap = "cividis";
  EXPECT_NE(bytes(rings(), cividis), all);
}

TEST(Picture, DoesNotLeakMemory) {
  PictureOptions options = displacement();
  options.size = {640, 400};
  const auto bodies = rings();
  const auto batch = [&](int count) {
    for (int i = 0; i < count; ++i) draw_picture(bodies, options, scratch("many.png"));
  };
  batch(5); // fills the caches
  const double before = resident();
  batch(30);
  EXPECT_LT(resident() - before, 15) << "megabytes in 30 pictures";
}

TEST(Picture, OpensNoConnectionToADisplay) {
  draw_picture(rings(), displacement(), scratch("display.png"));
  EXPECT_FALSE(holds_x_socket());
}

TEST(Picture, AcceptsBodiesWithoutFieldAndConstantFields) {
  auto bodies = rings();
  bodies[0].skin.values.resize(0);
  bodies[1].skin.values.setConstant(0);
  draw_picture(bodies, displacement(), scratch("constant.png"));
  bodies[1].skin.values.resize(0);
  draw_picture(bodies, {}, scratch("gray.png"));
  EXPECT_EQ(png_size(file_bytes(scratch("gray.png"))), (std::array<int, 2>{1600, 1000}));
}

TEST(Picture, RejectsInvalidInput) {
  EXPECT_TRUE(holds(refusal({}), {"view.picture.empty"}));
  PictureOptions options;
  options.colormap = "jet";
  EXPECT_TRUE(holds(
      refusal(rings(), options),
      {"view.colormap.unknown: colormap = jet, known = (viridis, magma, inferno, plasma, cividis, gray, coolwarm)"}));
  auto bodies = rings();
  bodies[1].skin.values[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(holds(refusal(bodies), {"view.body.field: body = (view.sheet.body: state = (), number = 1)"}));
  bodies = rings();
  bodies[0].skin.triangles(0, 0) = 100000;
  EXPECT_TRUE(
      holds(refusal(bodies), {"view.body.triangles: body = (view.sheet.body: state = (), number = 0), most = 2700"}));
  EXPECT_TRUE(holds(refusal(rings(), {}, "no.jpg"), {"view.file.ending"}));
  EXPECT_TRUE(holds(refusal(rings(), {}, "missing/no.png"), {"os.file.no_folder"}));
}

TEST(Colormap, IsMonotonicFromDarkToLightUnlessDiverging) {
  for (const std::string& name : colormaps()) {
    const auto colors = colormap(name);
    ASSERT_EQ(colors.size(), 256u);
    const auto lightness = [&](int i) { return 0.2126 * colors[i][0] + 0.7152 * colors[i][1] + 0.0722 * colors[i][2]; };
    const int top = is_diverging(name) ? 128 : 255;
    for (int i = 4; i <= top; i += 4) EXPECT_GT(lightness(i), lightness(i - 4) - 0.6) << name << " " << i;
    if (is_diverging(name)) {
      for (int i = 132; i < 256; i += 4) EXPECT_LT(lightness(i), lightness(i - 4) + 0.6) << name << " " << i;
    }
  }
  EXPECT_EQ(colormap("viridis").front(), (Rgb{0x44, 0x01, 0x54}));
  EXPECT_EQ(colormap("viridis").back(), (Rgb{0xFD, 0xE7, 0x25}));
}

TEST(Renderer, ReportsItsDescription) {
  EXPECT_TRUE(holds(renderer().description(), {"VTK 9", "OpenGL"}));
}

} // namespace picture_test
} // namespace signorini::view
