#include "model/checkpoint.hpp"
#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "bind/scene.hpp"

namespace signorini::bind {

namespace {

/// Calls visit(model) for the model at stack index 1.
template <class Visit> int with_model(lua_State* L, Visit visit) {
  if (auto* model = test_object<Model<3>>(L, 1))
    visit(**model);
  else
    visit(*read_object<Model<2>>(L, 1, {"model"}));
  return 0;
}

/// core.save(model, path, text, durable): as model:save, with a text beside the model: how a run stands. durable: on
/// the disk on return.
int core_save(lua_State* L) {
  return with_model(
      L, [&](auto& model) { model::save(model, to<std::string>(L, 2), to<std::string>(L, 3), to<bool>(L, 4)); });
}

/// core.restore(model, path): brings a model to the state of a file that was saved of the same scene.
int core_restore(lua_State* L) {
  return with_model(L, [&](auto& model) { model::restore(model, to<std::string>(L, 2)); });
}

/// core.checkpoint_text(path): the text that core.save was given.
int core_text(lua_State* L) {
  push(L, model::load_text(to<std::string>(L, 1)));
  return 1;
}

int load(lua_State* L) {
  std::visit(
      [&](const auto& model) {
        push_object(L, model);
        count_memory(L, model::memory(*model));
      },
      model::load(to<std::string>(L, 1)));
  return 1;
}

constexpr Function core_rows[] = {{"save", core_save}, {"restore", core_restore}, {"checkpoint_text", core_text}};
constexpr Function checkpoint_functions[] = {{"load", load}};

} // namespace

void open_checkpoint(lua_State* L) {
  register_functions(L, "sg", checkpoint_functions);
  register_functions(L, "core", core_rows);
}

} // namespace signorini::bind
