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
  std::vector<Element1D> elements(from.count());
  for (auto& [p, functions, extraction] : elements) from.into(p, functions, extraction);
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
  return {through, std::move(stack), std::move(rows), from.get<std::vector<Side>>()};
}

} // namespace signorini::nurbs
