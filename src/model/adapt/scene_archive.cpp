#include "model/adapt/scene_archive.hpp"

#include "contact/method/archive.hpp"
#include "model/scene/references.hpp"
#include "model/scene/region.hpp"
#include "nurbs/archive.hpp"
#include "solid/archive.hpp"

namespace signorini::model {

constexpr Constraint last_value(std::type_identity<Constraint>) {
  return Constraint::driven;
}
constexpr LoadKind last_value(std::type_identity<LoadKind>) {
  return LoadKind::moment;
}

auto members(FaceReference& face) {
  auto& [body, side] = face;
  return std::tie(body, side);
}

void write(ArchiveWriter& to, const Faces& faces) {
  to.put(static_cast<const std::vector<FaceReference>&>(faces));
}

Faces read(ArchiveReader& from, std::type_identity<Faces>) {
  const auto list = from.get<std::vector<FaceReference>>();
  return {list.begin(), list.end()};
}

auto members(SupportedControlPoints& points) {
  auto& [body, functions, shape] = points;
  return std::tie(body, functions, shape);
}

template <int D> auto members(Support<D>& support) {
  auto& [name, on, constraint, obstacles, rotates, center, axis, spring, spring_faces, shape_error, freed, free_angle,
         obstacle_spring] = support;
  return std::tie(name, on, constraint, obstacles, rotates, center, axis, spring, spring_faces, shape_error, freed,
                  free_angle, obstacle_spring);
}

auto members(PointShare& point) {
  auto& [body, function, share] = point;
  return std::tie(body, function, share);
}

auto members(Load& load) {
  auto& [name, on, kind, start, bodies, values, points, obstacles] = load;
  return std::tie(name, on, kind, start, bodies, values, points, obstacles);
}

auto members(Tie& tie) {
  auto& [name, slave, master, multipliers, from_join] = tie;
  return std::tie(name, slave, master, multipliers, from_join);
}

/// The pairs of control points follow from the faces.
auto members(Join& join) {
  auto& [name, first, second, pairs] = join;
  return std::tie(name, first, second);
}

template <int D> void write(ArchiveWriter& to, const NamedBody<D>& named) {
  const auto& [name, body] = named;
  to.put(name, *body);
}

template <int D> NamedBody<D> read(ArchiveReader& from, std::type_identity<NamedBody<D>>) {
  auto name = from.get<std::string>();
  return {std::move(name), solid::read_body<D>(from)};
}

namespace {

template <int D>
void write_contact(ArchiveWriter& to, const Contact<D>& contact, const contact::Formulation<D>& formulation) {
  const auto& [name, slave, master, method, points, where, start, bonded, other_pass, default_penalty, adaptive_points,
               apart, own] = contact;
  require(!own, "model.archive.own_formulation");
  const auto* faces = std::get_if<Faces>(&master);
  to.put(name, slave, faces ? *faces : Faces{}, faces ? -1 : std::get<ObstacleReference>(master).obstacle, method,
         points, points_of_region(formulation), start, bonded_points(formulation), other_pass, default_penalty,
         adaptive_points, apart);
}

template <int D> Contact<D> read_contact(ArchiveReader& from) {
  Contact<D> contact{};
  auto& [name, slave, master, method, points, where, start, bonded, other_pass, default_penalty, adaptive_points, apart,
         own] = contact;
  from.into(name, slave);
  const Faces faces = from.get<Faces>();
  const ObstacleReference obstacle{from.get<int>()};
  if (obstacle.obstacle < 0)
    master = faces;
  else
    master = obstacle;
  from.into(method, points);
  where = region_of<D>(from.get<RegionPoints<D>>());
  from.into(start);
  bonded = region_of<D>(from.get<RegionPoints<D>>());
  from.into(other_pass, default_penalty, adaptive_points, apart);
  return contact;
}

/// The parts in order: kind and numbers, bodies, obstacles, supports, loads, contacts, ties, joins.
struct Counts {
  solid::Kind kind;
  int bodies, obstacles, supports, loads, contacts, ties, joins;
};

auto members(Counts& counts) {
  auto& [kind, bodies, obstacles, supports, loads, contacts, ties, joins] = counts;
  return std::tie(kind, bodies, obstacles, supports, loads, contacts, ties, joins);
}

template <class Part> ScenePart named(const char* kind, const std::string& name, const Part& part) {
  ArchiveWriter bytes;
  part(bytes);
  return {text(kind, " '", name, "'"), bytes.bytes()};
}

} // namespace

template <int D> std::vector<ScenePart> scene_parts(const Model<D>& model) {
  if (model.origin) return model.origin->parts;
  const Scene<D>& scene = model.system.scene;
  const auto& [bodies, obstacles, supports, loads, contacts, ties, joins, kind] = scene;
  const auto size = [](const auto& list) { return static_cast<int>(list.size()); };
  ArchiveWriter counts;
  counts.put(Counts{kind, size(bodies), size(obstacles), size(supports), size(loads), size(contacts), size(ties),
                    size(joins)});
  std::vector<ScenePart> parts{{"the kind of scene or the number of its parts", counts.bytes()}};
  const auto add = [&](const char* what, const auto& list) {
    for (const auto& item : list) parts.push_back(named(what, item.name, [&](ArchiveWriter& to) { to.put(item); }));
  };
  add("body", bodies);
  for (std::size_t i = 0; i < obstacles.size(); ++i)
    parts.push_back(named("obstacle", std::to_string(i + 1), [&](ArchiveWriter& to) { to.put(scene.obstacles[i]); }));
  add("support", supports);
  add("load", loads);
  for (std::size_t k = 0; k < contacts.size(); ++k)
    parts.push_back(named("contact", contacts[k].name,
                          [&](ArchiveWriter& to) { write_contact(to, scene.contacts[k], *model.system.contacts[k]); }));
  add("tie", ties);
  add("join", joins);
  return parts;
}

template <int D> Scene<D> read_scene(const std::vector<ScenePart>& parts, const ArchiveLimits& limits) {
  std::size_t next = 0;
  const auto part = [&] {
    require(next < parts.size(), "model.archive.parts", {{"count", parts.size()}});
    return ArchiveReader(parts[next++].bytes, limits);
  };
  Scene<D> scene;
  const auto counts = part().template get<Counts>();
  const auto fill = [&]<class T>(std::vector<T>& list, int count) {
    for (int i = 0; i < count; ++i) list.push_back(part().template get<T>());
  };
  scene.kind = counts.kind;
  fill(scene.bodies, counts.bodies);
  fill(scene.obstacles, counts.obstacles);
  fill(scene.supports, counts.supports);
  fill(scene.loads, counts.loads);
  for (int k = 0; k < counts.contacts; ++k) {
    ArchiveReader from = part();
    scene.contacts.push_back(read_contact<D>(from));
  }
  fill(scene.ties, counts.ties);
  fill(scene.joins, counts.joins);
  check_references(scene);
  return scene;
}

template std::vector<ScenePart> scene_parts<2>(const Model<2>&);
template std::vector<ScenePart> scene_parts<3>(const Model<3>&);
template Scene<2> read_scene<2>(const std::vector<ScenePart>&, const ArchiveLimits&);
template Scene<3> read_scene<3>(const std::vector<ScenePart>&, const ArchiveLimits&);

} // namespace signorini::model
