#include "view/series.hpp"

#include "base/error.hpp"
#include "base/match.hpp"
#include "os/process.hpp"
#include "os/whole_file.hpp"
#include "view/figure.hpp"
#include "view/parts_folder.hpp"

#include <algorithm>
#include <filesystem>

namespace signorini::view {
namespace {

namespace fs = std::filesystem;

/// The parts of the file's path before and after the number in its name, and the minimum number of digits.
struct Pattern {
  std::string before, after;
  int digits;

  std::string operator()(int number) const {
    const std::string figures = std::to_string(number);
    const std::size_t zeros = static_cast<std::size_t>(digits) - std::min<std::size_t>(digits, figures.size());
    return before + std::string(zeros, '0') + figures + after;
  }
};

Pattern pattern_of(const std::string& file) {
  const fs::path path(file);
  const auto found = match(path.filename().string(), "([^%]*)%(0([1-9]))?d([^%]*)");
  require(!found.empty(), "view.series.number", {{"file", file}});
  format_of(file);
  return {(path.parent_path() / found[1]).string(), found[4], found[3].empty() ? 1 : std::stoi(found[3])};
}

void write_pictures(const Pattern& name, FileKind kind, int count, const PictureMaker& picture) {
  for (int i = 0; i < count; ++i) write_output(name(i + 1), picture(i), kind);
}

void write_film(const std::string& file, int count, double rate, const PictureMaker& picture) {
  require(has_program("ffmpeg"), "view.film.ffmpeg", {{"file", file}});
  const PartsFolder folder(check_output(file, FileKind::mp4));
  write_pictures({folder.path(""), ".png", 1}, FileKind::png, count, picture);
  // H.264 with chroma subsampling, which all players support, requires even sizes.
  try {
    run_program({"ffmpeg", "-loglevel", "error", "-y", "-framerate", std::to_string(rate), "-i", folder.path("%d.png"),
                 "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white", "-c:v", "libx264", "-pix_fmt", "yuv420p",
                 folder.path("film.mp4")});
  } catch (const Error& error) {
    fail("view.film.failed", {{"file", file}, {"reason", error.message()}});
  }
  move_output(folder.path("film.mp4"), file, FileKind::mp4);
}

} // namespace

bool is_film(const std::string& file) {
  return file_ending(file) == ".mp4";
}

bool is_series(const std::string& file) {
  return fs::path(file).filename().string().find('%') != std::string::npos || is_film(file);
}

Format series_format(const std::string& file) {
  return is_film(file) ? Format::png : format_of(file);
}

std::string film_description() {
  return has_program("ffmpeg") ? ".mp4 by ffmpeg" : "no .mp4, ffmpeg is not in PATH";
}

void write_series(const std::string& file, int count, double rate, const PictureMaker& picture) {
  if (is_film(file))
    write_film(file, count, rate, picture);
  else
    write_pictures(pattern_of(file), kind_of(format_of(file)), count, picture);
}

} // namespace signorini::view
