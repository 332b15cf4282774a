#include "nurbs/archive.hpp"

namespace signorini::nurbs {

namespace {

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

void write(ArchiveWriter& to, const Discretization& space) {
  to.put(space.through(), space.stack(), space.rows(), space.contact());
}

Discretization read(ArchiveReader& from, std::type_identity<Discretization>) {
  const int through = from.get<int>();
  auto stack = from.get<Space1D>();
  auto rows = from.get<std::vector<Row>>();
  return {through, std::move(stack), std::move(rows), from.get<std::vector<Side>>()};
}

} // namespace signorini::nurbs
