#include "nurbs/archive.hpp"

namespace signorini::nurbs {

namespace {

/// Written in place of the thickness direction for a discretization by its recipe.
constexpr int by_recipe = -1;

/// Written in place of the degree for a space without knots.
constexpr int no_knots = -1;

} // namespace

void write(ArchiveWriter& to, const KnotVector& knots) {
  to.put(knots.degree(), knots.knots());
}

KnotVector read(ArchiveReader& from, std::type_identity<KnotVector>) {
  const int degree = from.get<int>();
  return {degree, from.get<std::vector<double>>()};
}

void write(ArchiveWriter& to, const Space1D& space) {
  if (space.knots()) return to.put(*space.knots());
  to.put(no_knots, static_cast<std::uint64_t>(space.elements()));
  for (int e = 0; e < space.elements(); ++e) {
    const auto& [degree, functions, extraction] = space.element(e);
    to.put(degree, functions, extraction);
  }
  to.put(space.breaks(), space.smoothness());
}

Space1D read(ArchiveReader& from, std::type_identity<Space1D>) {
  const int degree = from.get<int>();
  if (degree != no_knots) return spline_space({degree, from.get<std::vector<double>>()});
  std::vector<Element1D> elements;
  for (std::size_t count = from.count(); elements.size() < count;) {
    auto& [p, functions, extraction] = elements.emplace_back();
    from.into(p, functions, extraction);
  }
  auto breaks = from.get<std::vector<double>>();
  return {std::move(breaks), from.get<std::vector<int>>(), elements};
}

namespace {

std::vector<std::string> texts(const std::vector<Label>& labels) {
  std::vector<std::string> result;
  for (const Label& label : labels) result.push_back(label.text);
  return result;
}

} // namespace

auto members(Grading& grading) {
  auto& [elements, length, at_end] = grading;
  return std::tie(elements, length, at_end);
}

Side read(ArchiveReader& from, std::type_identity<Side>) {
  const int direction = from.get<int>();
  require(direction >= 0 && direction < 3, "nurbs.archive.side", {{"direction", direction}});
  return {direction, from.get<bool>()};
}

namespace {

/// Throws Error if there are more elements than the reader accepts; `counts`: per direction.
void check_elements(const ArchiveReader& from, const std::vector<int>& counts) {
  std::size_t left = from.limits().elements;
  for (const int count : counts) {
    require(count >= 1 && static_cast<std::size_t>(count) <= left, "nurbs.archive.elements",
            {{"most", from.limits().elements}});
    left /= static_cast<std::size_t>(count);
  }
}

/// Throws Error if one of the sides does not exist.
void check_sides(const std::vector<Side>& sides, int directions) {
  for (const Side& side : sides)
    require(side.direction < directions, "nurbs.archive.side", {{"direction", side.direction}});
}

} // namespace

void write(ArchiveWriter& to, const Recipe& recipe) {
  const auto& [elements, grading, labels, contact, thickness_degree, raised, layer_knots] = recipe.plan;
  to.put(recipe.patch, elements, grading, texts(labels), contact, thickness_degree, raised, layer_knots);
}

Recipe read(ArchiveReader& from, std::type_identity<Recipe>) {
  Recipe recipe{from.get<Patch>(), {}};
  auto& [elements, grading, labels, contact, thickness_degree, raised, layer_knots] = recipe.plan;
  from.into(elements, grading);
  for (const std::string& text : from.get<std::vector<std::string>>()) labels.push_back(parse_label(text));
  from.into(contact, thickness_degree, raised, layer_knots);
  check_elements(from, elements);
  check_sides(contact, recipe.patch.parametric_dimension());
  return recipe;
}

void write(ArchiveWriter& to, const Discretization& space) {
  if (space.recipe()) return to.put(by_recipe, *space.recipe());
  to.put(space.through(), space.stack(), space.rows(), space.contact());
}

Discretization read(ArchiveReader& from, std::type_identity<Discretization>) {
  const int through = from.get<int>();
  if (through == by_recipe) {
    const auto recipe = from.get<Recipe>();
    return {recipe.patch, recipe.plan};
  }
  auto stack = from.get<Space1D>();
  auto rows = from.get<std::vector<Row>>();
  auto contact = from.get<std::vector<Side>>();
  require(!rows.empty(), "nurbs.body.rows", {{"expected", stack.functions()}, {"count", 0}});
  std::vector<int> counts{stack.elements()};
  for (const Space1D& space : rows.front().directions()) counts.push_back(space.elements());
  check_elements(from, counts);
  check_sides(contact, static_cast<int>(counts.size()));
  return {through, std::move(stack), std::move(rows), std::move(contact)};
}

} // namespace signorini::nurbs
