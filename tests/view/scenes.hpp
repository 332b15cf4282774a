#pragma once
// Synthetic bodies and curves that resemble those of a study.

#include "os/whole_file.hpp"
#include "view/chart.hpp"
#include "view/picture.hpp"

#include <string>

namespace signorini::view {

/// A slightly deformed quarter ring, finely tessellated, with a value per point, `across` × `around` elements and a
/// control net.
Body bent_ring(Vec<2> center, double inner, double outer, double start_degrees, int around, int across);

/// Noisy periodic forces over load steps, one series per label.
std::vector<Series> oscillating_forces(int count);

/// Errors that decrease with the number of unknowns, in double-logarithmic scales.
std::vector<Series> convergence_lines();

std::string file_bytes(const std::string& file);

/// A file in a folder of this process, which is removed at its end.
std::string scratch(const std::string& name);

/// Width and height from the header of a PNG file; zeros for other files.
std::array<int, 2> png_size(const std::string& bytes);

/// Draws states to a file.
inline void draw_states(const std::vector<Panel>& panels, const PictureOptions& options, const std::string& file) {
  write_record(file, bytes_of(figure_of(make_plate(panels, options)), format_of(file), options.transparent));
}
inline void draw_chart(const std::vector<Series>& series, const ChartOptions& options, const std::string& file) {
  write_record(file, bytes_of(chart_figure(series, options), format_of(file)));
}
inline void draw_picture(const std::vector<Body>& bodies, const PictureOptions& options, const std::string& file) {
  draw_states(std::vector<Panel>{{"", bodies}}, options, file);
}

} // namespace signorini::view
