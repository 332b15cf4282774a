#include "view/picture.hpp"

#include "scenes.hpp"
#include "solid_scenes.hpp"
#include "svg.hpp"
#include "view/camera.hpp"
#include "view/relief.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace signorini::view {
namespace solid_picture_test {

double wave(const Vec<3>& x) {
  return std::sin(2 * x[0]) * std::cos(x[1]) + 0.3 * x[2];
}

Body block(const Vec<3>& low, const Vec<3>& high) {
  return mapped_solid(block_map(low, high), {3, 2, 2}, 3, wave);
}

PictureOptions small() {
  PictureOptions options;
  options.camera = camera("iso");
  options.size = {400, 300};
  options.range = {-1, 1};
  options.field_label = "displacement u_z";
  return options;
}

/// The bytes of a picture, compared as a whole.
struct Png {
  std::string bytes;

  bool operator==(const Png&) const = default;
};

void PrintTo(const Png& png, std::ostream* out) {
  *out << png.bytes.size() << " bytes";
}

Png drawn(const std::vector<Panel>& panels, const PictureOptions& options) {
  return {picture_of(panels, options)};
}

std::string refusal(const Panel& panel, const PictureOptions& options = small()) {
  return message_of([&] { make_plate(std::vector<Panel>{panel}, options); });
}

TEST(SolidPicture, GivesEqualBytesForEqualCalls) {
  const Body shell = mapped_solid(shell_map(0.5, 1), {3, 3, 2}, 4, wave);
  Panel panel{"state", {shell}, {RigidBall{{1, 1, 1}, 0.4}, RigidPlane{{0, 0, 0}, {0, 0, 1}}}};
  panel.cut = CutPlane{{0.2, 0.3, 0.4}, {1, 1, 0.5}};
  const Png first = drawn({panel}, small());
  PictureOptions other = small();
  other.size = {300, 420};
  const Png between = drawn({panel, {"whole", {shell}}}, other);
  EXPECT_EQ(drawn({panel}, small()), first);
  EXPECT_EQ(png_size(first.bytes), (std::array<int, 2>{400, 300}));
  EXPECT_EQ(png_size(between.bytes), (std::array<int, 2>{300, 420}));
}

TEST(SolidPicture, HidesWhatIsBehind) {
  const Body front = block({0, 0, 0}, {2, 1, 1});
  PictureOptions options = small();
  options.camera = camera("front");
  const Png alone = drawn({{"", {front}}}, options);
  // A smaller block behind, its lines, and lines on sides that face away
  EXPECT_EQ(drawn({{"", {front, block({0.1, 1.1, 0.1}, {1.9, 2, 0.9})}}}, options), alone);
  const auto marked = [&](double y) {
    SurfaceLine line{Points(3, 2), Points(3, 2)};
    line.points << 0.2, 1.3, y, y, 0.1, 0.7;
    line.normals << 0, 0, 2 * y - 1, 2 * y - 1, 0, 0;
    Body solid = front;
    solid.rim.push_back(line);
    return drawn({{"", {solid}}}, options);
  };
  EXPECT_EQ(marked(1), alone);
  // In front they are visible.
  EXPECT_NE(drawn({{"", {front, block({0.1, -1, 0.1}, {1.9, -0.1, 0.9})}}}, options), alone);
  EXPECT_NE(marked(0), alone);
}

TEST(SolidPicture, ShowsAllOfItsInput) {
  Body solid = block({0, 0, 0}, {2, 1, 1});
  const auto changed = [&](auto change) {
    Panel panel{"", {solid}};
    PictureOptions options = small();
    change(panel, options);
    return drawn({panel}, options);
  };
  const Png plain = changed([](auto&, auto&) {});
  EXPECT_NE(changed([](Panel& p, auto&) { p.title = "state"; }), plain);
  EXPECT_NE(changed([](Panel& p, auto&) { p.bodies[0].mesh_lines.clear(); }), plain);
  EXPECT_NE(changed([](Panel& p, auto&) { p.bodies[0].rim.clear(); }), plain);
  EXPECT_NE(changed([](Panel& p, auto&) { p.bodies[0].control_points = Vec<3>(1, -0.1, 0.5); }), plain);
  EXPECT_NE(changed([](Panel& p, auto&) {
              const Body larger = block({0, 0, 0}, {2, 1, 1.2});
              p.bodies[0].undeformed = larger.skin;
            }),
            plain);
  EXPECT_NE(changed([](Panel& p, auto&) { p.obstacles = {RigidPlane{{0, 0, -0.1}, {0, 0, 1}}}; }), plain);
  EXPECT_NE(changed([](Panel& p, auto&) { p.cut = CutPlane{{1, 0, 0}, {1, 0, 0}}; }), plain);
  const auto halved = [&](std::vector<PointVector> vectors) {
    return changed([&](Panel& p, auto&) { p.cut = CutPlane{{1, 0, 0}, {1, 0, 0}}, p.vectors = vectors; });
  };
  EXPECT_EQ(halved({{{1.5, 0, 0.5}, {0, -1, 0}}}), halved({})); // removed parts have no arrows
  EXPECT_NE(halved({{{0.5, 0, 0.5}, {0, -1, 0}}}), halved({}));
  EXPECT_NE(changed([](auto&, PictureOptions& o) { o.camera = camera("top"); }), plain);
  EXPECT_NE(changed([](auto&, PictureOptions& o) { o.crop = Bounds{{0, 0, 0}, {1, 1, 1}}; }), plain);
  EXPECT_NE(changed([](auto&, PictureOptions& o) { o.colormap = "magma"; }), plain);
  // Bodies outside the region have no effect, except on the values printed at the bar.
  const auto cropped = [](Panel& p, PictureOptions& o, bool more) {
    o.crop = Bounds{{0, 0, 0}, {1, 1, 1}};
    o.camera = camera("front");
    o.range = {-2, 2};
    o.bar = false;
    if (more) p.bodies.push_back(block({1.5, 0, -2}, {4, 1, 3}));
  };
  EXPECT_EQ(changed([&](Panel& p, PictureOptions& o) { cropped(p, o, true); }),
            changed([&](Panel& p, PictureOptions& o) { cropped(p, o, false); }));
}

TEST(SolidPicture, IsTrimmedToItsContent) {
  PictureOptions options = small();
  options.size = {1600, 1000};
  options.trim = true;
  options.camera = camera("front");
  const auto [width, height] = png_size(drawn({{"", {block({0, 0, 0}, {20, 1, 1})}}}, options).bytes);
  EXPECT_EQ(width, 1600);
  EXPECT_LT(height, 420);
  const auto [narrow, high] = png_size(drawn({{"", {block({0, 0, 0}, {1, 1, 20})}}}, options).bytes);
  EXPECT_EQ(high, 1000);
  EXPECT_LT(narrow, 440);
}

TEST(SolidPicture, RejectsInvalidInput) {
  const Body good = block({0, 0, 0}, {2, 1, 1});
  EXPECT_TRUE(holds(refusal({"", {}}), {"view.picture.empty"}));
  EXPECT_TRUE(holds(refusal({"", {good}, {}, CutPlane{{0, 0, 0}, {0, 0, 0}}}), {"view.sheet.cut: state = ()"}));
  EXPECT_TRUE(holds(refusal({"", {good}, {}, CutPlane{{-1, 0, 0}, {1, 0, 0}}}), {"view.solids.cut_away"}));
  Body bad = good;
  bad.skin.points(1, 4) = std::nan("");
  EXPECT_TRUE(
      holds(refusal({"", {good, bad}}), {"view.body.points: body = (view.sheet.body: state = (), number = 1)"}));
  bad = good;
  bad.skin.values[3] = INFINITY;
  EXPECT_TRUE(holds(refusal({"", {bad}}), {"view.body.field: body = (view.sheet.body: state = (), number = 0)"}));
  bad = good;
  bad.skin.values.conservativeResize(5);
  EXPECT_TRUE(holds(refusal({"", {bad}}),
                    {"view.body.values: body = (view.sheet.body: state = (), number = 0), values = 5, points = 378"}));
  bad = good;
  bad.inside[0].points(0, 0) = std::nan("");
  EXPECT_TRUE(holds(refusal({"", {bad}}), {"view.body.inside: body = (view.sheet.body: state = (), number = 0)"}));
}

TEST(Ribbon, LiesOnItsSurfaceWithItsWidth) {
  Points line(3, 2), normals(3, 2);
  line << 10, 30, 5, 5, 2, 2;
  const Vec<3> normal = Vec<3>(0, 0.6, 0.8);
  normals << normal, normal;
  Ink ink;
  add_ribbon(ink, line, normals, {{1, 2, 3}, 4, 0.5, true});
  ASSERT_EQ(ink.corners.size(), 3 * ink.colors.size());
  double low = 100, high = -100;
  for (const Vec<3>& corner : ink.corners) {
    EXPECT_NEAR(normal.dot(corner - Vec<3>(10, 5, 2.5)), 0, 1e-12);
    low = std::min(low, corner[1]), high = std::max(high, corner[1]);
  }
  EXPECT_NEAR(high - low, 4, 1e-12);
}

TEST(Ribbon, EndsWhereItsSurfaceFacesAway) {
  Points line(3, 2), normals(3, 2);
  line << 0, 10, 0, 0, 0, 0;
  normals << 0, 0, 0.8, -0.8, 0.3, -0.1;
  const auto farthest = [&](bool facing_only) {
    Ink ink;
    add_ribbon(ink, line, normals, {{1, 2, 3}, 1e-6, 0, facing_only});
    double far = 0;
    for (const Vec<3>& corner : ink.corners) far = std::max(far, corner[0]);
    return far;
  };
  EXPECT_NEAR(farthest(true), 7.5, 1e-5);
  EXPECT_NEAR(farthest(false), 10, 1e-5);
}

TEST(Triad, HasSpaceForItsArrows) {
  const Style style = style_for({1600, 1000});
  for (const std::string& name : camera_names()) {
    const Mat<3> axes = picture_axes(camera(name));
    const auto [left, right, below, above] = triad_room(axes, {"x", "y", "z"}, style);
    Drawing drawing{{1600, 1000}, {}};
    draw_triad(drawing, {0, 0}, axes, {"x", "y", "z"}, style);
    int letters = 0;
    for (const Mark& mark : drawing.marks) {
      letters += std::holds_alternative<Text>(mark);
      const auto* fill = std::get_if<Fill>(&mark);
      for (const Vec2& p : fill ? fill->outline : std::vector<Vec2>())
        EXPECT_TRUE(p[0] >= -left && p[0] <= right && p[1] >= -below && p[1] <= above) << name;
    }
    EXPECT_EQ(letters, name == "iso" ? 3 : 2) << name;
  }
}

} // namespace solid_picture_test
} // namespace signorini::view
