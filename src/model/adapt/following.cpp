#include "model/adapt/following.hpp"

#include "base/error.hpp"
#include "model/results/profile.hpp"
#include "model/results/sample.hpp"
#include "solid/quadrature.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace signorini::model {

namespace {

using nurbs::Discretization;

/// Index of a contact face in Discretization::contact(); −1 if it is another side.
int contact_index(const Discretization& space, nurbs::Side side) {
  const auto& faces = space.contact();
  const auto found = std::ranges::find(faces, side);
  return found == faces.end() ? -1 : static_cast<int>(found - faces.begin());
}

/// The largest values of touching points by element of one body's face.
template <int D> class Marks {
public:
  Marks(const Scene<D>& scene, std::vector<LayerLine>& lines) : scene_(scene), lines_(lines) {}

  void add(const FaceReference& face, const std::array<int, D - 1>& index, double value) {
    const Discretization& space = scene_.bodies[face.body].body->space();
    const int own = contact_index(space, face.side);
    if (own < 0 || !space.recipe()) return;
    for (LayerLine& line : lines_) {
      if (line.body != face.body || line.face != static_cast<std::size_t>(own)) continue;
      const nurbs::Space1D& direction = space.rows().front().direction(static_cast<int>(line.direction));
      // Layer knots cut the elements of the plan.
      const int e = direction.elements() == std::ssize(line.jump)
                        ? index[line.direction]
                        : whole(space, direction, line.direction, index[line.direction]);
      line.jump[e] = std::max({line.jump[e], value, touch});
    }
  }

private:
  static int whole(const Discretization& space, const nurbs::Space1D& direction, std::size_t a, int element) {
    const int row = static_cast<int>(a), d = row < space.through() ? row : row + 1;
    const std::vector<double> breaks = nurbs::element_breaks(space.recipe()->patch, space.recipe()->plan, d);
    const auto [from, to] = direction.interval(element);
    return nurbs::find_element(breaks, 0.5 * (from + to));
  }
  const Scene<D>& scene_;
  std::vector<LayerLine>& lines_;
};

/// Cauchy stress at a point.
template <int D> Mat<D> cauchy_stress(const Model<D>& model, int body, const BodyPoint<D>& point) {
  static const std::vector<std::array<const Field<D>*, D>> fields = [] {
    std::vector<std::array<const Field<D>*, D>> rows(D);
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        rows[i][j] = &find_field<D>(std::string("s") + static_cast<char>('x' + std::min(i, j)) +
                                    static_cast<char>('x' + std::max(i, j)));
    return rows;
  }();
  Mat<D> result;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j) result(i, j) = value_at(model, body, *fields[i][j], point);
  return result;
}

/// σ n on the slave face of point i, n the outward normal of its tangents.
template <int D>
Vec<D> body_traction(const Model<D>& model, const contact::Formulation<D>& formulation, const FaceReference& face,
                     std::size_t i, const std::array<int, D - 1>& index, int points) {
  const Discretization& space = model.system.scene.bodies[face.body].body->space();
  const contact::ContactPoint& point = formulation.points().list[i];
  int element = 0, base = 1;
  VectorX xi(D);
  for (int d = 0, a = 0, rest = point.number; d < D; ++d) {
    int own = face.side.at_end ? space.elements(d) - 1 : 0;
    if (d == face.side.direction) {
      const auto [from, to] = d == space.through() ? space.stack().interval(own)
                                                   : space.rows().front().direction(space.in_row(d)).interval(own);
      xi(d) = face.side.at_end ? to : from;
    } else {
      own = index[a++];
      const nurbs::Space1D& direction = space.rows().front().direction(space.in_row(d));
      const auto [from, to] = direction.interval(own);
      xi(d) = solid::gauss_legendre(points, from, to).points[rest % points];
      rest /= points;
    }
    element += base * own;
    base *= space.elements(d);
  }
  const Vec<D> normal = normal_at(formulation.points(), formulation.slave(), i);
  return cauchy_stress<D>(model, face.body, regular_point(model, face.body, element, xi)) * normal;
}

template <int D> void mark(const Model<D>& model, std::size_t k, bool measured, std::vector<LayerLine>& lines) {
  const Contact<D>& contact = model.system.scene.contacts[k];
  const contact::Formulation<D>& formulation = *model.system.contacts[k];
  const contact::History<D>& history = model.accepted.contacts[k];
  const std::vector<char> inside = contact_area(model, k, history).inside;
  const auto* master = std::get_if<Faces>(&contact.master);
  Marks<D> marks(model.system.scene, lines);
  double largest = 0;
  for (const auto& result : history.results)
    if (result.area > 0) largest = std::max(largest, result.force.norm() / result.area);
  for (std::size_t i = 0; i < history.results.size(); ++i) {
    const contact::PointResult<D>& result = history.results[i];
    if (!inside[i]) continue;
    const auto [f, index] = own_element(formulation.slave(), formulation.points().list[i].element);
    double value = 1;
    if (measured && contact.slave.size() == 1 && result.area > 0 && largest > 0) {
      const Vec<D> traction = result.force / result.area;
      value =
          (traction - body_traction(model, formulation, contact.slave[f], i, index, contact.points)).norm() / largest;
    }
    marks.add(contact.slave[f], index, value);
    const int foot = history.points[i].projection.element;
    if (!master || foot < 0) continue;
    const auto [g, there] = own_element(*formulation.master().surface(), foot);
    marks.add((*master)[g], there, value);
  }
}

} // namespace

