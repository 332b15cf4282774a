#include "bind/scene/material.hpp"
#include "base/words.hpp"
#include "bind/lua/functions.hpp"
#include "bind/lua/open.hpp"
#include "bind/lua/wording/wording.hpp"
#include "bind/scene/scene.hpp"
#include "bind/scene/symbols.hpp"
#include "solid/hyperelastic.hpp"
#include "solid/linear_elastic.hpp"
#include "solid/neo_hookean.hpp"
#include "solid/stability.hpp"
#include "solid/viscoelastic.hpp"

#include <algorithm>

namespace signorini::bind {

std::string constants_in_words(const solid::Material& material) {
  const solid::ElasticConstants& law = material.constants();
  return text("E = ", law.youngs_modulus, ", nu = ", law.poissons_ratio);
}

namespace {

template <auto make> solid::Material material(const Arguments& a) {
  return make(a.get<double>("E"), a.get<double>("nu"));
}

/// A law of a formula has two more lines: "E = …, nu = … without strain", and the formula; a viscoelastic one that of
/// its terms.
std::string material_text(const solid::Material& material) {
  if (const solid::Viscoelastic* law = solid::viscoelastic_law(material)) {
    std::string terms;
    for (const auto& [fraction, time] : law->series)
      terms += text(terms.empty() ? "" : ", ", fraction, " within tau = ", time);
    return text(material_text(law->elastic), "\n  of its ",
                law->relaxes == solid::Relaxes::all ? "stress" : "stress of the change of shape", " relax ", terms);
  }
  const solid::Hyperelastic* law = solid::hyperelastic_law(material);
  if (!law) return text(material.name(), ": ", constants_in_words(material));
  const solid::EnergyFormula& formula = law->formula();
  std::string fibers;
  for (const Vec<3>& fiber : formula.fibers) fibers += text(fibers.empty() ? "" : ", ", coordinates(fiber));
  return text(formula.label, ": ", constants_in_words(material), " without strain", fibers.empty() ? "" : ", fibers ",
              fibers, "\n  W(", listed(formula.graph.variables()),
              ") = ", symbolic::text_of(formula.graph, formula.energy));
}

/// sg.viscoelastic{ law, g = {…}, tau = {…}, relaxes }
solid::Material viscoelastic(const Arguments& a) {
  const auto fractions = a.get<std::vector<double>>("g"), times = a.get<std::vector<double>>("tau");
  std::vector<solid::Relaxation> series;
  for (std::size_t i = 0; i < std::min(fractions.size(), times.size()); ++i) series.push_back({fractions[i], times[i]});
  return solid::viscoelastic(a.object<solid::Material>("law"), std::move(series),
                             choice<solid::Relaxes>(a.get<std::string>("relaxes"), {"shape", "all"}));
}

solid::Measure measure_of(const std::string& name) {
  return choice<solid::Measure>(name, {"invariants", "stretches"});
}

/// core.strain_symbols("invariants" or "stretches", number of fibers): a list of the arguments of an energy.
int strain_symbols(lua_State* L) {
  push_variables(L, solid::variable_names(measure_of(to<std::string>(L, 1)),
                                          static_cast<std::size_t>(std::clamp(to<int>(L, 2), 0, 100))));
  return 1;
}

/// core.hyperelastic{ label, measure, fibers = {{x, y, z}, …}, energy = symbol }
solid::Material hyperelastic(const Arguments& a) {
  std::vector<Vec<3>> fibers;
  a.list("fibers", [&](int, int index, const std::string&) {
    const auto given = to<std::vector<double>>(a.state(), index);
    require(given.size() <= 3, "a fiber is a list of at most 3 numbers");
    Vec<3> fiber = Vec<3>::Zero();
    for (std::size_t i = 0; i < given.size(); ++i) fiber(static_cast<int>(i)) = given[i];
    fibers.push_back(fiber);
  });
  const auto& energy = a.object<Symbol>("energy");
  try {
    return solid::hyperelastic({a.get<std::string>("label"), measure_of(a.get<std::string>("measure")),
                                std::move(fibers), *energy.graph, energy.node});
  } catch (const Error& error) {
    throw ArgumentError(text(a.get<std::string>("called"), ": ", worded(error)));
  }
}

/// core.unstable_law(model): a point of the first body whose law from a formula is unstable in the present state,
/// { body, stretches, at }; nil if there is none.
template <int D> int unstable_law(const model::Model<D>& model, lua_State* L) {
  const auto& bodies = model.system.scene.bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const double* displacement = model::body_displacement(model, static_cast<int>(b)).data();
    const auto found = solid::unstable_point(*bodies[b].body, displacement);
    if (!found) continue;
    push_fields(L, "body", bodies[b].name, "stretches", VectorX(found->stretches), "at", found->point);
    return 1;
  }
  return 0;
}

/// core.flows(model): true if a body has a material in which stress relaxes with time.
template <int D> bool flows(const model::Model<D>& model) {
  return std::ranges::any_of(model.system.scene.bodies,
                             [](const auto& named) { return solid::viscoelastic_law(named.body->material()); });
}

template <int D>
constexpr Function law_of_model[] = {{"unstable_law", call<unstable_law<D>>}, {"flows", call<flows<D>>}};

} // namespace

void open_material(lua_State* L) {
  register_functions(L, "sg",
                     {{"neo_hookean", call<material<solid::neo_hookean>>},
                      {"linear_elastic", call<material<solid::linear_elastic>>},
                      {"viscoelastic", call<viscoelastic>}});
  register_functions(L, "core", {{"strain_symbols", strain_symbols}, {"hyperelastic", call<hyperelastic>}});
  register_functions<Model<2>, Model<3>>(L, "core", law_of_model<2>, law_of_model<3>);
  register_type<solid::Material>(L, {{"__tostring", call<material_text>}});
}

} // namespace signorini::bind
