// Names on shapes: selection and position.

#include "view/marks.hpp"

#include <gtest/gtest.h>

namespace signorini::view {
namespace names_test {

Frame frame() {
  Frame frame;
  frame.box = {0, 1000, 0, 1000};
  frame.x = {0, 1, false, 0, 1000};
  frame.y = {0, 1, false, 0, 1000};
  return frame;
}

std::vector<Text> texts(const Names& names) {
  Drawing drawing{{1000, 1000}, {}};
  draw_names(drawing, names, Mat<3>::Identity(), frame(), style_for({1000, 1000}));
  std::vector<Text> result;
  for (const Mark& mark : drawing.marks)
    if (const auto* text = std::get_if<Text>(&mark)) result.push_back(*text);
  return result;
}

void add(Names& names, const std::string& text, double x, double y) {
  Label& label = names.labels.emplace_back();
  label.at << x, y, 0;
  label.text = text;
}

TEST(Names, AreOmittedOnHiddenSidesAndOutsideTheFrame) {
  Names names;
  add(names, "front", 0.5, 0.5);
  add(names, "back", 0.5, 0.5);
  add(names, "far", 2, 2);
  names.labels[0].normal = Vec<3>(0, 0, -1);
  names.labels[1].normal = Vec<3>(0, 0, 1);
  const auto drawn = texts(names);
  ASSERT_EQ(drawn.size(), 1u);
  EXPECT_EQ(drawn[0].string, "back");
  EXPECT_DOUBLE_EQ(drawn[0].at[0], 500);
}

TEST(Names, AreShiftedFromTheirPositionAndStayInTheFrame) {
  Names names;
  add(names, "east", 0.5, 0.5);
  add(names, "corner", 0, 0);
  names.labels[0].shift = Vec<3>(-3, 0, 0);
  const auto drawn = texts(names);
  ASSERT_EQ(drawn.size(), 2u);
  EXPECT_LT(drawn[0].at[0], 490);
  EXPECT_GT(drawn[0].at[0], 400);
  EXPECT_GT(drawn[1].at[0], 20);
  EXPECT_GT(drawn[1].at[1], 0);
}

TEST(Names, HaveArrowsAlongTheLineNearestToTheEye) {
  Eigen::Matrix<double, 3, Eigen::Dynamic> low(3, 2), high(3, 2);
  low << 0.2, 0.4, 0.2, 0.2, 0, 0;
  high << 0.2, 0.4, 0.7, 0.7, 1, 1;
  Names names;
  Arrow& arrow = names.arrows.emplace_back();
  arrow.lines = {low, high};
  arrow.text = "ξ¹";
  const auto drawn = texts(names);
  ASSERT_EQ(drawn.size(), 1u);
  EXPECT_GT(drawn[0].at[0], 400);
  EXPECT_NEAR(drawn[0].at[1], 700, 10);
}

} // namespace names_test
} // namespace signorini::view
