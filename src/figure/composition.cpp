#include "base/error.hpp"
#include "figure/picture.hpp"
#include "view/compose.hpp"
#include "view/sheet.hpp"

#include <algorithm>
#include <map>

namespace signorini::figure {

namespace {

using Range = std::array<double, 2>;

/// The contents at one position of the layout for all pictures of a film; a single entry for a picture alone.
template <class Content> using Film = std::vector<const Content*>;

/// Size and style given to a picture.
struct Paper {
  std::array<int, 2> size;
  bool trim = true;
  std::optional<view::Style> style = {};
  std::vector<view::Bar> bars = {}; ///< of all parts: the largest determines the common layout
};

/// A part of a figure, drawn when its paper is known.
struct Part {
  std::function<view::Figure(int picture, const Paper& paper)> draw;
  std::vector<view::Bar> bars = {};
};

/// The color ranges that a sheet passes to its parts.
struct Ranges {
  std::optional<Range> given;
  std::map<std::string, Range> by_label;
  bool several_parts = false;           ///< ranges must then be known before drawing
  std::optional<view::Box> extent = {}; ///< shown by all parts

  std::optional<Range> of(const view::PictureOptions& options) const {
    if (options.field_label.empty()) return std::nullopt;
    if (given || options.range) return given ? given : options.range;
    const auto found = by_label.find(options.field_label);
    return found == by_label.end() ? std::nullopt : std::optional(found->second);
  }
};

// ── States on one plate ──────────────────────────────────────────────────────────────────────────────────────────────

struct Plates {
  struct One {
    std::vector<view::Panel> panels;
    view::PictureOptions options;
    std::optional<view::PictureOptions> inset;
  };
  std::vector<One> film;
  std::map<std::array<int, 2>, view::CloseUpPlan> plans = {}; ///< positions of insets, computed once per film

