// sg.nurbs.read, sg.nurbs.write and patch:write: patches in files of other programs.

#include "exchange/exchange.hpp"

#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "bind/patch.hpp"

namespace signorini::bind {

using nurbs::Patch;

namespace {

int read(lua_State* L) {
  const auto patches = exchange::read_patches(to<std::string>(L, 1));
  lua_createtable(L, static_cast<int>(patches.size()), 0);
  for (std::size_t i = 0; i < patches.size(); ++i) {
    push_object(L, patches[i]);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  return 1;
}

/// Writes to the file at one index of the stack, in the form that is given as the third argument, else by the file's
/// ending.
int write_to(lua_State* L, int file_index, const std::vector<Patch>& patches) {
  const auto file = to<std::string>(L, file_index);
  const auto form = lua_isnoneornil(L, 3) ? exchange::form_named_by(file) : to<std::string>(L, 3);
  if (form.empty())
    reject(L, file_index, {"file", "where the patches go"}, "a name that ends with .xml, .txt or .mesh",
           "or give the format as well: " + one_of(exchange::forms()));
  exchange::write_patches(file, patches, form);
  return 0;
}

int write_patches(lua_State* L) {
  std::vector<Patch> patches;
  for (lua_Integer i = 1; lua_rawgeti(L, 2, i) != LUA_TNIL; ++i) {
    patches.push_back(*test_object<Patch>(L, -1));
    lua_pop(L, 1);
  }
  lua_pop(L, 1);
  return write_to(L, 1, patches);
}

constexpr Function exchange_entries[] = {{"read", read}, {"write", write_patches}};

} // namespace

int write_patch(lua_State* L) {
  return write_to(L, 2, {self<Patch>(L)});
}

void open_exchange(lua_State* L) {
  register_functions(L, "sg.nurbs", exchange_entries);
  push_table(L, "core");
  set_field(L, "patch_forms", exchange::forms());
  lua_pop(L, 1);
}

} // namespace signorini::bind
