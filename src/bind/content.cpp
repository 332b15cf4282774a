#include "base/archive.hpp"
#include "bind/functions.hpp"
#include "bind/material.hpp"
#include "bind/open.hpp"
#include "bind/patch.hpp"
#include "bind/scene.hpp"
#include "contact/archive.hpp"
#include "model/checkpoint.hpp"
#include "nurbs/archive.hpp"
#include "solid/archive.hpp"

namespace signorini::bind {

namespace {

template <int D> void write(ArchiveWriter& to, const Body<D>& body) {
  to.put(*body);
}

template <int D> void write(ArchiveWriter& to, const Place<D>& place) {
  to.put(*place.body, place.name, place.functions);
}

template <int D> void write(ArchiveWriter& to, const Rigid<D>& rigid) {
  to.put(rigid->form, rigid->shape);
}

template <int D> void write(ArchiveWriter& to, const Snapshot<D>& snapshot) {
  to.put(model::content(*snapshot.model, snapshot.state));
}

template <int D> void write(ArchiveWriter& to, const Model<D>& model) {
  to.put(model::content(*model, model::snapshot(*model)), model->present.displacement, model->present.penalty_factor);
}

/// Writes the object at index 1 where it is of one of these types; whether it is.
template <class... T> bool write_any(lua_State* L, ArchiveWriter& to) {
  const auto try_one = [&](const auto* object) {
    if (object) write(to, *object);
    return object != nullptr;
  };
  return (try_one(test_object<T>(L, 1)) || ...);
}

template <int D> bool write_scene_object(lua_State* L, ArchiveWriter& to) {
  return write_any<Body<D>, Place<D>, Rigid<D>, Snapshot<D>, Model<D>>(L, to);
}

/// core.content(object): all that a patch, a material, a body, a face, an obstacle, a model or a snapshot holds, as
/// bytes to compare; nil for other values.
int content(lua_State* L) {
  ArchiveWriter bytes;
  if (!write_any<nurbs::Patch, solid::Material>(L, bytes) && !write_scene_object<2>(L, bytes) &&
      !write_scene_object<3>(L, bytes))
    return 0;
  push(L, bytes.bytes());
  return 1;
}

constexpr Function content_entries[] = {{"content", content}};

} // namespace

void open_content(lua_State* L) {
  register_functions(L, "core", content_entries);
}

} // namespace signorini::bind
