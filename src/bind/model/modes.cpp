// Modes and stability of a model's accepted state, for lua/signorini/run/modes.lua.

#include "model/stability/modes.hpp"
#include "bind/lua/functions.hpp"
#include "bind/lua/open.hpp"
#include "bind/lua/wording/wording.hpp"
#include "bind/scene/scene.hpp"

namespace signorini::bind {

namespace {

/// core.modes(model, count): a table { symmetric, complete, stable, warnings } and a list of { value, imaginary, mode,
/// rigid }, as model::Modes.
template <int D> int modes(model::Model<D>& model, int count, lua_State* L) {
  const model::Modes found = model::free_modes(model, count);
  push_fields(L, "symmetric", found.symmetric, "complete", found.complete, "stable", found.stable, "warnings",
              worded(found.warnings));
  push_list(L, found.list, [&](const model::Mode& mode) {
    const bool rigid = !mode.rigid.code.empty();
    push_fields(L, "value", mode.value.real(), "imaginary", mode.value.imag(), "mode",
                VectorX(mode.shape.head(model.system.unknowns.free_displacements())), "rigid",
                rigid ? std::optional(worded(mode.rigid)) : std::nullopt);
  });
  return 2;
}

template <int D> constexpr Function modes_core[] = {{"modes", call<modes<D>>}};

} // namespace

void open_modes(lua_State* L) {
  register_functions<Model<2>, Model<3>>(L, "core", modes_core<2>, modes_core<3>);
}

} // namespace signorini::bind
