#include "view/picture.hpp"

#include "os/whole_file.hpp"
#include "scenes.hpp"
#include "scratch.hpp"
#include "svg.hpp"
#include "view/colorbar.hpp"
#include "view/figure.hpp"

#include <gtest/gtest.h>

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

std::string drawn(const std::vector<Body>& bodies, const PictureOptions& options) {
  return picture_of(std::vector<Panel>{{"", bodies}}, options);
}

std::string refusal(const std::vector<Body>& bodies, const PictureOptions& options = {}) {
  return message_of([&] { drawn(bodies, options); });
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
  const std::string first = drawn(rings(), displacement());
  PictureOptions other = displacement();
  other.size = {500, 600};
  const std::string between = drawn(rings(), other); // a different size must not affect the next picture
  EXPECT_EQ(first, drawn(rings(), displacement()));
  EXPECT_EQ(png_size(first), (std::array<int, 2>{800, 500}));
  EXPECT_EQ(png_size(between), (std::array<int, 2>{500, 600}));
}

// Run by the next test in another process.
TEST(Picture, DISABLED_DrawsForAnotherProcess) {
  const char* folder = std::getenv("SIGNORINI_DRAW_TO");
  ASSERT_NE(folder, nullptr);
  write_record(std::string(folder) + "/process.png", drawn(rings(), displacement()));
}

TEST(Picture, GivesEqualBytesInAnotherProcess) {
  const test::ScratchFolder folder;
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::string command =
      text("SIGNORINI_DRAW_TO='", folder.file(""), "' '", program,
           "' --gtest_also_run_disabled_tests --gtest_filter='*DrawsForAnotherProcess' >/dev/null");
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(read_file(folder.file("process.png")), drawn(rings(), displacement()));
}

TEST(Picture, ChangesWithFieldLinesAndColors) {
  const std::string all = drawn(rings(), displacement());
  auto bodies = rings();
  bodies[0].skin.values[5] += 0.5;
  EXPECT_NE(drawn(bodies, displacement()), all);
  bodies = rings();
  bodies[1].mesh_lines.clear();
  EXPECT_NE(drawn(bodies, displacement()), all);
  PictureOptions cividis = displacement();
  cividis.colormap = "cividis";
  EXPECT_NE(drawn(rings(), cividis), all);
}

TEST(Picture, DoesNotLeakMemory) {
  PictureOptions options = displacement();
  options.size = {640, 400};
  const auto bodies = rings();
  const auto batch = [&](int count) {
    for (int i = 0; i < count; ++i) drawn(bodies, options);
  };
  batch(5); // fills the caches
  const double before = resident();
  batch(30);
  EXPECT_LT(resident() - before, 15) << "megabytes in 30 pictures";
}

TEST(Picture, OpensNoConnectionToADisplay) {
  drawn(rings(), displacement());
  EXPECT_FALSE(holds_x_socket());
}

TEST(Picture, AcceptsBodiesWithoutFieldAndConstantFields) {
  auto bodies = rings();
  bodies[0].skin.values.resize(0);
  bodies[1].skin.values.setConstant(0);
  EXPECT_EQ(refusal(bodies, displacement()), "no error");
  bodies[1].skin.values.resize(0);
  EXPECT_EQ(png_size(drawn(bodies, {})), (std::array<int, 2>{1600, 1000}));
}

TEST(Picture, RejectsInvalidInput) {
  EXPECT_TRUE(holds(refusal({}), {"view.picture.empty"}));
  PictureOptions options;
  options.colormap = "jet";
  EXPECT_TRUE(holds(
      refusal(rings(), options),
      {"view.colormap.unknown: colormap = jet, known = (viridis, magma, inferno, plasma, cividis, gray, coolwarm)"}));
  auto bodies = rings();
  bodies[1].skin.values[3] = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(holds(refusal(bodies), {"view.body.field: body = (view.sheet.body: state = (), number = 1)"}));
  bodies = rings();
  bodies[0].skin.triangles(0, 0) = 100000;
  EXPECT_TRUE(
      holds(refusal(bodies), {"view.body.triangles: body = (view.sheet.body: state = (), number = 0), most = 2700"}));
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
