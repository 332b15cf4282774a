// Mesh lines, contour lines and arrows on colored surfaces.

#include "scenes.hpp"
#include "solid_scenes.hpp"
#include "surfaces.hpp"
#include "svg.hpp"
#include "view/categories.hpp"
#include "view/colorbar.hpp"
#include "view/cut.hpp"
#include "view/picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace signorini::view {
namespace surface_lines_test {

/// A square [0, 1]² of n × n cells, colored by a function of its points, with one mesh line along y = 0.5.
Body square(const std::function<double(const Vec<3>&)>& value, int n = 10) {
  Body body;
  body.skin = plane_surface({n, n}, [](double u, double v) { return Vec<3>(u, v, 0); });
  body.skin.values.resize(body.skin.points.cols());
  for (Eigen::Index i = 0; i < body.skin.points.cols(); ++i) body.skin.values[i] = value(body.skin.points.col(i));
  body.mesh_lines.push_back({body.skin.points.middleCols((n + 1) * (n / 2), n + 1), {}, 0.5});
  return body;
}

double along_x(const Vec<3>& point) {
  return point[0];
}

std::vector<Stroke> strokes_of(const Plate& plate, const std::function<bool(const Stroke&)>& wanted) {
  std::vector<Stroke> strokes;
  for (const Mark& mark : plate.drawing.marks)
    if (const auto* stroke = std::get_if<Stroke>(&mark); stroke && wanted(*stroke)) strokes.push_back(*stroke);
  return strokes;
}

bool has_text(const Plate& plate, const std::string& words) {
  return std::any_of(plate.drawing.marks.begin(), plate.drawing.marks.end(), [&](const Mark& mark) {
    const auto* text = std::get_if<Text>(&mark);
    return text && text->string == words;
  });
}

TEST(MeshLine, IsVisibleOnColors) {
  for (const char* name : {"viridis", "magma", "inferno", "plasma", "coolwarm"})
    for (const Rgb& ground : colormap(name)) {
      double squares = 0;
      for (int c = 0; c < 3; ++c) squares += std::pow(double(ground[c]) - mesh_color[c], 2);
      EXPECT_GT(std::sqrt(squares), 50) << name;
      EXPECT_GT(std::abs(lightness(tone_on(ground)) - lightness(ground)), 20) << name;
    }
}

TEST(MeshLine, HasOneColorOnAllValues) {
  PictureOptions options;
  options.bar = false;
  const Plate plate = make_plate(std::vector<Panel>{{"", {square(along_x)}}}, options);
  const Frame& frame = plate.frames.front();
  const double y = frame.y(0.5);
  const auto lines = strokes_of(plate, [&](const Stroke& one) {
    return one.points.size() > 2 &&
           std::all_of(one.points.begin(), one.points.end(), [&](const Vec2& p) { return std::abs(p[1] - y) < 1e-6; });
  });
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].color, mesh_color);
  EXPECT_NEAR(lines[0].points.front()[0], frame.x(0), 1e-6);
  EXPECT_NEAR(lines[0].points.back()[0], frame.x(1), 1e-6);
}

TEST(Contours, AreOneLineAtTheGivenValue) {
  const Body body = square(along_x, 7);
  const auto lines = zeros(body.skin, body.skin.values.array() - 0.3);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_LT((lines[0].points.row(0).array() - 0.3).abs().maxCoeff(), 1e-12);
  EXPECT_NEAR(test::length(lines), 1, 1e-12);
  const Body bowl = square([](const Vec<3>& p) { return (p - Vec<3>(0.5, 0.5, 0)).norm(); }, 60);
  const auto rings = zeros(bowl.skin, bowl.skin.values.array() - 0.4);
  ASSERT_EQ(rings.size(), 1U);
  EXPECT_NEAR(test::length(rings), 0.8 * 3.14159265, 0.01);
}

TEST(Contours, AreDrawnAtTheirLevelsOnBodiesAndBar) {
  PictureOptions options;
  options.contours = Contours{0, {0.25, 0.75}};
  for (const bool with : {true, false}) {
    if (!with) options.contours.reset();
    const Plate plate = make_plate(std::vector<Panel>{{"", {square(along_x)}}}, options);
    const Frame& frame = plate.frames.front();
    for (double level : {0.25, 0.75}) {
      const double x = frame.x(level);
      const auto lines = strokes_of(plate, [&](const Stroke& one) {
        return one.points.size() > 3 && std::all_of(one.points.begin(), one.points.end(),
                                                    [&](const Vec2& p) { return std::abs(p[0] - x) < 1e-6; });
      });
      EXPECT_EQ(lines.size(), with ? 1U : 0U);
    }
  }
  const Body block = mapped_solid(block_map({0, 0, 0}, {1, 1, 1}), {1, 1, 1}, 4, along_x);
  PictureOptions solid;
  solid.camera = camera("iso");
  const auto ink_of = [&] { return make_plate({{"", {block}}}, solid).reliefs.front().ink.colors.size(); };
  const std::size_t plain = ink_of();
  solid.contours = Contours{3};
  EXPECT_GT(ink_of(), plain + 20);
}

