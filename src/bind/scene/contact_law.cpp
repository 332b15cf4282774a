#include "bind/lua/wording/wording.hpp"
#include "bind/scene/contact.hpp"
#include "bind/scene/symbols.hpp"

#include <cmath>
#include <limits>

namespace signorini::bind {

contact::MultiplierSpace read_multipliers(const Arguments& a) {
  return choice<contact::MultiplierSpace>(a.get<std::string>("multipliers"), {"equal", "reduced", "linear"});
}

namespace {

/// A formula that a function of signorini.scene.formula makes of an argument of a contact.
const Symbol& read_formula(const Arguments& a, const char* key, const char* maker, int dimension) {
  lua_State* L = a.state();
  push_require(L);
  lua_pushliteral(L, "signorini.scene.formula");
  lua_call(L, 1, 1);
  lua_getfield(L, -1, maker);
  push(L, a.name(key));
  a.push(key);
  lua_call(L, 2, 1);
  const Symbol& made = read_object<Symbol>(L, -1, {"a formula"});
  const symbolic::Graph& graph = *made.graph;
  for (const int node : symbolic::needed_for(graph, {made.node})) {
    require(!graph.is_constant(node) || std::isfinite(graph[node].value), a.name(key), " contains the number ",
            graph[node].value, ", but a formula must be finite. Hint: look for a division by zero");
    require(dimension == 3 || node >= std::ssize(graph.variables()) || graph.variables()[node] != "Z", a.name(key),
            " depends on Z, but a plane model has X and Y alone");
  }
  return made;
}

contact::Cohesion read_cohesion(const Arguments& contact, int dimension, double penalty) {
  const Arguments a = contact.table("cohesive");
  const double shear = a.get<double>("shear");
  if (a.has("traction") || a.is("energy", LUA_TFUNCTION) || a.is("strength", LUA_TFUNCTION) || shear != 1) {
    const Symbol& traction = read_formula(contact, "cohesive", "cohesion", dimension);
    try {
      return contact::cohesive(contact::make_cohesion_formula({*traction.graph, traction.node}, shear));
    } catch (const Error& error) {
      contact.fail(worded(error));
    }
  }
  contact::Cohesion cohesion{a.get<double>("strength"), a.get<double>("energy")};
  cohesion.softening = choice<contact::Softening>(a.get<std::string>("law"), {"exponential", "bilinear"});
  if (cohesion.softening == contact::Softening::bilinear) cohesion.stiffness = a.get("stiffness", penalty);
  return cohesion;
}

/// μ: a number, two in the directions of an axis, or a formula.
void read_coefficient(const Arguments& friction, int dimension, contact::InterfaceLaw& law) {
  law.frictional = true;
  if (friction.has("along")) {
    const auto along = friction.get<VectorX>("along");
    require(along.size() == dimension, friction.name("along"), " must have ", dimension, " components, got ",
            along.size());
    law.along.emplace(Vec<3>::Zero()).head(dimension) = along;
  }
  if (friction.is("mu", LUA_TNUMBER)) {
    law.friction = friction.get<double>("mu");
    return;
  }
  if (friction.is("mu", LUA_TTABLE) && lua_rawlen(friction.state(), friction.push("mu")) > 0) {
    law.ellipse = friction.get<VectorX>("mu");
    law.friction = law.ellipse->maxCoeff();
    return;
  }
  const Symbol& mu = read_formula(friction, "mu", "friction", dimension);
  law.friction = 1;
  law.coefficient = contact::make_slip_formula({*mu.graph, mu.node});
}

/// k of wear: a number, or a formula.
contact::Wear read_wear(const Arguments& wear, int dimension) {
  contact::Wear law;
  law.update = choice<contact::WearUpdate>(wear.get<std::string>("update"), {"implicit", "explicit"});
  if (wear.is("rate", LUA_TNUMBER)) {
    symbolic::Graph graph(contact::slip_variables());
    const int rate = graph.constant(wear.get<double>("rate"));
    law.rate = contact::make_slip_formula({graph, rate});
  } else {
    const Symbol& rate = read_formula(wear, "rate", "wear", dimension);
    law.rate = contact::make_slip_formula({*rate.graph, rate.node});
  }
  return law;
}

} // namespace

contact::Method read_method(const Arguments& a, int dimension) {
  if (a.has("adhesion")) {
    const Arguments adhesion = a.table("adhesion");
    return contact::adhesive({adhesion.get<double>("hamaker"), adhesion.get<double>("r0")});
  }
  contact::InterfaceLaw law{a.get("penalty", 0.0)};
  if (a.has("pressure")) {
    const Symbol& pressure = read_formula(a, "pressure", "pressure", dimension);
    const double clearance =
        a.is("clearance", LUA_TSTRING) ? std::numeric_limits<double>::infinity() : a.get("clearance", 0.0);
    law.pressure = contact::make_pressure_formula({*pressure.graph, pressure.node}, clearance);
  }
  if (a.has("friction")) {
    const Arguments friction = a.table("friction");
    read_coefficient(friction, dimension, law);
    law.tangential = friction.get("penalty", 0.0);
  }
  if (a.has("wear")) law.wear = read_wear(a.table("wear"), dimension);
  law.enforcement = choice<contact::Enforcement>(a.get<std::string>("enforcement"), {"penalty", "multipliers"});
  if (a.has("cohesive")) {
    law.per = contact::TractionArea::reference;
    return {law, {}, contact::Pass::full, read_cohesion(a, dimension, law.normal)};
  }
  enum class Points { gauss, half_passes, mortar };
  const auto points = choice<Points>(a.get<std::string>("method"), {"gpts", "half_passes", "mortar"});
  std::optional<contact::MultiplierSpace> space;
  if (a.has("multipliers")) space = read_multipliers(a);
  if (points == Points::half_passes) return {law, space, contact::Pass::half};
  if (points == Points::mortar || (a.has("per") && a.get<std::string>("per") == "reference"))
    law.per = contact::TractionArea::reference;
  if (points == Points::gauss) return law;
  using contact::MultiplierSpace;
  const bool solved = law.enforcement == contact::Enforcement::multipliers;
  return {law, space.value_or(solved ? MultiplierSpace::automatic : MultiplierSpace::equal)};
}

} // namespace signorini::bind
