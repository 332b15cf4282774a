#pragma once
// The frame of a plot: scales, ticks, grid, labels.

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
  std::vector<FittedText> names;   ///< empty, or one per tick, as drawn
  bool upright = false;            ///< names that read from bottom to top
  double depth = 0;                ///< pixels that names need below the row of numbers
};

/// A value with at most so many digits, as in −1.32×10^{-4}.
std::string in_digits(double value, int most = 3);

/// Fails when a range [low, high] is too wide or too narrow for double precision.
void require_drawable(double low, double high, bool log);

/// At most `count` (≥ 2) round numbers, 1, 2 or 5 × 10ᵏ apart, within [low, high]. Requires low < high.
Ticks linear_ticks(double low, double high, int count);

/// Powers of ten within [low, high]; over less than 1.5 decades also their multiples by 2 and 5; below a factor of 5,
/// if these are few, round numbers as on a linear axis. With minor ticks. Requires 0 < low < high.
Ticks log_ticks(double low, double high, int count);

/// Sizes in pixels, proportional to the size of the figure.
struct Style {
  double unit;       ///< 1 in a figure of 1600 × 1000
  double tick_size;  ///< of numbers
  double label_size; ///< of axis labels and legends
  double title_size;
  double margin; ///< at the edge of the figure
};

/// The minimum font size in pixels, below which texts are truncated: 18 in a figure of 1600 × 1000.
double least_size(const Style& style);

/// Throws Error on a size below 160 × 120 or above 5000 pixels per side.
Style style_for(const std::array<int, 2>& size);

/// A position on an axis with a text.
struct Name {
  double at;
  std::string text;
};

/// One axis: maps values from low to high to pixels from `from` to `to`.
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

/// Space in pixels that numbers and label need below the box, or left of it.
double room_below(const Style& style, const std::string& label);
double room_left(const Style& style, const Ticks& ticks, const std::string& label);

/// As many ticks along x as their numbers fit.
Ticks fitting_ticks(double low, double high, bool log, double pixels, const Style& style);
/// Ticks along y, where only the height of numbers counts.
Ticks stacked_ticks(double low, double high, bool log, double pixels, const Style& style);
/// The names within the scale as ticks along x: side by side, smaller or on several lines; upright if they still do not
/// fit and `most` pixels below the row of numbers suffice. Names that are too long are truncated; upright names and
/// numbers that would overlap are omitted. `within_cells`: the first and the last name are not wider than their cells
/// either.
Ticks named_ticks(const std::vector<Name>& names, const Scale& scale, double most, const Style& style,
                  bool within_cells = false);
/// Ticks along y, names one above the other; `most`: pixels that they may take to the left.
Ticks stacked_names(const std::vector<Name>& names, const Scale& scale, double most, const Style& style);

/// Leftmost and rightmost pixel of numbers or names below the box.
std::array<double, 2> reach_of_ticks(const Frame& frame, const Style& style);

void fill_box(Drawing& drawing, const Box& box, const Rgb& color);
void draw_grid(Drawing& drawing, const Frame& frame, const Style& style);
void draw_frame(Drawing& drawing, const Frame& frame, const Style& style);
/// Only numbers, names and labels.
void draw_labels(Drawing& drawing, const Frame& frame, const Style& style);

/// Pixels for a title of up to three lines above a box; and for the margin above a box without one.
double title_room(const std::string& title, double figure_width, const Style& style);

/// Draws the title above the box, on as many lines as fit, smaller or truncated where it is too long.
void draw_title(Drawing& drawing, const std::string& title, const Box& box, const Style& style);

/// Draws lines of text from the first baseline on; upright ones go to the right.
void draw_lines(Drawing& drawing, const FittedText& text, Vec2 at, Align align, const Rgb& color, bool upright = false);

/// Draws one line of text, smaller than `wanted` or truncated where it is longer than `space`.
void draw_fitting(Drawing& drawing, Text text, double space, const Style& style);

/// The largest size up to `wanted` at which the text is not wider than `space`.
double fitting_size(const std::string& text, double wanted, double space);

} // namespace signorini::view
