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

template <int D> void write(ArchiveWriter& to, const Method<D>& method) {
  require(!std::holds_alternative<Maker<D>>(method), "a contact with a formulation of one's own cannot be saved");
  to.put(static_cast<int>(method.index()));
  if (const auto* penalty = std::get_if<PenaltyLaw>(&method))
    to.put(penalty->normal, penalty->tangential, penalty->friction);
  else if (const auto* adhesion = std::get_if<Adhesion>(&method))
    to.put(adhesion->hamaker, adhesion->distance);
}

template <int D> Method<D> read_method(ArchiveReader& from) {
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

template <int D> void write_history(ArchiveWriter& to, const History<D>& history) {
  const auto& [points, results, dissipated] = history;
  to.put(dissipated, static_cast<std::uint64_t>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    // Settling clears no point.
    const auto& [projection, cleared, slips, slip, limit, multiplier] = points[i];
    const auto& [foot, element, along, xi, gap] = projection;
    const bool acts = results[i].area != 0;
    to.put(foot, element, along, xi, gap, slips, slip, limit, multiplier, acts);
    if (acts) write_result<D>(to, results[i]);
  }
}

template <int D> void read_history(ArchiveReader& from, History<D>& history) {
  auto& [points, results, dissipated] = history;
  dissipated = from.get<double>();
  const auto count = from.get<std::uint64_t>();
  require(count == points.size(), "a contact of ", count, " points was saved, this one has ", points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    auto& [projection, cleared, slips, slip, limit, multiplier] = points[i];
    auto& [foot, element, along, xi, gap] = projection;
    from.into(foot, element, along, xi, gap, slips, slip, limit, multiplier);
    results[i] = {};
    if (from.get<bool>()) read_result<D>(from, results[i]);
  }
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template void write(ArchiveWriter&, const Method<D>&);                                                               \
  template Method<D> read_method<D>(ArchiveReader&);                                                                   \
  template void write_history(ArchiveWriter&, const History<D>&);                                                      \
  template void read_history(ArchiveReader&, History<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
