#pragma once
// The frame round a plot: scales, ticks, grid, labels.

#include "view/drawing.hpp"
#include "view/text.hpp"

#include <string>
#include <vector>

namespace signorini::view {

struct Ticks {
  std::vector<double> at;
  std::vector<std::string> labels; ///< one per tick
  std::vector<double> minor;       ///< unlabeled marks between them
  std::string factor;              ///< common power of ten of all labels, "×10⁻³", or empty
  std::vector<FittedText> names;   ///< empty, or one per tick, as its label is drawn
  bool upright = false;            ///< names read from bottom to top
  double depth = 0;                ///< pixels that names take below the row that numbers would stand in
};

/// A value with three digits at most, as in −1.32×10^{-4}.
std::string in_digits(double value);

/// Fails where a range [low, high] is too wide or too narrow to be divided in double precision.
void require_drawable(double low, double high, bool log);

/// At most `count` (≥ 2) round numbers 1, 2, 5 × 10ᵏ apart within [low, high]. Needs low < high.
Ticks linear_ticks(double low, double high, int count);

/// Powers of ten within [low, high]; below a decade and a half 2 and 5 times them, too; below a factor of 5, where
/// these are few, round numbers as on a linear axis. With minor ticks between. Needs 0 < low < high.
Ticks log_ticks(double low, double high, int count);

/// Sizes in pixels that follow the figure's own size.
struct Style {
  double unit;       ///< 1 in a figure of 1600 × 1000
  double tick_size;  ///< of the numbers
  double label_size; ///< of axis labels and legends
  double title_size;
  double margin; ///< at the figure's rim
};

/// The size in pixels that texts shrink to at most before they are cut short: 18 in a figure of 1600 × 1000.
double least_size(const Style& style);

/// Throws Error on a size below 160 × 120 or above 5000 pixels a side (OpenGL's limit after supersampling).
Style style_for(const std::array<int, 2>& size);

/// A place on an axis with a text of its own.
struct Name {
  double at;
  std::string text;
};

/// One axis: values from low to high on pixels from `from` to `to`.
struct Scale {
  double low, high;
  bool log;
  double from, to;

  double operator()(double value) const;
};

struct Frame {
  Box box; ///< of the plot, in pixels
  Scale x, y;
  Ticks xticks, yticks;
  std::string xlabel, ylabel;
};

/// Room in pixels that numbers and label need below the box, or left of it.
double room_below(const Style& style, const std::string& label);
double room_left(const Style& style, const Ticks& ticks, const std::string& label);

/// As many ticks along x as have room for their numbers.
Ticks fitting_ticks(double low, double high, bool log, double pixels, const Style& style);
/// The same along y, where only the height of a number counts.
Ticks stacked_ticks(double low, double high, bool log, double pixels, const Style& style);
/// The names within the scale as ticks along x: side by side, smaller or on several lines; upright where that is not
/// enough and `most` pixels below the numbers' row allow it. What does not fit is cut short; upright names, and
/// numbers, that would lie on each other are left out.
/// `within_cells`: nor is the first or the last one wider than its cell.
Ticks named_ticks(const std::vector<Name>& names, const Scale& scale, double most, const Style& style,
                  bool within_cells = false);
/// The same along y, level names one above the other; `most`: pixels that they may take to the left.
Ticks stacked_names(const std::vector<Name>& names, const Scale& scale, double most, const Style& style);

/// From where to where numbers or names below the box reach, pixels.
std::array<double, 2> reach_of_ticks(const Frame& frame, const Style& style);

void fill_box(Drawing& drawing, const Box& box, const Rgb& color);
void draw_grid(Drawing& drawing, const Frame& frame, const Style& style);
void draw_frame(Drawing& drawing, const Frame& frame, const Style& style);
/// Its numbers, names and labels alone.
void draw_labels(Drawing& drawing, const Frame& frame, const Style& style);

/// Pixels for a title above a box, on up to three lines; and for the air above a box without one.
double title_room(const std::string& title, double figure_width, const Style& style);

/// The title above the box, on as many lines as there is room for, smaller or cut short where it is too long for these.
void draw_title(Drawing& drawing, const std::string& title, const Box& box, const Style& style);

/// Lines of text from the first one's baseline on; upright ones go to the right.
void draw_lines(Drawing& drawing, const FittedText& text, Vec2 at, Align align, const Rgb& color, bool upright = false);

/// One line of text, smaller than `wanted` or cut short where it is longer than `room`.
void draw_fitting(Drawing& drawing, Text text, double room, const Style& style);

/// The greatest size up to `wanted` at which the text is no wider than `room`.
double fitting_size(const std::string& text, double wanted, double room);

} // namespace signorini::view