template <int D> std::vector<LayerLine> layer_lines(const Model<D>& model) {
  std::vector<LayerLine> lines;
  const auto& bodies = model.system.scene.bodies;
  for (int b = 0; b < std::ssize(bodies); ++b) {
    const Discretization& space = bodies[b].body->space();
    if (!space.recipe()) continue;
    const nurbs::Plan& plan = space.recipe()->plan;
    for (std::size_t f = 0; f < space.contact().size(); ++f)
      for (int a = 0; a < D - 1; ++a) {
        if (!plan.labels[a].layer) continue;
        const int d = a < space.through() ? a : a + 1;
        const std::size_t count = nurbs::element_breaks(space.recipe()->patch, plan, d).size() - 1;
        std::vector<bool> raised(count, true);
        if (!plan.raised.empty() && !plan.raised[f][a].empty()) raised = plan.raised[f][a];
        lines.push_back({b, f, a, std::move(raised), std::vector<double>(count, 0.0)});
      }
  }
  return lines;
}

template <int D> void mark_contact(const Model<D>& model, bool measured, std::vector<LayerLine>& lines) {
  for (std::size_t k = 0; k < model.system.contacts.size(); ++k) mark(model, k, measured, lines);
}

template <int D> std::vector<nurbs::RaisedElements> layers(const Model<D>& model) {
  std::vector<nurbs::RaisedElements> result;
  for (const auto& named : model.system.scene.bodies) {
    const auto& recipe = named.body->space().recipe();
    result.push_back(recipe ? recipe->plan.raised : nurbs::RaisedElements{});
  }
  return result;
}

template <int D> std::vector<nurbs::RaisedElements> layers(const Model<D>& model, const std::vector<LayerLine>& lines) {
  std::vector<nurbs::RaisedElements> result(model.system.scene.bodies.size());
  for (const LayerLine& line : lines) {
    const auto faces = model.system.scene.bodies[line.body].body->space().contact().size();
    result[line.body].resize(faces, std::vector<std::vector<bool>>(static_cast<std::size_t>(D - 1)));
    result[line.body][line.face][line.direction] = line.raised;
  }
  return result;
}

template <int D>
std::shared_ptr<Model<D>> with_layers(const Model<D>& model, const std::vector<nurbs::RaisedElements>& layers) {
  Bodies<D> bodies;
  for (std::size_t b = 0; b < layers.size(); ++b) {
    const auto& present = model.system.scene.bodies[b].body;
    bodies.push_back(present);
    const auto& recipe = present->space().recipe();
    if (!recipe || recipe->plan.raised == layers[b]) continue;
    auto space = std::make_shared<const Discretization>(nurbs::with_layer(present->space(), layers[b]));
    bodies.back() = std::make_shared<const solid::Body<D>>(std::move(space), present->material(), present->kind(),
                                                           present->volumetric(), present->density());
  }
  return with_bodies(model, bodies);
}

template <int D> void check_following(const Model<D>& model) {
  const auto& bodies = model.system.scene.bodies;
  require(std::ranges::any_of(bodies, [](const auto& named) { return named.body->space().recipe() != nullptr; }),
          "model.adapt.no_layer");
  for (const Contact<D>& contact : model.system.scene.contacts)
    require(!contact.adaptive_points, "model.adapt.auto_points", {{"contact", contact.name}});
  check_replaceable<D>(model.system.scene, [&](int b, int row) {
    const auto& recipe = bodies[b].body->space().recipe();
    if (!recipe) return false;
    const Discretization& space = bodies[b].body->space();
    const int count = space.stack().functions();
    int deep = 0;
    for (const nurbs::Label& label : recipe->plan.labels)
      if (label.layer) deep = std::max(deep, label.rows);
    return std::ranges::any_of(space.contact(),
                               [&](const nurbs::Side& side) { return (side.at_end ? count - 1 - row : row) < deep; });
  });
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template std::vector<LayerLine> layer_lines(const Model<D>&);                                                        \
  template void mark_contact(const Model<D>&, bool, std::vector<LayerLine>&);                                          \
  template std::vector<nurbs::RaisedElements> layers(const Model<D>&);                                                 \
  template std::vector<nurbs::RaisedElements> layers(const Model<D>&, const std::vector<LayerLine>&);                  \
  template std::shared_ptr<Model<D>> with_layers(const Model<D>&, const std::vector<nurbs::RaisedElements>&);          \
  template void check_following(const Model<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
