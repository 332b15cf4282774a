#include "model/economy.hpp"

#include "base/error.hpp"
#include "base/index.hpp"
#include "base/orthonormal.hpp"
#include "model/changed_space.hpp"
#include "model/cost.hpp"

#include <set>

namespace signorini::model {

namespace {

using nurbs::Discretisation;
using nurbs::KnotVector;
using nurbs::Row;
using nurbs::Side;
using nurbs::Space1D;

int master_body(const auto& contact) {
  const auto* face = std::get_if<FaceReference>(&contact.master);
  return face ? face->body : -1;
}

/// Whether one support alone prescribes how a body moves as a whole.
template <int D> bool moves_as_prescribed(const Scene<D>& scene, int body) {
  const bool revolved = scene.kind == solid::Kind::axisymmetric;
  int movers = 0;
  for (const Support<D>& support : scene.supports) {
    if (std::none_of(support.on.begin(), support.on.end(), [&](const Held& held) { return held.body == body; }))
      continue;
    if (support.rotates) return false;
    // Across the axis a body of revolution cannot move as a whole.
    const auto& hold = support.hold;
    if (revolved && hold[0] == Hold::driven) return false;
    if (revolved && hold[1] == Hold::free) continue;
    if (std::count(hold.begin() + (revolved ? 1 : 0), hold.end(), Hold::free) > 0) return false;
    ++movers;
  }
  return movers == 1;
}

/// Np or Np.s; nothing where all breakpoints are C⁰, which many labels may have left, or no label leads to the space.
std::optional<std::string> label_of(const Space1D& space) {
  int smooth = space.elements() == 1 ? space.degree() - 1 : 0;
  for (int k = 1; k < space.elements(); ++k) smooth = std::max(smooth, space.smoothness()[at(k)]);
  if (!space.knots() || (smooth == 0 && space.degree() > 1)) return std::nullopt;
  const int elevations = space.degree() - smooth - 1;
  return elevations == 0 ? text("N", smooth + 1) : text("N", smooth + 1, ".", elevations);
}

/// Degree 2 on the same elements, as continuous as can be and this space is.
KnotVector quadratic(const Space1D& space) {
  std::vector<double> list;
  for (std::size_t k = 0; k < space.breaks().size(); ++k)
    list.insert(list.end(), at(2 - std::min(space.smoothness()[k], 1)), space.breaks()[k]);
  return {2, std::move(list)};
}

/// The columns that a quadratic's functions are in the space that elevation makes of theirs.
MatrixX elevated_functions(const KnotVector& low, int times, KnotVector& elevated) {
  MatrixX columns;
  for (int first = 0; first < low.functions(); first += 3) {
    MatrixX points = MatrixX::Zero(4, low.functions());
    points.row(3).setOnes();
    const int count = std::min(3, low.functions() - first);
    for (int k = 0; k < count; ++k) points(k, first + k) = 1;
    const nurbs::Patch high = nurbs::elevate(nurbs::Patch({low}, points), 0, times);
    elevated = high.direction(0);
    columns.conservativeResize(high.functions(), low.functions());
    columns.middleCols(first, count) = high.homogeneous().topRows(count).transpose();
  }
  return columns;
}

/// Whether a row is one of B-splines and its map one of the quadratic space on its elements along direction a.
bool quadratic_holds(const Row& row, int a) {
  std::vector<KnotVector> knots;
  for (const Space1D& direction : row.directions()) {
    if (!direction.knots()) return false;
    knots.push_back(*direction.knots());
  }
  const KnotVector own = knots[at(a)], low = quadratic(row.direction(a));
  KnotVector common = own;
  const MatrixX functions = elevated_functions(low, own.degree() - 2, common);
  std::vector<double> missing;
  for (int k = 1; k < own.elements(); ++k) {
    const double knot = own.breaks()[at(k)];
    missing.insert(missing.end(), at(std::max(0, common.multiplicity(knot) - own.multiplicity(knot))), knot);
  }
  const nurbs::Patch refined = nurbs::insert_knots({std::move(knots), row.homogeneous()}, a, missing);
  const MatrixX basis = orthonormal(functions);
  const MatrixX& values = refined.homogeneous();
  const int count = common.functions(), stride = a == 0 ? 1 : refined.direction(0).functions();
  for (int line = 0; line < refined.functions() / count; ++line) {
    const int first = a == 0 ? line * count : line;
    MatrixX data(count, values.rows());
    for (int i = 0; i < count; ++i) data.row(i) = values.col(first + i * stride).transpose();
    if (residual_of(basis, data).cwiseAbs().maxCoeff() > 1e-9 * data.cwiseAbs().maxCoeff()) return false;
  }
  return true;
}

/// The functions of a direction with `count` functions that take the places of one with `present`.
std::vector<int> images(int count, int present) {
  std::vector<int> list(at(count), 1); // all inner ones are alike
  list.front() = 0;
  list.back() = present - 1;
  return list;
}

/// Unknowns of a body in a changed space; what turns with a face keeps its shared unknowns.
template <int D> int count_unknowns(const Model<D>& model, int body, const ChangedSpace& changed) {
  const Unknowns<D>& unknowns = model.system.unknowns;
  std::set<int> shared;
  const int own = count_free(model.system.scene.bodies[at(body)].body->space(), changed, D,
                             [&](int component, int function, const Place&) {
                               const int dof = unknowns.offset(body) + D * function + component;
                               const int unknown = unknowns.unknown(dof);
                               if (unknown >= 0 && unknowns.held(dof)) shared.insert(unknown);
                               return unknown < 0 || unknowns.held(dof);
                             });
  return own + static_cast<int>(shared.size());
}

template <int D> bool in_contact(const Scene<D>& scene, const FaceReference& face) {
  return std::any_of(scene.contacts.begin(), scene.contacts.end(), [&](const Contact<D>& contact) {
    const auto* master = std::get_if<FaceReference>(&contact.master);
    return contact.slave == face || (master && *master == face);
  });
}

/// Whether any of a body's faces that carry a layer, or may, is in contact.
template <int D> bool meets(const Scene<D>& scene, int body) {
  const auto& sides = scene.bodies[at(body)].body->space().contact();
  return std::any_of(sides.begin(), sides.end(), [&](const Side& side) {
    return in_contact(scene, FaceReference{body, side});
  });
}

bool uniform(const Discretisation& space) {
  return std::all_of(space.rows().begin(), space.rows().end(),
                     [&](const Row& row) { return row.directions() == space.rows().front().directions(); });
}

/// Whether a row of control points lies on one of the contact faces.
bool on_contact(const Discretisation& space, int row) {
  const int last = space.stack().functions() - 1;
  return std::any_of(space.contact().begin(), space.contact().end(),
                     [&](const Side& side) { return row == (side.at_end ? last : 0); });
}

/// The row farthest from the contact faces: the bulk's.
int bulk_row(const Discretisation& space) {
  const int last = space.stack().functions() - 1;
  return space.contact().size() > 1 ? last / 2 : space.contact().front().at_end ? 0 : last;
}

/// Names the degree in the thickness direction, which stays, where the new labels alone would lead to another one.
void keep_thickness(const Discretisation& space, LabelChoice& choice) {
  std::vector<nurbs::Label> labels;
  for (const std::string& label : choice.labels) labels.push_back(nurbs::parse_label(label));
  const int present = space.stack().degree();
  if (present != nurbs::bulk_space(labels).full_degree()) choice.through = present;
}

/// N2 in place of degrees above, except on the contact faces.
template <int D> std::optional<LabelChoice> layer_of(const Model<D>& model, int body) {
  const Discretisation& space = model.system.scene.bodies[at(body)].body->space();
  if (space.contact().empty() || !uniform(space) || !meets(model.system.scene, body)) return std::nullopt;
  LabelChoice choice{body, {}, 0};
  ChangedSpace changed = unchanged(space);
  bool lower = false;
  for (int a = 0; a < D - 1; ++a) {
    const Space1D& present = space.rows().front().direction(a);
    const auto label = label_of(present);
    if (!label) return std::nullopt;
    choice.labels.push_back(*label);
    if (present.degree() <= 2 || label->starts_with("N1") ||
        !std::all_of(space.rows().begin(), space.rows().end(), [&](const Row& row) { return quadratic_holds(row, a); }))
      continue;
    lower = true;
    choice.labels.back() = "N2-" + *label;
    for (int j = 0; j < static_cast<int>(changed.size()); ++j)
      if (!on_contact(space, j))
        changed[at(j)].along[at(a)] = images(quadratic(present).functions(), present.functions());
  }
  if (!lower) return std::nullopt;
  choice.unknowns = count_unknowns(model, body, changed);
  keep_thickness(space, choice);
  return choice;
}

/// The bulk's label for a body whose layers touch nothing.
template <int D> std::optional<LabelChoice> bulk_of(const Model<D>& model, int body) {
  const Discretisation& space = model.system.scene.bodies[at(body)].body->space();
  if (space.contact().empty() || uniform(space) || meets(model.system.scene, body)) return std::nullopt;
  LabelChoice choice{body, {}, 0};
  const Row& bulk = space.rows()[at(bulk_row(space))];
  for (const Space1D& direction : bulk.directions()) {
    const auto label = label_of(direction);
    if (!label) return std::nullopt;
    choice.labels.push_back(*label);
  }
  ChangedSpace changed = unchanged(space);
  for (int j = 0; j < static_cast<int>(changed.size()); ++j)
    for (int a = 0; a < D - 1; ++a)
      changed[at(j)].along[at(a)] = images(bulk.direction(a).functions(), space.rows()[at(j)].direction(a).functions());
  choice.unknowns = count_unknowns(model, body, changed);
  keep_thickness(space, choice);
  return choice;
}

} // namespace

template <int D> std::vector<StiffBody> find_stiff_bodies(const Model<D>& model) {
  constexpr double much = 100;
  const Scene<D>& scene = model.system.scene;
  const auto modulus = [&](int body) { return scene.bodies[at(body)].body->material().constants().youngs_modulus; };
  std::vector<StiffBody> found;
  for (int b = 0; b < static_cast<int>(scene.bodies.size()); ++b) {
    int partner = -1;
    bool fits = moves_as_prescribed(scene, b);
    for (const Contact<D>& contact : scene.contacts) {
      const int slave = contact.slave.body, master = master_body(contact);
      if (slave != b && master != b) continue;
      const int other = slave == b ? master : slave;
      if (other < 0 || other == b) {
        fits = false; // an obstacle meets no obstacle
      } else if (partner < 0 || modulus(other) > modulus(partner)) {
        partner = other;
      }
    }
    if (!fits || partner < 0 || modulus(b) < much * modulus(partner)) continue;
    if (std::any_of(scene.loads.begin(), scene.loads.end(), [&](const Load& load) {
          return std::any_of(load.on.begin(), load.on.end(), [&](const FaceReference& face) { return face.body == b; });
        }))
      continue;
    found.push_back({b, partner, modulus(b) / modulus(partner), body_cost(model, b).unknowns});
  }
  return found;
}

template <int D> std::vector<LabelChoice> find_layers(const Model<D>& model) {
  std::vector<LabelChoice> found;
  for (int b = 0; b < static_cast<int>(model.system.scene.bodies.size()); ++b)
    if (auto choice = layer_of(model, b)) found.push_back(std::move(*choice));
  return found;
}

template <int D> std::vector<LabelChoice> find_idle_layers(const Model<D>& model) {
  std::vector<LabelChoice> found;
  for (int b = 0; b < static_cast<int>(model.system.scene.bodies.size()); ++b)
    if (auto choice = bulk_of(model, b)) found.push_back(std::move(*choice));
  return found;
}

template <int D> std::vector<DenseContact> find_dense_contacts(const Model<D>& model) {
  std::vector<DenseContact> found;
  const auto& contacts = model.system.scene.contacts;
  for (int k = 0; k < static_cast<int>(contacts.size()); ++k) {
    const contact::Surface<D>& slave = model.system.contacts[at(k)]->slave();
    const int degree = std::max(slave.direction(0).degree(), slave.direction(D - 2).degree());
    const int enough = 3 * (degree + 1);
    if (contacts[at(k)].points > 2 * enough && !limited(model, k))
      found.push_back({k, enough, points_everywhere(model, k, enough)});
  }
  return found;
}

template std::vector<StiffBody> find_stiff_bodies(const Model<2>&);
template std::vector<StiffBody> find_stiff_bodies(const Model<3>&);
template std::vector<LabelChoice> find_layers(const Model<2>&);
template std::vector<LabelChoice> find_layers(const Model<3>&);
template std::vector<LabelChoice> find_idle_layers(const Model<2>&);
template std::vector<LabelChoice> find_idle_layers(const Model<3>&);
template std::vector<DenseContact> find_dense_contacts(const Model<2>&);
template std::vector<DenseContact> find_dense_contacts(const Model<3>&);

} // namespace signorini::model
