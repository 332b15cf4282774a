#include "nurbs/archive.hpp"

namespace signorini::nurbs {

void write(ArchiveWriter& to, const KnotVector& knots) {
  to.put(knots.degree(), knots.knots());
}

KnotVector read(ArchiveReader& from, std::type_identity<KnotVector>) {
  const int degree = from.get<int>();
  return {degree, from.get<std::vector<double>>()};
}

void write(ArchiveWriter& to, const Patch& patch) {
  to.put(patch.directions(), patch.homogeneous());
}

Patch read(ArchiveReader& from, std::type_identity<Patch>) {
  auto directions = from.get<std::vector<KnotVector>>();
  return {std::move(directions), from.get<MatrixX>()};
}

void write(ArchiveWriter& to, const Side& side) {
  const auto& [direction, at_end] = side;
  to.put(direction, at_end);
}

Side read(ArchiveReader& from, std::type_identity<Side>) {
  Side side;
  from.into(side.direction, side.at_end);
  return side;
}

void write(ArchiveWriter& to, const Discretisation& space) {
  to.put(space.through(), space.through_knots(), space.rows(), space.contact());
}

Discretisation read(ArchiveReader& from, std::type_identity<Discretisation>) {
  const int through = from.get<int>();
  auto knots = from.get<KnotVector>();
  auto rows = from.get<std::vector<Patch>>();
  return {through, std::move(knots), std::move(rows), from.get<std::vector<Side>>()};
}

} // namespace signorini::nurbs
