#include "bind/checkpoint.hpp"
#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "model/checkpoint.hpp"

namespace signorini::bind {

namespace {

const Argument checkpoint_argument{"path", "the checkpoint's file"};

template <int D> int save_run(lua_State* L, Model<D>& model) {
  const std::string file = read_string(L, 2, checkpoint_argument);
  const bool durable = lua_isnoneornil(L, 4) || lua_toboolean(L, 4) != 0;
  model::save(*model, file, lua_isnoneornil(L, 3) ? std::string() : read_string(L, 3, {"text"}), durable);
  return 0;
}

template <int D> int restore_run(lua_State* L, Model<D>& model) {
  model::restore(*model, read_string(L, 2, checkpoint_argument));
  return 0;
}

int core_save(lua_State* L) {
  if (auto* model = test_object<Model<3>>(L, 1)) return save_run<3>(L, *model);
  return save_run<2>(L, read_object<Model<2>>(L, 1, {"model"}));
}

int core_restore(lua_State* L) {
  if (auto* model = test_object<Model<3>>(L, 1)) return restore_run<3>(L, *model);
  return restore_run<2>(L, read_object<Model<2>>(L, 1, {"model"}));
}

int core_text(lua_State* L) {
  push(L, model::load_text(read_string(L, 1, checkpoint_argument)));
  return 1;
}

int load(lua_State* L) {
  std::visit(
      [&](const auto& model) {
        push_object(L, model);
        count_memory(L, model::memory(*model));
      },
      model::load(read_string(L, 1, checkpoint_argument)));
  return 1;
}

constexpr Function core_rows[] = {
    {"save", core_save,
     "core.save(model, path, text, durable = true)\n"
     "As model:save, with a text beside the model: how a run stands. durable: on the disk on return."},
    {"restore", core_restore,
     "core.restore(model, path)\nBrings a model to the state of a file that was saved of the same scene."},
    {"checkpoint_text", core_text, "core.checkpoint_text(path)\nThe text that core.save was given."},
};

constexpr Function checkpoint_functions[] = {
    {"load", load,
     "sg.load(path)\n"
     "The model that model:save(path), or a run with checkpoints, has saved: bodies, supports, loads, contacts, and\n"
     "the accepted state with its contact history. It needs nothing of the script that made it, and goes on with the\n"
     "same bits as the model that was saved.\n"
     "Example: model = sg.load \"pressed.sgn\""},
};

} // namespace

template <int D> int save(lua_State* L) {
  model::save(*self<Model<D>>(L), read_string(L, 2, checkpoint_argument));
  return 0;
}
template int save<2>(lua_State*);
template int save<3>(lua_State*);

void open_checkpoint(lua_State* L) {
  register_functions(L, "sg", checkpoint_functions);
  register_functions(L, "core", core_rows);
}

} // namespace signorini::bind
