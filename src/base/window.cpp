#include "base/window.hpp"

#include <algorithm>

namespace signorini {
namespace {

constexpr double deviation = 0.25; ///< pixels
constexpr int facets = 16;         ///< least number across a window where colors vary
constexpr int most_bisections = 14;

/// Bisects a rectangle of fractions as long as it is too coarse in a window.
class Bisection {
public:
  Bisection(const PointAt& place, const std::vector<Window>& windows, bool colored)
      : place_(place), windows_(windows), colored_(colored) {}

  void visit(const Vec<2>& low, const Vec<2>& high, int depth) {
    Eigen::Matrix<double, 3, 9> points; // corners, edge midpoints, center; the first direction fastest
    const Vec<2> half = 0.5 * (low + high);
    const std::array<double, 3> s = {low[0], half[0], high[0]}, t = {low[1], half[1], high[1]};
    for (int k = 0; k < 9; ++k) points.col(k) = place_(s[k % 3], t[k / 3]);
    std::array<bool, 2> split = {false, false};
    for (const Window& window : windows_)
      if (meets(window, points))
        for (int direction : {0, 1}) split[direction] |= is_coarse(window, points, direction);
    if (depth == most_bisections || (!split[0] && !split[1])) return;
    for (int direction : {0, 1})
      if (split[direction]) cuts[direction].push_back(half[direction]);
    for (int j = 0; j <= split[1]; ++j)
      for (int i = 0; i <= split[0]; ++i) {
        Vec<2> from = low, to = high;
        if (split[0]) (i == 0 ? to : from)[0] = half[0];
        if (split[1]) (j == 0 ? to : from)[1] = half[1];
        visit(from, to, depth + 1);
      }
  }

  std::array<std::vector<double>, 2> cuts;

private:
  /// With a margin for surfaces that bulge between the points.
  static bool meets(const Window& window, const Eigen::Matrix<double, 3, 9>& points) {
    const Eigen::Matrix<double, 2, 9> seen = window.axes * points;
    Vec<2> low = seen.rowwise().minCoeff(), high = seen.rowwise().maxCoeff();
    const double margin = 0.3 * (high - low).maxCoeff() + 0.05 * (window.high - window.low).maxCoeff();
    return (low.array() - margin <= window.high.array()).all() && (high.array() + margin >= window.low.array()).all();
  }

  bool is_coarse(const Window& window, const Eigen::Matrix<double, 3, 9>& points, int direction) const {
    const int step = direction == 0 ? 1 : 3, across = direction == 0 ? 3 : 1;
    const double most = (window.high - window.low).maxCoeff() / facets;
    for (int line = 0; line < 3; ++line) {
      const int first = across * line;
      const Vec<3> from = points.col(first), middle = points.col(first + step), to = points.col(first + 2 * step);
      if ((middle - 0.5 * (from + to)).norm() > deviation * window.pixel) return true;
      if (colored_ && (to - from).norm() > most) return true;
    }
    return false;
  }

  const PointAt& place_;
  const std::vector<Window>& windows_;
  bool colored_;
};

} // namespace

Window box_window(const Eigen::Matrix<double, 2, 3>& axes, const Vec<3>& low, const Vec<3>& high,
                  const std::array<int, 2>& size) {
  const Vec<2> center = 0.5 * axes * (low + high), half = 0.5 * axes.cwiseAbs() * (high - low);
  return {axes, center - half, center + half, std::max(2 * half[0] / size[0], 2 * half[1] / size[1])};
}

Window mirrored(Window window, int axis) {
  window.axes.col(axis) *= -1;
  return window;
}

std::array<std::vector<double>, 2> window_divisions(const PointAt& place, const std::vector<Window>& windows,
                                                    bool colored) {
  Bisection bisection(place, windows, colored);
  if (!windows.empty()) bisection.visit(Vec<2>::Zero(), Vec<2>::Ones(), 0);
  for (std::vector<double>& cuts : bisection.cuts) {
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  }
  return bisection.cuts;
}

void add_divisions(std::vector<double>& fractions, const std::vector<double>& cuts) {
  fractions.insert(fractions.end(), cuts.begin(), cuts.end());
  std::sort(fractions.begin(), fractions.end());
  const auto same = [](double a, double b) { return b - a < 1e-9; };
  fractions.erase(std::unique(fractions.begin(), fractions.end(), same), fractions.end());
}

std::vector<double> even_cuts(int pieces) {
  std::vector<double> fractions;
  for (int k = 0; k <= pieces; ++k) fractions.push_back(double(k) / pieces);
  return fractions;
}

} // namespace signorini
