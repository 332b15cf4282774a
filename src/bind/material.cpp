#include "bind/material.hpp"
#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "bind/options.hpp"
#include "solid/linear_elastic.hpp"
#include "solid/neo_hookean.hpp"

namespace signorini::bind {

namespace {

template <auto make> int material(lua_State* L) {
  const Options o(L, 1, {"E", "nu"});
  const double modulus = o.positive("E", "Young's modulus, force per area");
  push_object<solid::Material>(L, make(modulus, o.number("nu", "Poisson's ratio")));
  return 1;
}

int material_text(lua_State* L) {
  const auto& material = self<solid::Material>(L);
  push(L, text(material.name(), ": ", constants_in_words(material)));
  return 1;
}

constexpr Function material_functions[] = {
    {"neo_hookean", material<solid::neo_hookean>,
     "sg.neo_hookean{ E, nu }\n"
     "Compressible neo-Hooke material, W = lambda/2 (ln J)^2 + mu/2 (tr C - 3) - mu ln J. E: Young's modulus (force\n"
     "per area), nu: Poisson's ratio in (-1, 0.5). Plane strain in 2D, unless the model is axisymmetric.\n"
     "Source: (3.29) of V. Agrawal, thesis, IIT Guwahati, 2020.\n"
     "Example: sg.neo_hookean{ E = 1, nu = 0.3 }"},
    {"linear_elastic", material<solid::linear_elastic>,
     "sg.linear_elastic{ E, nu }\n"
     "Hooke's law of small strains, sigma = lambda tr(eps) I + 2 mu eps; contact still follows the deformed surface.\n"
     "E: Young's modulus (force per area), nu: Poisson's ratio in (-1, 0.5). Plane strain in 2D, unless the model is\n"
     "axisymmetric.\n"
     "Source: linear elasticity; how it is used, share/doc/theory.md, Bodies.\n"
     "Example: sg.linear_elastic{ E = 1, nu = 0.3 }"},
};

constexpr Function material_entries[] = {
    {"__tostring", material_text,
     "material\nWhat sg.neo_hookean and sg.linear_elastic return; print(material) tells the law and its constants."},
};

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
