#include "view/figure.hpp"

#include "base/error.hpp"
#include "view/renderer.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace signorini::view {

Figure figure_of(Plate plate) {
  Figure figure{plate.drawing.size, {}};
  figure.plates.push_back({{0, 0}, std::move(plate)});
  return figure;
}

std::string file_ending(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

Format format_of(const std::string& file) {
  const std::string ending = file_ending(file);
  if (ending == ".png") return Format::png;
  if (ending == ".svg") return Format::svg;
  if (ending == ".pdf") return Format::pdf;
  fail("view.file.ending", {{"file", file}});
}

std::string bytes_of(const Figure& figure, Format format, bool transparent) {
  return flat_renderer().bytes(figure, format, transparent, image_of);
}

} // namespace signorini::view
