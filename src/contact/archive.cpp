#include "contact/archive.hpp"

#include "nurbs/archive.hpp"

namespace signorini::contact {

namespace {

template <int D> void write_shape(ArchiveWriter& to, const Plane<D>& plane) {
  const auto& [point, normal] = plane;
  to.put(point, normal);
}

template <int D> void write_shape(ArchiveWriter& to, const Ball<D>& ball) {
  const auto& [centre, radius] = ball;
  to.put(centre, radius);
}

void write_shape(ArchiveWriter& to, const Cylinder& cylinder) {
  const auto& [point, axis, radius] = cylinder;
  to.put(point, axis, radius);
}

void write_shape(ArchiveWriter& to, const nurbs::Patch& patch) {
  to.put(patch);
}

template <int D> void write_obstacle(ArchiveWriter& to, const Obstacle<D>& obstacle) {
  to.put(static_cast<int>(obstacle.index()));
  std::visit([&](const auto& shape) { write_shape(to, shape); }, obstacle);
}

template <int D> Obstacle<D> read_obstacle(ArchiveReader& from) {
  const int form = from.get<int>();
  if (form == 0) {
    Plane<D> plane;
    from.into(plane.point, plane.normal);
    return plane;
  }
  if (form == 1) {
    Ball<D> ball;
    from.into(ball.centre, ball.radius);
    return ball;
  }
  if constexpr (D == 3)
    if (form == 2) {
      Cylinder cylinder;
      from.into(cylinder.point, cylinder.axis, cylinder.radius);
      return cylinder;
    }
  require(form == D, "obstacle: there is no form ", form);
  return from.get<nurbs::Patch>();
}

template <int D> void write_result(ArchiveWriter& to, const PointResult<D>& result) {
  // The position follows from the displacements; a point that acts is not beyond the master.
  const auto& [state, position, gap, beyond, settled, pressure, tangents, friction, force, area, potential] = result;
  to.put(state, gap, pressure, tangents, friction, force, area, potential);
}

template <int D> void read_result(ArchiveReader& from, PointResult<D>& result) {
  auto& [state, position, gap, beyond, settled, pressure, tangents, friction, force, area, potential] = result;
  from.into(state, gap, pressure, tangents, friction, force, area, potential);
}

} // namespace

void write(ArchiveWriter& to, const Obstacle<2>& obstacle) {
  write_obstacle<2>(to, obstacle);
}
void write(ArchiveWriter& to, const Obstacle<3>& obstacle) {
  write_obstacle<3>(to, obstacle);
}
Obstacle<2> read(ArchiveReader& from, std::type_identity<Obstacle<2>>) {
  return read_obstacle<2>(from);
}
Obstacle<3> read(ArchiveReader& from, std::type_identity<Obstacle<3>>) {
  return read_obstacle<3>(from);
}

void write(ArchiveWriter& to, const Law& law) {
  to.put(static_cast<int>(law.index()));
  if (const auto* penalty = std::get_if<PenaltyLaw>(&law)) {
    const auto& [normal, tangential, friction] = *penalty;
    to.put(normal, tangential, friction);
  } else {
    const auto& [hamaker, distance] = std::get<Adhesion>(law);
    to.put(hamaker, distance);
  }
}

Law read(ArchiveReader& from, std::type_identity<Law>) {
  const int index = from.get<int>();
  require(index == 0 || index == 1, "contact: there is no law ", index);
  if (index == 0) {
    PenaltyLaw law{};
    from.into(law.normal, law.tangential, law.friction);
    return law;
  }
  Adhesion law;
  from.into(law.hamaker, law.distance);
  return law;
}

template <int D> void write_history(ArchiveWriter& to, const typename Pair<D>::History& history) {
  const auto& [memories, master, positions, results, dissipated] = history;
  to.put(dissipated, static_cast<std::uint64_t>(memories.size()));
  for (std::size_t i = 0; i < memories.size(); ++i) {
    // Settling clears no point.
    const auto& [projection, cleared, slips, slip, limit, multiplier] = memories[i];
    const auto& [foot, element, along, xi, gap] = projection;
    const bool acts = results[i].area != 0;
    to.put(foot, element, along, xi, gap, slips, slip, limit, multiplier, acts);
    if (acts) write_result<D>(to, results[i]);
  }
}

template <int D> void read_history(ArchiveReader& from, typename Pair<D>::History& history) {
  auto& [memories, master, positions, results, dissipated] = history;
  dissipated = from.get<double>();
  const auto count = from.get<std::uint64_t>();
  require(count == memories.size(), "a contact of ", count, " points was saved, this one has ", memories.size());
  for (std::size_t i = 0; i < memories.size(); ++i) {
    auto& [projection, cleared, slips, slip, limit, multiplier] = memories[i];
    auto& [foot, element, along, xi, gap] = projection;
    from.into(foot, element, along, xi, gap, slips, slip, limit, multiplier);
    results[i] = {};
    if (from.get<bool>()) read_result<D>(from, results[i]);
  }
}

template void write_history<2>(ArchiveWriter&, const Pair<2>::History&);
template void write_history<3>(ArchiveWriter&, const Pair<3>::History&);
template void read_history<2>(ArchiveReader&, Pair<2>::History&);
template void read_history<3>(ArchiveReader&, Pair<3>::History&);

} // namespace signorini::contact
