#include "view/categories.hpp"
#include "view/curves.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>

namespace signorini::view {
namespace palette_test {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Linear intensities of sRGB (IEC 61966-2-1).
Vector3d linear(const Rgb& color) {
  Vector3d result;
  for (int c = 0; c < 3; ++c) {
    const double v = color[c] / 255.0;
    result[c] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  }
  return result;
}

/// CIELAB (1976) relative to white.
Vector3d lab(const Vector3d& rgb) {
  const Matrix3d to_xyz{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}};
  const Vector3d xyz = to_xyz * rgb.cwiseMax(0).cwiseMin(1), white_point = to_xyz * Vector3d::Ones();
  Vector3d f;
  for (int c = 0; c < 3; ++c) {
    const double t = xyz[c] / white_point[c];
    f[c] = t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116;
  }
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

/// Color perception of dichromats, in linear intensities: Machado, Oliveira and Fernandes, IEEE Trans. Vis. Comput.
/// Graph. 15 (2009) 1291, severity 1.
struct Eye {
  const char* name;
  Matrix3d sees;
};

std::vector<Eye> eyes() {
  return {{"all three cones", Matrix3d::Identity()},
          {"protanopia",
           Matrix3d{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
          {"deuteranopia",
           Matrix3d{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}}};
}

double distance(const Eye& eye, const Rgb& a, const Rgb& b) {
  return (lab(eye.sees * linear(a)) - lab(eye.sees * linear(b))).norm();
}

TEST(Palette, AgreesWithTheLightnessFunction) {
  for (const Rgb& color : curve_colors()) EXPECT_NEAR(lab(linear(color))[0], lightness(color), 0.1);
}

// Okabe and Ito's own eight colors have a minimum difference of 17.0 here; 2.3 is just noticeable.
TEST(Palette, DistinguishesAllColorsAlsoForColorBlindReaders) {
  std::vector<Rgb> colors = curve_colors();
  ASSERT_EQ(colors.size(), 8u);
  colors.push_back(gray_color);
  for (const Eye& eye : eyes())
    for (std::size_t a = 0; a < colors.size(); ++a)
      for (std::size_t b = 0; b < a; ++b) EXPECT_GE(distance(eye, colors[a], colors[b]), 17) << eye.name << a << b;
}

} // namespace palette_test
} // namespace signorini::view