  view::PictureOptions options(int picture, const Paper& paper) const {
    view::PictureOptions all = film[picture].options;
    all.size = paper.size;
    all.trim = paper.trim;
    all.style = paper.style;
    all.adjacent_bars = paper.bars;
    return all;
  }
};

view::Figure draw_plate(Plates& plates, int picture, const Paper& paper) {
  const auto& film = plates.film;
  const auto whole = [&](int of, const std::optional<view::Box>& extent) {
    view::PictureOptions larger = plates.options(of, paper);
    if (extent) larger.extent = extent;
    return view::make_plate(film[of].panels, larger);
  };
  if (!film[picture].inset) return view::figure_of(whole(picture, {}));
  const auto detail = [&](int of, int state, const std::array<int, 2>& most) {
    view::PictureOptions own = *film[of].inset;
    own.size = most;
    own.style = view::close_up_style(view::style_of(plates.options(of, paper)));
    std::vector<view::Panel> alone = {film[of].panels[state]};
    alone[0].title.clear();
    return view::make_plate(alone, own);
  };
  auto plan = plates.plans.find(paper.size);
  if (plan == plates.plans.end()) {
    const int count = std::ssize(film);
    plan = plates.plans.emplace(paper.size, view::plan_close_ups(count, whole, detail)).first;
  }
  return view::with_close_ups(picture, plan->second, whole, detail);
}

/// One color range and arrow scale for all states, and in a film one frame.
void align_plates(Plates& plates, const Ranges& ranges) {
  auto& film = plates.film;
  double longest = 0;
  for (auto& one : film) {
    one.options.range = ranges.of(one.options);
    longest = std::max(longest, view::longest_vector(one.panels));
  }
  const view::PictureOptions& first = film[0].options;
  const bool moves = film.size() > 1, ranged = first.range || first.field_label.empty();
  if (moves || (!ranged && (film[0].inset || ranges.several_parts))) {
    std::vector<view::Panel> all;
    for (const auto& one : film) all.insert(all.end(), one.panels.begin(), one.panels.end());
    view::PictureOptions whole = first;
    view::align(whole, all);
    std::optional<view::Box> extent = whole.extent;
    for (auto& one : film) {
      if (!one.options.range) one.options.range = whole.range;
      if (one.options.camera == first.camera) continue;
      view::PictureOptions turned = one.options;
      view::align(turned, one.panels);
      extent = view::hull({*extent, *turned.extent});
    }
    for (auto& one : film)
      if (moves && !one.options.crop) one.options.extent = extent;
  }
  for (auto& one : film) {
    if (ranges.extent && !one.options.crop) one.options.extent = ranges.extent;
    one.options.longest_vector = longest;
    if (one.inset) one.inset->range = one.options.range, one.inset->longest_vector = longest;
  }
}

/// `sheets`: of a film of sheets; empty: each state is drawn alone.
Part plates_part(const std::vector<Film<StatePicture>>& states, const Film<SheetPicture>& sheets,
                 const Ranges& ranges) {
  const auto plates = std::make_shared<Plates>();
  for (std::size_t k = 0; k < states.size(); ++k) {
    Plates::One& one = plates->film.emplace_back(Plates::One{{}, states[k][0]->options, states[k][0]->inset});
    for (const StatePicture* state : states[k]) {
      one.panels.push_back(state->panel);
      if (!sheets.empty()) one.panels.back().title = state->options.title;
    }
    if (!sheets.empty()) one.options.title = sheets[k]->title, one.options.columns = sheets[k]->columns;
    // Empty parts and cuts without effect are errors.
    check_part(one.panels, one.options, "crop");
    if (one.inset) check_part(one.panels, *one.inset, "inset");
    check_cuts(one.panels);
  }
  align_plates(*plates, ranges);
  Part part{[plates](int picture, const Paper& paper) { return draw_plate(*plates, picture, paper); }};
  const view::PictureOptions& first = plates->film[0].options;
  if (first.range && !first.field_label.empty()) part.bars.push_back({*first.range, first.field_label});
  return part;
}

// ── Pictures side by side ────────────────────────────────────────────────────────────────────────────────────────────

Part part_of(const Film<Picture>& film, const Ranges& ranges);

bool alike(const view::PictureOptions& a, const view::PictureOptions& b) {
  return a.field_label == b.field_label && a.range == b.range && a.colormap == b.colormap && a.crop == b.crop &&
         a.camera == b.camera && a.unit == b.unit && a.bar == b.bar && a.ruler == b.ruler && a.contours == b.contours &&
         a.vectors == b.vectors && a.axes == b.axes;
}

/// The states of a sheet that contains nothing else and draws all with the same options.
std::optional<Film<StatePicture>> states_of(const SheetPicture& sheet) {
  Film<StatePicture> states;
  for (const Picture& part : sheet.parts) {
    const auto* state = std::get_if<StatePicture>(part.content.get());
    if (!state) return std::nullopt;
    states.push_back(state);
    const StatePicture& first = *states.front();
    const bool insets = state->inset && first.inset ? alike(*state->inset, *first.inset)
                                                    : state->inset.has_value() == first.inset.has_value();
    if (!insets || !alike(state->options, first.options)) return std::nullopt;
  }
  return states;
}

/// Key: label, and whether the states are in space.
using StatesByLabel = std::map<std::pair<std::string, bool>, Film<StatePicture>>;

/// Collects the states in a picture that have no range of their own.
void gather_states(const Picture& picture, StatesByLabel& found) {
  if (const auto* state = std::get_if<StatePicture>(picture.content.get())) {
    const view::PictureOptions& options = state->options;
    if (!options.range && !options.field_label.empty())
      found[{options.field_label, options.camera.has_value()}].push_back(state);
  } else if (const auto* sheet = std::get_if<SheetPicture>(picture.content.get())) {
    if (!sheet->own_ranges && !sheet->range)
      for (const Picture& part : sheet->parts) gather_states(part, found);
  }
}

/// Range and extent of states that are all plane or all in space.
view::PictureOptions aligned(const Film<StatePicture>& states) {
  std::vector<view::Panel> panels;
  for (const StatePicture* state : states) panels.push_back(state->panel);
  view::PictureOptions options = states.front()->options;
  view::align(options, panels);
  return options;
}

Ranges ranges_of(const Film<SheetPicture>& film, const Ranges& outer) {
  Ranges ranges = film[0]->own_ranges ? Ranges{} : outer;
  ranges.several_parts = film[0]->parts.size() > 1;
  if (film[0]->range) ranges.given = film[0]->range;
  if (film[0]->own_ranges || ranges.given || !ranges.by_label.empty()) return ranges;
  StatesByLabel found;
  for (const SheetPicture* sheet : film)
    for (const Picture& part : sheet->parts) gather_states(part, found);
  for (const auto& [key, states] : found)
    if (const auto own = aligned(states).range) {
      Range& range = ranges.by_label.try_emplace(key.first, *own).first->second;
      range = {std::min(range[0], (*own)[0]), std::max(range[1], (*own)[1])};
    }
  return ranges;
}

Part sheet_part(const Film<SheetPicture>& film, const Ranges& outer) {
  const SheetPicture& first = *film[0];
  std::vector<Film<StatePicture>> states;
  for (const SheetPicture* sheet : film)
    if (auto found = states_of(*sheet)) states.push_back(std::move(*found));
  const bool one_way = states.size() == film.size();
  if (one_way && (!first.own_ranges || first.parts.size() == 1)) {
    Ranges ranges = outer;
    if (first.range) ranges.given = first.range;
    return plates_part(states, film, ranges);
  }
  Ranges ranges = ranges_of(film, outer);
  if (one_way && film.size() == 1) ranges.extent = aligned(states[0]).extent;
  std::vector<Part> parts;
  Part whole;
  for (std::size_t i = 0; i < first.parts.size(); ++i) {
    Film<Picture> at_place;
    for (const SheetPicture* sheet : film) at_place.push_back(&sheet->parts[i]);
    parts.push_back(part_of(at_place, ranges));
    whole.bars.insert(whole.bars.end(), parts.back().bars.begin(), parts.back().bars.end());
  }
  std::vector<std::string> titles;
  for (const SheetPicture* sheet : film) titles.push_back(sheet->title);
  whole.draw = [parts, titles, bars = whole.bars, columns = first.columns](int picture, const Paper& paper) {
    view::PictureOptions options;
    options.title = titles[picture];
    options.size = paper.size;
    options.trim = paper.trim;
    options.style = paper.style;
    options.columns = columns;
    const auto part = [&](int i, const std::array<int, 2>& most) {
      const Paper own{most, true, view::part_style(most, view::style_of(options)),
                      parts.size() > 1 ? bars : std::vector<view::Bar>()};
      return parts[i].draw(picture, own);
    };
    return view::side_by_side(static_cast<int>(parts.size()), options, part);
  };
  return whole;
}

/// The contents of the pictures of a film at one position, which must be of one kind.
template <class Content> Film<Content> contents(const Film<Picture>& film) {
  Film<Content> all;
  for (const Picture* one : film) all.push_back(std::get_if<Content>(one->content.get()));
  return all;
}

void check_kinds(const Film<Picture>& film) {
  const auto parts = [](const Picture& of) {
    const auto* sheet = std::get_if<SheetPicture>(of.content.get());
    return sheet ? sheet->parts.size() : 0;
  };
  const auto solid = [](const Picture& of) {
    const auto* state = std::get_if<StatePicture>(of.content.get());
    return state && state->options.camera;
  };
  for (const Picture* one : film)
    require(one->content->index() == film[0]->content->index() && parts(*one) == parts(*film[0]) &&
                solid(*one) == solid(*film[0]),
            "figure.film.contents", {{"other", one->description}, {"first", film[0]->description}});
}

Part part_of(const Film<Picture>& film, const Ranges& ranges) {
  check_kinds(film);
  if (std::holds_alternative<SheetPicture>(*film[0]->content)) return sheet_part(contents<SheetPicture>(film), ranges);
  if (std::holds_alternative<StatePicture>(*film[0]->content)) {
    std::vector<Film<StatePicture>> states;
    for (const StatePicture* one : contents<StatePicture>(film)) states.push_back({one});
    return plates_part(states, {}, ranges);
  }
  std::vector<Picture> flat;
  for (const Picture* one : film) flat.push_back(*one);
  return {[flat](int picture, const Paper& paper) {
    const Picture& one = flat[picture];
    const auto& [width, height] = one.size;
    const double factor = std::min(1.0 * paper.size[0] / width, 1.0 * paper.size[1] / height);
    const std::array<int, 2> size = {static_cast<int>(factor * width + 0.5), static_cast<int>(factor * height + 0.5)};
    return std::get<FlatPicture>(*one.content).make(size);
  }};
}

} // namespace

std::function<view::Figure(int picture)> figures_of(const std::vector<Picture>& film) {
  Film<Picture> all;
  for (const Picture& one : film) all.push_back(&one);
  const Paper paper{film[0].size, film[0].trim};
  return [film, part = part_of(all, {}), paper](int picture) { return part.draw(picture, paper); };
}

Picture fitted(const Picture& picture, const std::array<int, 2>& most) {
  Picture fit = picture;
  const double factor = std::min(1.0 * most[0] / picture.size[0], 1.0 * most[1] / picture.size[1]);
  for (int& side : fit.size) side = static_cast<int>(factor * side + 0.5);
  return fit;
}

} // namespace signorini::figure
