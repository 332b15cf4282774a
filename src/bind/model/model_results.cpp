#include "bind/lua/open.hpp"
#include "bind/model/model.hpp"
#include "contact/method/peak.hpp"
#include "model/results/face_values.hpp"
#include "model/results/profile.hpp"
#include "model/results/sample.hpp"
#include "model/results/set_forces.hpp"
#include "model/results/tie_results.hpp"
#include "model/steps/linear_solution.hpp"
#include "solve/factor_estimate.hpp"

#include <cmath>
#include <set>

namespace signorini::bind {

namespace {

/// Sets the components of a force by name.
template <int D> void set_force(lua_State* L, const Vec<D>& force) {
  for (int k = 0; k < D; ++k) set_field(L, text("f", model::component_name(k)).c_str(), force(k));
}

/// The force of a support or a load.
template <int D> int reaction(const model::Model<D>& model, const std::string& name, lua_State* L) {
  const auto& scene = model.system.scene;
  const auto load = std::ranges::find(scene.loads, name, &model::Load::name);
  const bool loaded = load != scene.loads.end();
  const int support = loaded ? -1 : find(scene.supports, name, "support");
  const Vec<D> force = loaded ? model::load_resultant(model, static_cast<int>(load - scene.loads.begin()))
                              : model::reaction(model, support);
  push(L, VectorX(force));
  set_force<D>(L, force);
  if (!loaded && scene.supports[support].turns()) {
    const double moment = model::moment(model, support);
    push(L, moment);
    lua_rawseti(L, -2, D + 1);
    set_field(L, "moment", moment);
  }
  return 1;
}

/// The unknown motions of a support's obstacles.
template <int D> int free_motion(const model::Model<D>& model, const std::string& name, lua_State* L) {
  const int support = find(model.system.scene.supports, name, "support");
  lua_newtable(L);
  for (const auto& [key, value] : model::free_motion(model, support)) set_field(L, key.c_str(), value);
  return 1;
}

/// Area on which the tractions of a contact act.
template <int D> const char* area_name(const model::Contact<D>& contact) {
  return contact.method.law.per == contact::TractionArea::current ? "current" : "reference";
}

const char* name_of(contact::Enforcement enforcement) {
  return enforcement == contact::Enforcement::multipliers ? "multipliers" : "penalty";
}

const char* name_of(contact::MultiplierSpace space) {
  return space == contact::MultiplierSpace::equal    ? "equal"
         : space == contact::MultiplierSpace::linear ? "linear"
                                                     : "reduced";
}

template <int D> int contact_law(const model::Model<D>& model, const std::string& name, lua_State* L) {
  const std::size_t contact = find(model.system.scene.contacts, name, "contact");
  const model::Contact<D>& named = model.system.scene.contacts[contact];
  const contact::History<D>& history = model.present.contacts[contact];
  const contact::Formulation<D>& formulation = *model.system.contacts[contact];
  push_fields(L, "points", named.points, "per", area_name(named), "active",
              formulation.parameters().active(history.changes));
  if (named.method.bond) {
    const auto& [strength, energy, softening, stiffness, formula] = *named.method.bond;
    const bool bilinear = softening == contact::Softening::bilinear;
    set_fields(L, "strength", strength, "energy", energy);
    if (formula)
      set_fields(L, "traction", contact::text_of(*formula), "stiffness", formula->stiffness, "shear", formula->shear,
                 "shear_strength", formula->shear * formula->peak(1).traction, "shear_energy", formula->rest(0, 1));
    else
      set_field(L, "law", bilinear ? "bilinear" : "exponential");
    if (bilinear) set_field(L, "stiffness", stiffness);
    const auto bonded = std::ranges::count_if(formulation.bonds()->closest,
                                              [&](const auto& bond) { return bond.foot != contact::Foot::none; });
    set_field(L, "bonded", static_cast<int>(bonded));
  }
  if (const auto& adhesion = named.method.law.adhesion) {
    set_fields(L, "method", "gpts", "hamaker", adhesion->hamaker, "r0", adhesion->distance);
    return 1;
  }
  const bool half = named.method.pass == contact::Pass::half;
  const auto& multipliers = named.method.multipliers;
  set_field(L, "method", half ? "half_passes" : multipliers ? "mortar" : "gpts");
  if (multipliers && !half) set_field(L, "multipliers", name_of(*multipliers));
  const contact::InterfaceLaw law = contact::changed(named.method.law, history.changes);
  set_fields(L, "offset", formulation.parameters().offset(history.changes), "enforcement", name_of(law.enforcement),
             "default_penalty", named.default_penalty && !history.changes.normal);
  if (law.pressure) {
    set_field(L, "pressure", contact::text_of(*law.pressure));
    if (std::isfinite(law.pressure->clearance)) set_field(L, "clearance", law.pressure->clearance);
  } else
    set_field(L, "penalty", law.normal);
  if (named.start.interference) set_field(L, "overlap", history.changes.overlap);
  if (contact::may_rub(law)) set_field(L, "friction_penalty", law.tangential);
  if (const auto& formula = law.coefficient)
    set_field(L, "mu_formula", contact::text_of(*formula));
  else if (law.ellipse)
    set_fields(L, "mu1", (*law.ellipse)(0), "mu2", (*law.ellipse)(1));
  else if (contact::may_rub(law))
    set_field(L, "mu", law.friction);
  if (law.along) set_field(L, "along", VectorX(law.along->template head<D>()));
  if (law.wear)
    set_fields(L, "wear_rate", contact::text_of(*law.wear->rate), "wear_update",
               law.wear->update == contact::WearUpdate::after ? "explicit" : "implicit");
  if (contact::of_rate(law))
    set_field(L, "of_rate", law.coefficient && law.coefficient->of_rate ? "friction.mu" : "wear.rate");
  return 1;
}

/// Fields of a set: `pairs`, the forces between its bodies by "<first>_<second>", and `imbalance` of half passes.
template <int D> void set_pairs(const model::Model<D>& model, int contact, lua_State* L) {
  const model::Scene<D>& scene = model.system.scene;
  lua_newtable(L);
  for (const model::PairForce<D>& pair : model::set_forces(model, contact)) {
    lua_newtable(L);
    set_force<D>(L, pair.force);
    lua_setfield(L, -2, (scene.bodies[pair.first].name + "_" + scene.bodies[pair.second].name).c_str());
  }
  lua_setfield(L, -2, "pairs");
  if (scene.contacts[contact].method.pass == contact::Pass::half)
    set_field(L, "imbalance", model::set_imbalance(model, contact));
}

template <int D> int contact_resultant(const model::Model<D>& model, const std::string& name, lua_State* L) {
  const std::size_t contact = find(model.system.scene.contacts, name, "contact");
  const auto sum = contact::resultant(model.present.contacts[contact]);
  const double area = model::contact_area(model, contact, model.present.contacts[contact]).area;
  push_fields(L, "area", area, "max_pressure", sum.max_pressure, "max_penetration", sum.max_penetration, "active",
              sum.active, "slipping", sum.slipping, "mean_pressure",
              contact::mean_pressure(model.system.contacts[contact]->points(), model.present.contacts[contact]));
  const model::Contact<D>& named = model.system.scene.contacts[contact];
  const bool is_half = named.other_pass >= 0;
  set_field(L, "per", area_name(named));
  if (is_half) set_field(L, "imbalance", model::imbalance(model, static_cast<int>(contact)));
  if (is_set(named))
    set_pairs(model, static_cast<int>(contact), L);
  else
    set_force<D>(L, sum.force);
  if (may_rub(named.method.law)) set_field(L, "slip", contact::mean_slip(model.present.contacts[contact]));
  if (named.method.bond)
    set_field(L, "debonded",
              model.system.contacts[contact]->bonds()->debonded(model.system.contacts[contact]->points(),
                                                                model.present.contacts[contact]));
  if (named.method.law.wear) set_field(L, "worn_volume", model.present.contacts[contact].worn_volume);
  const auto& multipliers = model.present.contacts[contact].multiplier_results;
  double weighted = 0;
  for (const auto& one : multipliers)
    if (one.state != contact::ContactState::open) weighted = std::max(weighted, -one.gap);
  if (!multipliers.empty()) set_field(L, "weighted_penetration", weighted);
  const contact::Formulation<D>& formulation = *model.system.contacts[contact];
  const auto set_count = [&](const char* name, const char* place, std::size_t count, const auto& latest) {
    set_field(L, name, static_cast<int>(count));
    if (count > 0) set_field(L, place, VectorX(latest()));
  };
  if (formulation.parameters().by_formula()) {
    const auto& counters = formulation.counters;
    set_count("flawed", "flawed_at", counters.flawed, [&] { return counters.flawed_at; });
    constexpr const char* flaws[] = {"none", "jumps", "negative", "negative wear", "undefined", "undefined wear"};
    if (counters.flawed > 0) set_field(L, "flaw", flaws[static_cast<std::size_t>(counters.flaw)]);
  }
  set_count("unsettled", "unsettled_at", formulation.counters.unsettled,
            [&] { return formulation.counters.unsettled_at; });
  const auto crossed = contact::crossed(formulation, model.present.contacts[contact], model.accepted.contacts[contact]);
  set_count("crossed", "crossed_at", crossed.size(), [&] { return formulation.points().reference[crossed.back()]; });
  return 1;
}

template <int D> int profile(const model::Model<D>& model, const std::string& name, lua_State* L) {
  const model::Profile all = model::profile<D>(model, find(model.system.scene.contacts, name, "contact"));
  push_fields(L, "x", all.x, "y", all.y, "X", all.reference_x, "Y", all.reference_y, "area", all.area, "pressure",
              all.pressure, "traction", all.traction, "gap", all.gap, "inside", all.inside, "state", all.state);
  if (!all.face.empty()) set_field(L, "face", all.face);
  if (!all.damage.empty()) set_field(L, "damage", all.damage);
  if (!all.mix.empty()) set_field(L, "mix", all.mix);
  if (!all.mu.empty()) set_fields(L, "mu", all.mu, "slip", all.slip);
  if (!all.worn.empty()) set_field(L, "worn", all.worn);
  if (D == 3)
    set_fields(L, "z", all.z, "Z", all.reference_z, "tx", all.traction_x, "ty", all.traction_y, "tz", all.traction_z);
  return 1;
}

template <int D> int tie_resultant(const model::Model<D>& model, const std::string& name, lua_State* L) {
  const auto now = model::tie_resultant(model, find(model.system.scene.ties, name, "tie"));
  push_fields(L, "area", now.area, "part", now.part, "distance", now.distance);
  set_force<D>(L, now.force);
  return 1;
}

template <int D> int tie_profile(const model::Model<D>& model, const std::string& name, lua_State* L) {
  const auto all = model::tie_profile(model, find(model.system.scene.ties, name, "tie"));
  const auto& [x, y, z] = all.position;
  const auto& [reference_x, reference_y, reference_z] = all.reference;
  const auto& [tx, ty, tz] = all.traction;
  push_fields(L, "x", x, "y", y, "X", reference_x, "Y", reference_y, "area", all.area, "pressure", all.pressure,
              "traction", all.shear, "tx", tx, "ty", ty, "jump", all.jump);
  if (D == 3) set_fields(L, "z", z, "Z", reference_z, "tz", tz);
  return 1;
}

/// Index of the body at stack index 2, a name or a body; axisymmetric models also accept the plane body from which
/// theirs was made.
template <int D> int body_of_argument(lua_State* L, const model::Model<D>& model) {
  if (lua_isstring(L, 2)) return find_body(model, to<std::string>(L, 2));
  const Body<D>& wanted = read_object<Body<D>>(L, 2, {"body", "a body or its name"});
  const auto& bodies = model.system.scene.bodies;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    if (&bodies[b].body->space() == &wanted->space()) return static_cast<int>(b);
  fail("this body is not part of the model");
}

template <int D> int sample(const model::Model<D>& model, lua_State* L) {
  const int body = body_of_argument<D>(L, model);
  const auto name = to<std::string>(L, 3);
  const auto point = to<VectorX>(L, 4);
  if (point.size() != D)
    reject(L, 4, {"xi", "parametric coordinates"},
           D == 2 ? "a list of 2 numbers {xi1, xi2}" : "a list of 3 numbers {xi1, xi2, xi3}");
  const auto on_faces = model::face_field(name);
  push(L, on_faces ? model::sample_face(model, *on_faces, body, point)
                   : model::sample(model, body, model::find_field<D>(name), point));
  return 1;
}

template <int D> int energy(const model::Model<D>& model, lua_State* L) {
  const model::Energies now = model::energies(model);
  push_fields(L, "stored", now.stored, "contact", now.contact, "friction", now.friction, "work", now.work,
              "area_growth", now.growth, "debonding", now.debonding, "wear", now.wear, "viscous", now.viscous);
  return 1;
}

// ── Sizes of a model, which lua/signorini/run/cost.lua prints
// ────────────────────────────────────────────────────────────

/// Number of contact points that act.
template <int D> int acting_points(const contact::ContactPoints<D>& points, const contact::History<D>& history) {
  int count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) count += acts(points, history, i);
  return count;
}

/// Unknowns shared by control points count once; those of the contact layer belong to the rows of the contact faces.
template <int D> void push_body_cost(lua_State* L, const model::Model<D>& model, int index) {
  const auto& unknowns = model.system.unknowns;
  const solid::Body<D>& body = *model.system.scene.bodies[index].body;
  std::set<int> all, layer;
  int points = 0;
  for (int e = 0; e < body.elements(); ++e) points += body.tables().element(e).points;
  const auto unknown = [&](int i) { return unknowns.unknown(unknowns.offset(index) + i); };
  int prescribed = 0;
  for (int i = 0; i < D * body.functions(); ++i)
    if (unknown(i) >= 0)
      all.insert(unknown(i));
    else
      ++prescribed;
  for (nurbs::Side side : body.space().contact())
    for (int function : body.space().face_functions(side))
      for (int i = D * function; i < D * (function + 1); ++i)
        if (unknown(i) >= 0) layer.insert(unknown(i));
  const auto unknowns_in_all = static_cast<int>(all.size()), in_layer = static_cast<int>(layer.size());
  push_fields(L, "unknowns", unknowns_in_all, "interface", in_layer, "bulk", unknowns_in_all - in_layer, "prescribed",
              prescribed, "elements", body.elements(), "gauss_points", points);
}

/// Bytes of the factors as measured by the linear solver; before the first solve an estimate for the solver that would
/// be chosen.
template <int D> double push_factors(lua_State* L, const model::Model<D>& model) {
  double memory = model.linear.statistics().memory;
  solve::LinearKind solver = model.linear.kind();
  const bool counted = memory == 0 && model.system.unknowns.size() > 0;
  if (counted) {
    constexpr bool damps = false;
    const auto estimate = solve::estimate_factor(model::first_choice(model::linear_facts(model.system), damps),
                                                 model.system.assembly.tangent().pattern);
    memory = estimate.memory;
    solver = estimate.kind;
  }
  set_fields(L, "factors_are", counted ? "counted" : "measured", "linear", solve::name_of(solver));
  return memory;
}

template <int D> int cost(const model::Model<D>& model, lua_State* L) {
  const model::Scene<D>& scene = model.system.scene;
  push_fields(L, "unknowns", model.system.unknowns.size(), "obstacles", static_cast<int>(scene.obstacles.size()),
              "nonzeros", model.system.assembly.tangent().pattern.entries());
  const double factors = push_factors(L, model), tangent = model.system.assembly.memory();
  double bodies = 0, contacts = 0;
  lua_newtable(L);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    bodies += static_cast<double>(scene.bodies[b].body->memory());
    push_body_cost(L, model, static_cast<int>(b));
    lua_setfield(L, -2, scene.bodies[b].name.c_str());
  }
  lua_setfield(L, -2, "bodies");
  lua_newtable(L);
  for (std::size_t k = 0; k < scene.contacts.size(); ++k) {
    contacts += model.system.contacts[k]->memory();
    for (const auto* state : {&model.accepted, &model.present}) contacts += contact::memory(state->contacts[k]);
    push_fields(L, "points", acting_points(model.system.contacts[k]->points(), model.present.contacts[k]), "rigid",
                std::holds_alternative<model::ObstacleReference>(scene.contacts[k].master));
    lua_setfield(L, -2, scene.contacts[k].name.c_str());
  }
  lua_setfield(L, -2, "contacts");
  set_field(L, "memory", bodies + contacts + tangent + factors);
  push_fields(L, "bodies", bodies, "contacts", contacts, "tangent", tangent, "factors", factors);
  lua_setfield(L, -2, "memory_of");
  return 1;
}

template <int D>
constexpr Function model_results_entries[] = {
    {"reaction", call<reaction<D>>},       {"free_motion", call<free_motion<D>>},
    {"contact_law", call<contact_law<D>>}, {"contact_resultant", call<contact_resultant<D>>},
    {"profile", call<profile<D>>},         {"tie_resultant", call<tie_resultant<D>>},
    {"tie_profile", call<tie_profile<D>>}, {"sample", call<sample<D>>},
    {"energy", call<energy<D>>},           {"cost", call<cost<D>>},
};

} // namespace

void open_results(lua_State* L) {
  register_type<Model<2>, Model<3>>(L, model_results_entries<2>, model_results_entries<3>);
}

} // namespace signorini::bind
