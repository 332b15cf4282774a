#include "contact/archive.hpp"

#include "nurbs/archive.hpp"

#include <tuple>

namespace signorini::contact {

namespace {

template <int D> auto members(Plane<D>& plane) {
  auto& [point, normal] = plane;
  return std::tie(point, normal);
}
template <int D> auto members(Ball<D>& ball) {
  auto& [centre, radius] = ball;
  return std::tie(centre, radius);
}
auto members(Cylinder& cylinder) {
  auto& [point, axis, radius] = cylinder;
  return std::tie(point, axis, radius);
}
auto members(PenaltyLaw& law) {
  auto& [normal, tangential, friction] = law;
  return std::tie(normal, tangential, friction);
}
auto members(Adhesion& law) {
  auto& [hamaker, distance] = law;
  return std::tie(hamaker, distance);
}
template <int D> auto members(PointResult<D>& result) {
  // The position follows from the displacements; a point that acts is not beyond the master.
  auto& [state, position, gap, beyond, settled, pressure, tangents, friction, force, area, potential] = result;
  return std::tie(state, gap, pressure, tangents, friction, force, area, potential);
}
template <int D> auto members(PointHistory<D>& point) {
  // Settling clears no point.
  auto& [projection, cleared, slips, slip, limit, multiplier] = point;
  auto& [foot, element, along, xi, gap] = projection;
  return std::tie(foot, element, along, xi, gap, slips, slip, limit, multiplier);
}

/// Copied, as members() lends what a reader fills.
template <class T> void write_members(ArchiveWriter& to, T value) {
  std::apply([&](const auto&... member) { to.put(member...); }, members(value));
}

void write_members(ArchiveWriter& to, const nurbs::Patch& patch) {
  to.put(patch);
}

template <class T> T read_members(ArchiveReader& from) {
  T value{};
  std::apply([&](auto&... member) { from.into(member...); }, members(value));
  return value;
}

} // namespace

template <AnyObstacle T> void write(ArchiveWriter& to, const T& obstacle) {
  to.put(static_cast<int>(obstacle.index()));
  std::visit([&](const auto& shape) { write_members(to, shape); }, obstacle);
}

template <AnyObstacle T> T read(ArchiveReader& from, std::type_identity<T>) {
  constexpr int D = std::is_same_v<T, Obstacle<2>> ? 2 : 3;
  const int form = from.get<int>();
  if (form == 0) return read_members<Plane<D>>(from);
  if (form == 1) return read_members<Ball<D>>(from);
  if constexpr (D == 3)
    if (form == 2) return read_members<Cylinder>(from);
  require(form == D, "obstacle: there is no form ", form);
  return from.get<nurbs::Patch>();
}

template <int D> void write(ArchiveWriter& to, const Method<D>& method) {
  require(!std::holds_alternative<Maker<D>>(method), "a contact with a formulation of one's own cannot be saved");
  to.put(static_cast<int>(method.index()));
  if (const auto* penalty = std::get_if<PenaltyLaw>(&method)) write_members(to, *penalty);
  if (const auto* adhesion = std::get_if<Adhesion>(&method)) write_members(to, *adhesion);
}

template <int D> Method<D> read_method(ArchiveReader& from) {
  const int index = from.get<int>();
  require(index == 0 || index == 1, "contact: there is no law ", index);
  if (index == 0) return read_members<PenaltyLaw>(from);
  return read_members<Adhesion>(from);
}

template <int D> void write_history(ArchiveWriter& to, const History<D>& history) {
  const auto& [points, results, dissipated] = history;
  to.put(dissipated, static_cast<std::uint64_t>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool acts = results[i].area != 0;
    write_members(to, points[i]);
    to.put(acts);
    if (acts) write_members(to, results[i]);
  }
}

template <int D> void read_history(ArchiveReader& from, History<D>& history) {
  auto& [points, results, dissipated] = history;
  dissipated = from.get<double>();
  const auto count = from.get<std::uint64_t>();
  require(count == points.size(), "a contact of ", count, " points was saved, this one has ", points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = read_members<PointHistory<D>>(from);
    const bool acts = from.get<bool>();
    results[i] = acts ? read_members<PointResult<D>>(from) : PointResult<D>();
  }
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template void write(ArchiveWriter&, const Obstacle<D>&);                                                             \
  template Obstacle<D> read(ArchiveReader&, std::type_identity<Obstacle<D>>);                                          \
  template void write(ArchiveWriter&, const Method<D>&);                                                               \
  template Method<D> read_method<D>(ArchiveReader&);                                                                   \
  template void write_history(ArchiveWriter&, const History<D>&);                                                      \
  template void read_history(ArchiveReader&, History<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
