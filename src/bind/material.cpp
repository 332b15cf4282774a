#include "bind/material.hpp"
#include "bind/arguments.hpp"
#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "solid/linear_elastic.hpp"
#include "solid/neo_hookean.hpp"

namespace signorini::bind {

namespace {

template <auto make> int material(lua_State* L) {
  const Arguments a(L);
  push_object<solid::Material>(L, make(a.get<double>("E"), a.get<double>("nu")));
  return 1;
}

int material_text(lua_State* L) {
  const auto& material = self<solid::Material>(L);
  push(L, text(material.name(), ": ", constants_in_words(material)));
  return 1;
}

constexpr Function material_functions[] = {
    {"neo_hookean", material<solid::neo_hookean>},
    {"linear_elastic", material<solid::linear_elastic>},
};

constexpr Function material_entries[] = {{"__tostring", material_text}};

} // namespace

std::string constants_in_words(const solid::Material& material) {
  const solid::ElasticConstants& law = material.constants();
  return text("E = ", law.youngs_modulus, ", nu = ", law.poissons_ratio);
}

void open_material(lua_State* L) {
  register_functions(L, "sg", material_functions);
  register_type<solid::Material>(L, material_entries);
}

} // namespace signorini::bind
