#pragma once
// Synthetic bodies and curves that resemble those of a study.

#include "view/chart.hpp"
#include "view/picture.hpp"

#include <functional>
#include <string>

namespace signorini::view {

/// A surface in the plane of columns × rows pieces; `place` gives its point at (u, v), both 0 … 1.
Surface plane_surface(const std::array<int, 2>& pieces, const std::function<Vec<3>(double, double)>& place);

/// A slightly deformed quarter ring, finely tessellated, with a value per point, `across` × `around` elements and a
/// control net.
Body bent_ring(Vec<2> center, double inner, double outer, double start_degrees, int around, int across);

/// Noisy periodic forces over load steps, one series per label.
std::vector<Series> oscillating_forces(int count);

/// Errors that decrease with the number of unknowns, in double-logarithmic scales.
std::vector<Series> convergence_lines();

/// Width and height from the header of a PNG; zeros for other bytes.
std::array<int, 2> png_size(const std::string& bytes);

inline std::string picture_of(const std::vector<Panel>& panels, const PictureOptions& options) {
  return bytes_of(figure_of(make_plate(panels, options)), Format::png, options.transparent);
}
inline std::string chart_of(const std::vector<Series>& series, const ChartOptions& options = {},
                            Format format = Format::svg) {
  return bytes_of(chart_figure(series, options), format);
}

} // namespace signorini::view
