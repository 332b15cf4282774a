// Objects as bytes: checkpoints of models, and contents for comparison.

#include "model/files/checkpoint.hpp"
#include "bind/geometry/patch.hpp"
#include "bind/lua/functions.hpp"
#include "bind/lua/open.hpp"
#include "bind/scene/scene.hpp"
#include "contact/method/archive.hpp"
#include "nurbs/archive.hpp"
#include "os/archive.hpp"
#include "solid/archive.hpp"

namespace signorini::bind {

namespace {

int load(lua_State* L) {
  std::visit(
      [&](const auto& model) {
        push_object(L, model);
        count_memory(L, model::memory(*model));
      },
      model::load(to<std::string>(L, 1)));
  return 1;
}

/// Writes the object at index 1, or the result of `part` for it, if it is of this type; returns whether it is.
template <class T, class Part> bool write_if(lua_State* L, ArchiveWriter& to, Part part) {
  const T* object = test_object<T>(L, 1);
  if (object) std::apply([&](const auto&... parts) { to.put(parts...); }, part(*object));
  return object != nullptr;
}

template <int D> bool write_scene_object(lua_State* L, ArchiveWriter& to) {
  return write_if<Body<D>>(L, to, [](const auto& body) { return std::tie(*body); }) ||
         write_if<BoundaryPart<D>>(L, to, [](const auto& at) { return std::tie(*at.body, at.name, at.functions); }) ||
         write_if<Rigid<D>>(L, to, [](const auto& rigid) { return std::tie(rigid->form, rigid->shape); }) ||
         write_if<Snapshot<D>>(
             L, to, [](const auto& snapshot) { return std::tuple(model::content(*snapshot.model, snapshot.state)); }) ||
         write_if<Model<D>>(L, to, [](const auto& model) {
           return std::tuple(model::content(*model, model::snapshot(*model)), model->present.displacement,
                             model->present.penalty_factor);
         });
}

/// core.content(object): the contents of a patch, material, body, face, obstacle, model or snapshot as bytes for
/// comparison; nil for other values.
int content(lua_State* L) {
  ArchiveWriter bytes;
  const auto whole = [](const auto& object) { return std::tie(object); };
  if (!write_if<nurbs::Patch>(L, bytes, whole) && !write_if<solid::Material>(L, bytes, whole) &&
      !write_scene_object<2>(L, bytes) && !write_scene_object<3>(L, bytes))
    return 0;
  push(L, bytes.bytes());
  return 1;
}

/// core.save(model, path, text, durable): as model:save, with a text stored next to the model, such as the state of a
/// run. durable: flushed to disk on return. core.restore(model, path): restores the state from a file saved from the
/// same scene.
template <int D>
constexpr Function model_core_rows[] = {
    {"save", call<model::save<D>>},
    {"restore", call<[](Model<D>& model, const std::string& path) { model::restore(model, path); }>},
};

} // namespace

void open_checkpoint(lua_State* L) {
  register_functions(L, "sg", {{"load", load}});
  // checkpoint_text(path): the text given to core.save
  register_functions(L, "core", {{"checkpoint_text", call<model::load_text>}, {"content", content}});
  register_functions<Model<2>, Model<3>>(L, "core", model_core_rows<2>, model_core_rows<3>);
}

} // namespace signorini::bind
