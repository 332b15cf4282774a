#include "contact/method/archive.hpp"

#include "nurbs/archive.hpp"

#include <cmath>
#include <limits>

namespace signorini::contact {

constexpr ContactState last_value(std::type_identity<ContactState>) {
  return ContactState::bonded;
}
constexpr Foot last_value(std::type_identity<Foot>) {
  return Foot::corner;
}
constexpr TractionArea last_value(std::type_identity<TractionArea>) {
  return TractionArea::reference;
}
constexpr Enforcement last_value(std::type_identity<Enforcement>) {
  return Enforcement::multipliers;
}
constexpr WearUpdate last_value(std::type_identity<WearUpdate>) {
  return WearUpdate::after;
}
constexpr Pass last_value(std::type_identity<Pass>) {
  return Pass::half;
}
constexpr Softening last_value(std::type_identity<Softening>) {
  return Softening::bilinear;
}

template <int D> auto members(Plane<D>& plane) {
  auto& [point, normal] = plane;
  return std::tie(point, normal);
}

template <int D> auto members(Ball<D>& ball) {
  auto& [center, radius, hollow] = ball;
  return std::tie(center, radius, hollow);
}

auto members(Cylinder& cylinder) {
  auto& [point, axis, radius, hollow] = cylinder;
  return std::tie(point, axis, radius, hollow);
}

auto members(Torus& torus) {
  auto& [center, axis, ring, radius, hollow] = torus;
  return std::tie(center, axis, ring, radius, hollow);
}

template <int D> void write(ArchiveWriter& to, const LevelSet<D>& level_set) {
  to.put(level_set.compiled->formula, level_set.compiled->low, level_set.compiled->high);
}

template <int D> LevelSet<D> read_level_set(ArchiveReader& from) {
  symbolic::Formula formula = symbolic::read_formula(from, level_set_variables<D>());
  const auto low = from.get<Vec<D>>(), high = from.get<Vec<D>>();
  return make_level_set<D>(std::move(formula), low, high);
}

auto members(Changes& changes) {
  auto& [active, offset, normal, tangential, friction, overlap] = changes;
  return std::tie(active, offset, normal, tangential, friction, overlap);
}

auto members(Adhesion& law) {
  auto& [hamaker, distance] = law;
  return std::tie(hamaker, distance);
}

auto members(InterfaceLaw& law) {
  auto& [normal, tangential, friction, per, enforcement, frictional, adhesion, pressure, coefficient, wear, along,
         ellipse] = law;
  return std::tie(normal, tangential, friction, per, enforcement, frictional, adhesion, along, ellipse);
}

auto members(Cohesion& law) {
  auto& [strength, energy, softening, stiffness, formula] = law;
  return std::tie(strength, energy, softening, stiffness);
}

/// The position follows from the displacements; a point that acts is not beyond the master; `slipped` belongs to a
/// step.
template <int D> auto members(PointResult<D>& result) {
  auto& [state, position, gap, beyond, settled, pressure, area, tangents, friction, force, law_area, potential, slipped,
         mu, flaw, worn] = result;
  return std::tie(state, gap, pressure, area, tangents, friction, force, law_area, potential, mu);
}

/// `cleared` is not stored, because settling resets it.
template <int D> auto members(PointHistory<D>& point) {
  auto& [projection, cleared, slips, slip, limit, slipped, recent, worn] = point;
  auto& [foot, element, along, xi, gap, last] = projection;
  return std::tie(foot, element, along, xi, gap, last, slips, slip.xi, slip.last, limit, slipped, recent, worn);
}

template <int D> auto members(PointBond<D>& bond) {
  auto& [opening, largest, pressure, shear, left, mix, dissipated, sheared, remaining] = bond;
  return std::tie(opening, largest, pressure, shear, left, mix, dissipated, sheared, remaining);
}

template <int D> auto members(MultiplierResult<D>& result) {
  auto& [state, beyond, area, gap, pressure, potential, friction, components, elastic, slipped, mu, flaw, worn] =
      result;
  return std::tie(state, area, gap, pressure, potential, friction, components, elastic, slipped, mu);
}

/// `cleared` is not stored, because settling resets it, nor `touch`, which belongs to a step.
template <int D> auto members(MultiplierHistory<D>& multiplier) {
  auto& [cleared, elastic, limit, touch, slipped, recent, worn] = multiplier;
  return std::tie(elastic, limit, slipped, recent, worn);
}

namespace {

/// Throws Error unless a direction has the length 1.
template <class Direction> void check_unit(const Direction& direction) {
  require(std::abs(direction.norm() - 1) < 1e-9, "contact.archive.unit", {{"direction", direction}});
}

/// Throws Error unless the shape could have been made by a script.
template <int D> void check(const Plane<D>& plane) {
  make_plane(plane.point, plane.normal);
  check_unit(plane.normal);
}
template <int D> void check(const Ball<D>& ball) {
  make_ball(ball.center, ball.radius);
}
void check(const Cylinder& cylinder) {
  make_cylinder(cylinder.point, cylinder.axis, cylinder.radius);
  check_unit(cylinder.axis);
}
void check(const Torus& torus) {
  make_torus(torus.center, torus.axis, torus.ring, torus.radius);
  check_unit(torus.axis);
}

template <class Shape> Shape checked_shape(ArchiveReader& from) {
  auto shape = from.get<Shape>();
  check(shape);
  return shape;
}

template <int D> void write_obstacle(ArchiveWriter& to, const Obstacle<D>& obstacle) {
  to.put(static_cast<int>(obstacle.index()));
  std::visit([&](const auto& shape) { to.put(shape); }, obstacle);
}

template <int D> Obstacle<D> read_obstacle(ArchiveReader& from) {
  const int form = from.get<int>();
  if (form == 0) return checked_shape<Plane<D>>(from);
  if (form == 1) return checked_shape<Ball<D>>(from);
  if constexpr (D == 3) {
    if (form == 2) return checked_shape<Cylinder>(from);
    if (form == 5) return checked_shape<Torus>(from);
  }
  if (form == D) {
    auto patch = from.get<nurbs::Patch>();
    require(patch.dimension() == D && patch.parametric_dimension() == D - 1, "contact.archive.surface",
            {{"directions", patch.parametric_dimension()}, {"dimension", patch.dimension()}});
    return patch;
  }
  require(form == D + 1, "contact.archive.obstacle", {{"number", form}});
  return read_level_set<D>(from);
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

void write(ArchiveWriter& to, const Method& method) {
  // `unknown` follows from material and mesh.
  const auto& [pressure, coefficient, wear] = std::tie(method.law.pressure, method.law.coefficient, method.law.wear);
  to.put(method.law, method.multipliers, method.pass, method.bond, pressure != nullptr, coefficient != nullptr,
         wear.has_value());
  if (pressure)
    to.put(std::isfinite(pressure->clearance), std::isfinite(pressure->clearance) ? pressure->clearance : 0,
           pressure->formula);
  if (coefficient) to.put(coefficient->formula);
  if (wear) to.put(wear->rate->formula, wear->update);
  const CohesionFormula* bond = method.bond ? method.bond->formula.get() : nullptr;
  to.put(bond != nullptr);
  if (bond) to.put(bond->shear, bond->formula);
}

Method read(ArchiveReader& from, std::type_identity<Method>) {
  Method method;
  from.into(method.law, method.multipliers, method.pass, method.bond);
  const bool presses = from.get<bool>(), rubs = from.get<bool>(), wears = from.get<bool>();
  if (presses) {
    const bool bounded = from.get<bool>();
    const double given = from.get<double>(), clearance = bounded ? given : std::numeric_limits<double>::infinity();
    method.law.pressure = make_pressure_formula(symbolic::read_formula(from, pressure_variables()), clearance);
  }
  const auto slip_formula = [&] { return make_slip_formula(symbolic::read_formula(from, slip_variables())); };
  if (rubs) method.law.coefficient = slip_formula();
  if (wears) {
    method.law.wear = {slip_formula()};
    from.into(method.law.wear->update);
  }
  if (from.get<bool>()) {
    const double shear = from.get<double>();
    method.bond = cohesive(make_cohesion_formula(symbolic::read_formula(from, cohesion_variables()), shear));
  }
  return method;
}

template <int D> void write_history(ArchiveWriter& to, const History<D>& history) {
  const auto& [points, results, multipliers, multiplier_results, bonds, sparse, watched, changes, dissipated, growth,
               offset_work, debonding, worn_volume, wear] = history;
  to.put(changes, dissipated, growth, offset_work, debonding, worn_volume, wear,
         static_cast<std::uint64_t>(points.size()));
  for (const char element : sparse) to.put(element != 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool acts = results[i].area != 0;
    to.put(points[i], acts);
    if (acts) to.put(results[i]);
  }
  for (std::size_t a = 0; a < multipliers.size(); ++a) to.put(multipliers[a], multiplier_results[a]);
  for (const PointBond<D>& bond : bonds) to.put(bond);
}

namespace {

/// Throws Error unless a point's last closest point and slip point are on the master.
template <int D> void check_feet(const PointHistory<D>& point, const Surface<D>* master) {
  const auto& [foot, element, along, xi, gap, last] = point.projection;
  const int elements = master ? master->elements() : 1;
  require(element >= -1 && element < elements && along >= 0 && along < D - 1, "contact.archive.element",
          {{"element", element}, {"count", elements}});
  if (point.slips && master) master->find_element(point.slip.xi); // throws if there is none
}

} // namespace

template <int D> void read_history(ArchiveReader& from, const Formulation<D>& formulation, History<D>& history) {
  auto& [points, results, multipliers, multiplier_results, bonds, sparse, watched, changes, dissipated, growth,
         offset_work, debonding, worn_volume, wear] = history;
  watch_all(history);
  from.into(changes, dissipated, growth, offset_work, debonding, worn_volume, wear);
  const auto count = from.get<std::uint64_t>();
  require(count == points.size(), "contact.archive.points", {{"saved", count}, {"count", points.size()}});
  for (char& element : sparse) element = from.get<bool>();
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::apply([&](auto&... parts) { from.into(parts...); }, members(points[i]));
    check_feet(points[i], formulation.master().surface());
    results[i] = from.get<bool>() ? from.get<PointResult<D>>() : PointResult<D>{};
  }
  for (std::size_t a = 0; a < multipliers.size(); ++a) {
    std::apply([&](auto&... parts) { from.into(parts...); }, members(multipliers[a]));
    multiplier_results[a] = from.get<MultiplierResult<D>>();
  }
  for (PointBond<D>& bond : bonds) bond = from.get<PointBond<D>>();
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template void write_history(ArchiveWriter&, const History<D>&);                                                      \
  template void read_history(ArchiveReader&, const Formulation<D>&, History<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
