#include "model/scene/replaced_rows.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <utility>

namespace signorini::model {

namespace {

using nurbs::Discretization;

/// True if the functions of a body's face are those of a row that changes.
template <int D> bool on_row(const Scene<D>& scene, const FaceReference& face, const RowChanges<D>& changes) {
  const Discretization& space = scene.bodies[face.body].body->space();
  return face.side.direction == space.through() &&
         changes(face.body, face.side.at_end ? space.stack().functions() - 1 : 0);
}

/// The row of a function.
int row_of(const Discretization& space, int function) {
  int row = std::ssize(space.rows()) - 1;
  while (space.first_function(row) > function) --row;
  return row;
}

/// Place of a function of a row: in each direction 0 at the start, 1 inside, 2 at the end; ξ¹ has base 1, ξ² base 3.
int place_in(const nurbs::Row& row, int function) {
  int place = 0, base = 1;
  for (const nurbs::Space1D& direction : row.directions()) {
    const int i = function % direction.functions();
    function /= direction.functions();
    place += base * (i == 0 ? 0 : i == direction.functions() - 1 ? 2 : 1);
    base *= 3;
  }
  return place;
}
constexpr int place_count = 9;

/// The functions of `to` at the faces, edges and corners where those of `from` are.
std::vector<int> carried(const Discretization& from, const Discretization& to, const std::vector<int>& functions) {
  std::vector<int> result;
  for (int j = 0; j < std::ssize(from.rows()); ++j) {
    const nurbs::Row &old = from.rows()[j], &row = to.rows()[j];
    std::array<bool, place_count> has{};
    for (const int function : functions) {
      const int own = function - from.first_function(j);
      if (own < 0 || own >= old.functions()) continue;
      if (old.directions() == row.directions())
        result.push_back(to.first_function(j) + own);
      else
        has[place_in(old, own)] = true;
    }
    if (old.directions() == row.directions()) continue;
    for (int i = 0; i < row.functions(); ++i)
      if (has[place_in(row, i)]) result.push_back(to.first_function(j) + i);
  }
  return result;
}

template <int D> bool any_row(const Scene<D>& scene, int body, const RowChanges<D>& changes) {
  const int rows = scene.bodies[body].body->space().stack().functions();
  for (int j = 0; j < rows; ++j)
    if (changes(body, j)) return true;
  return false;
}

} // namespace

template <int D> void check_replaceable(const Scene<D>& scene, const RowChanges<D>& changes) {
  const auto changing = [&](int body) { return any_row(scene, body, changes); };
  for (int b = 0; b < std::ssize(scene.bodies); ++b)
    require(!changing(b) || scene.bodies[b].body->internal_variables() == 0, "model.adapt.internal",
            {{"body", scene.bodies[b].name}});
  for (const Support<D>& support : scene.supports)
    for (const SupportedControlPoints& on : support.on) {
      const Discretization& space = scene.bodies[on.body].body->space();
      const bool changed =
          std::ranges::any_of(on.functions, [&](int function) { return changes(on.body, row_of(space, function)); });
      require(!changed || on.shape.empty(), "model.adapt.shape",
              {{"support", support.name}, {"body", scene.bodies[on.body].name}});
    }
  const auto name_of = [&](int body) { return scene.bodies[body].name; };
  for (const Load& load : scene.loads) {
    std::vector<int> loaded = load.bodies;
    for (const FaceReference& face : load.on) loaded.push_back(face.body);
    for (const int body : loaded)
      require(load.values.empty() || !changing(body), "model.adapt.load",
              {{"load", load.name}, {"body", name_of(body)}});
    for (const PointShare& point : load.points) {
      const Discretization& space = scene.bodies[point.body].body->space();
      const int row = row_of(space, point.function);
      const int place = place_in(space.rows()[row], point.function - space.first_function(row));
      const bool corner = place % 3 != 1 && (D == 2 || place / 3 != 1);
      require(corner || !changes(point.body, row), "model.adapt.edge_load",
              {{"load", load.name}, {"body", name_of(point.body)}});
    }
  }
  for (const Tie& tie : scene.ties)
    for (const FaceReference& face : tie.slave)
      require(!on_row(scene, face, changes), "model.adapt.tie",
              {{"tie", tie_message(tie)}, {"face", face_message(scene, face)}});
  for (const Join& join : scene.joins)
    for (const FaceReference& face : {join.first, join.second}) {
      const bool across = face.side.direction != scene.bodies[face.body].body->space().through();
      require(!(changing(face.body) && (D == 3 || !across)), "model.adapt.join",
              {{"join", join.name}, {"face", face_message(scene, face)}});
    }
}

template <int D> Scene<D> with_bodies(Scene<D> scene, const Bodies<D>& bodies) {
  const auto space = [&](int b) -> const Discretization& { return scene.bodies[b].body->space(); };
  check_replaceable<D>(scene, [&](int b, int row) {
    return space(b).rows()[row].directions() != bodies[b]->space().rows()[row].directions();
  });
  const auto carry = [&](int body, const std::vector<int>& functions) {
    return carried(space(body), bodies[body]->space(), functions);
  };
  for (Support<D>& support : scene.supports)
    for (SupportedControlPoints& on : support.on) on.functions = carry(on.body, on.functions);
  for (Load& load : scene.loads)
    for (PointShare& point : load.points) point.function = carry(point.body, {point.function}).front();
  for (std::size_t b = 0; b < bodies.size(); ++b) scene.bodies[b].body = bodies[b];
  return scene;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template void check_replaceable(const Scene<D>&, const RowChanges<D>&);                                              \
  template Scene<D> with_bodies(Scene<D>, const Bodies<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