TEST(Contours, AreAtTheNumbersOfTheBarOrEvenlySpaced) {
  EXPECT_EQ(contour_levels({}, {0, 1}, {0, 1}), linear_ticks(0, 1, 9).at);
  EXPECT_EQ(contour_levels({3}, {0, 1}, {0, 1}), (std::vector<double>{0.25, 0.5, 0.75}));
  EXPECT_TRUE(holds(message_of([] {
                      contour_levels({0, {2, 3}}, {0, 1}, {0, 1});
                    }),
                    {"view.contours.none: low = 0, high = 1"}));
}

TEST(Vectors, AreSampledOnAGridWhereVisible) {
  Surface near = square(along_x).skin;
  near.points *= 100;
  near.vectors = 2 * near.points; // linear, so that interpolation is exact
  Surface far = near, back = near;
  far.points.row(2).setConstant(-5);
  far.vectors.setConstant(7);
  back.points.row(2).setConstant(5);
  back.vectors.setConstant(9);
  back.normals = Points::Zero(3, back.points.cols());
  back.normals.row(2).setConstant(-1); // it faces away
  const auto sample = regular_sample({far, back, near}, 30);
  ASSERT_EQ(sample.size(), 16U);
  for (const auto& [at, vector] : sample) {
    EXPECT_NEAR(std::remainder(at[0], 30) + std::remainder(at[1], 30), 0, 1e-9);
    EXPECT_LT((vector - 2 * at).norm(), 1e-9);
  }
}

TEST(Vectors, HaveOneScaleAndAKey) {
  Body body = square(along_x);
  body.skin.vectors = Points::Zero(3, body.skin.points.cols());
  body.skin.vectors.row(0).setConstant(0.25);
  PictureOptions options;
  options.vectors = "displacement";
  options.vector_unit = "mm";
  std::vector<Panel> panels = {{"", {body}}};
  panels[0].vectors = {{{0.5, 0.5, 0}, {0, 0.5, 0}}};
  const Plate plate = make_plate(panels, options);
  EXPECT_TRUE(has_text(plate, "displacement 0.5 mm"));
  options.longest_vector = 5; // of another state
  EXPECT_TRUE(has_text(make_plate(panels, options), "displacement 5 mm"));
  const auto shafts = strokes_of(plate, [](const Stroke& one) { return one.color == ink && one.points.size() == 2; });
  EXPECT_GT(shafts.size(), 50U);
}

TEST(Mirror, RemovesTheFarSide) {
  Body body = square(along_x);
  body.skin.points.row(0).array() -= 0.3;
  body.mesh_lines[0].points.row(0).array() -= 0.3;
  join_at_mirror(body, 0);
  EXPECT_EQ(body.skin.points.row(0).minCoeff(), 0);
  EXPECT_NEAR(body.skin.points.row(0).maxCoeff(), 0.7, 1e-12);
  EXPECT_LT((body.skin.values.transpose() - body.skin.points.row(0)).array().abs().maxCoeff() - 0.3, 1e-12);
  EXPECT_EQ(body.mesh_lines[0].points.row(0).minCoeff(), 0);
  Body block = mapped_solid(block_map({-1, -3, 0}, {2, 1, 1}), {2, 2, 1}, 4, along_x);
  join_at_mirror(block, 1);
  EXPECT_NEAR(block.skin.points.row(1).maxCoeff(), 0, 1e-9);
  EXPECT_NEAR(block.skin.points.row(1).minCoeff(), -3, 1e-9);
  // Open at the mirror, where its image closes it.
  EXPECT_NEAR(area(block.skin), 2 * 3 * 3 + 2 * 3 * 1 + 3 * 1, 1e-9);
}

TEST(ReferenceShape, IsDashedOverSolids) {
  Body block = mapped_solid(block_map({0, 0, 0}, {1, 1, 1}), {1, 1, 1}, 2, along_x);
  PictureOptions options;
  options.camera = camera("iso");
  const auto dashed = [&] {
    return strokes_of(make_plate(std::vector<Panel>{{"", {block}}}, options),
                      [](const Stroke& one) { return !one.dash.empty(); })
        .size();
  };
  EXPECT_EQ(dashed(), 0U);
  block.undeformed = block.skin;
  block.undeformed_rim = block.rim;
  EXPECT_GE(dashed(), 9U); // three faces are visible
}

TEST(Axes, HaveTheGivenNames) {
  PictureOptions options;
  options.unit = "m";
  options.axes = {"r / mm", "depth / mm"};
  const Plate plate = make_plate(std::vector<Panel>{{"", {square(along_x)}}}, options);
  EXPECT_TRUE(has_text(plate, "r / mm") && has_text(plate, "depth / mm") && !has_text(plate, "x (m)"));
  PictureOptions solid;
  solid.camera = camera("iso");
  solid.axes = {"radius", "hoop", "height"};
  const Body block = mapped_solid(block_map({0, 0, 0}, {1, 1, 1}), {1, 1, 1}, 2);
  const Plate deep = make_plate(std::vector<Panel>{{"", {block}}}, solid);
  EXPECT_TRUE(has_text(deep, "radius") && has_text(deep, "hoop") && has_text(deep, "height") && !has_text(deep, "x"));
}

} // namespace surface_lines_test
} // namespace signorini::view
