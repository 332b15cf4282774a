#include "scenes.hpp"

#include "base/error.hpp"
#include "view/obstacle.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace signorini::view {
namespace {

/// The point of the ring at u along the arc and v across the wall, both 0 … 1.
struct Ring {
  Vec<2> center;
  double inner, outer, start;

  Vec<3> operator()(double u, double v) const {
    const double angle = (start + 90 * u) * std::numbers::pi / 180;
    const double radius = outer + v * (inner - outer) + 0.02 * std::sin(6 * angle);
    return {center[0] + radius * std::cos(angle), center[1] + radius * std::sin(angle), 0};
  }

  Points line(Vec<2> from, Vec<2> to) const {
    Points points(3, 33);
    for (int i = 0; i < 33; ++i) {
      const Vec<2> at = from + (to - from) * (i / 32.0);
      points.col(i) = (*this)(at[0], at[1]);
    }
    return points;
  }
};

} // namespace

Surface plane_surface(const std::array<int, 2>& pieces, const std::function<Vec<3>(double, double)>& place) {
  Surface surface = tessellated(pieces, {}, [&](double u, double v) {
    return SurfacePlace{place(u, v), Vec<3>::Zero()};
  });
  surface.normals.resize(3, 0);
  return surface;
}

Body bent_ring(Vec<2> center, double inner, double outer, double start_degrees, int around, int across) {
  const Ring ring{center, inner, outer, start_degrees};
  const int nu = 12 * around, nv = 12 * across;
  Body body;
  body.skin = plane_surface({nu, nv}, ring);
  body.skin.values.resize(body.skin.points.cols());
  for (int j = 0, k = 0; j <= nv; ++j)
    for (int i = 0; i <= nu; ++i, ++k)
      body.skin.values[k] = 0.4 * std::sin(3.0 * i / nu) * std::cos(2.0 * j / nv) - 0.1 * center[1];
  for (int i = 0; i <= around; ++i)
    body.mesh_lines.push_back({ring.line({double(i) / around, 0}, {double(i) / around, 1}), {}, 1.5 * outer / around});
  for (int j = 0; j <= across; ++j)
    body.mesh_lines.push_back(
        {ring.line({0, double(j) / across}, {1, double(j) / across}), {}, (outer - inner) / across});

  const int columns = around + 2, rows = across + 1;
  body.control_points.resize(3, columns * rows);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const double u = double(i) / (columns - 1);
      const Vec<3> middle{center[0], center[1], 0};
      const double outside = i == 0 || i == columns - 1 ? 1 : 1.02; // control points of a curve lie outside its arc
      body.control_points.col(j * columns + i) = middle + outside * (ring(u, double(j) / (rows - 1)) - middle);
      if (i > 0) body.net_lines.push_back({j * columns + i - 1, j * columns + i});
      if (j > 0) body.net_lines.push_back({(j - 1) * columns + i, j * columns + i});
    }
  return body;
}

std::vector<Series> oscillating_forces(int count) {
  const char* labels[] = {"N2", "N4", "N6", "N2-N4", "N2-N6", "N2-N2.1", "N2-N2.2", "N2-N2.3"};
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-0.004, 0.004);
  std::vector<Series> series;
  for (int n = 0; n < count; ++n) {
    Series s;
    s.label = labels[n % 8];
    for (int step = 1; step <= 296; ++step) {
      const double ramp = std::min(1.0, step / 46.0);
      const double wave = step > 46 ? 0.03 / (1 + n) * std::sin(step * 0.28 + n) : 0;
      s.x.push_back(step);
      s.y.push_back(0.3 * ramp + (step > 46 ? wave : 0) + 0.05 * n * ramp + noise(random));
    }
    series.push_back(s);
  }
  return series;
}

std::vector<Series> convergence_lines() {
  std::vector<Series> series;
  for (int order = 1; order <= 4; ++order) {
    Series s;
    s.label = text("N", order, ", slope −", order + 1);
    s.markers = true;
    s.dashed = order % 2 == 0;
    for (double n = 8; n <= 600; n *= 2) {
      s.x.push_back(n * n);
      s.y.push_back(0.4 * std::pow(4 / n, order + 1) * (1 + 0.1 * std::sin(n)));
    }
    series.push_back(s);
  }
  return series;
}

std::array<int, 2> png_size(const std::string& bytes) {
  if (bytes.size() < 24 || bytes.compare(1, 3, "PNG") != 0) return {0, 0};
  const auto word = [&](int at) {
    int value = 0;
    for (int i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
  };
  return {word(16), word(20)};
}

} // namespace signorini::view
