#include "model/results/face_values.hpp"

#include "base/error.hpp"
#include "solid/quadrature.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::model {

namespace {

struct FaceFieldNames {
  const char *name, *label;
};
constexpr FaceFieldNames names_of_fields[] = {{"contact_pressure", "contact pressure"},
                                              {"damage", "damage of bonds"},
                                              {"mu", "coefficient of friction"},
                                              {"slip", "slip since touch"},
                                              {"worn", "depth of wear"}};

template <int D>
double point_value(const contact::Formulation<D>& formulation, const contact::History<D>& history, FaceField field,
                   std::size_t i) {
  switch (field) {
  case FaceField::pressure:
    return history.results[i].pressure;
  case FaceField::damage:
    return formulation.bonds()->damage(history, i);
  case FaceField::mu:
    return history.results[i].mu;
  case FaceField::slip:
    return history.points[i].slipped;
  default:
    return history.points[i].worn;
  }
}

/// Values at the points of the full rule from those of the sparse one: T_ij, the Lagrange polynomial of point j at i.
MatrixX interpolation(int sparse, int full) {
  const std::vector<double> a = solid::gauss_legendre(sparse, 0, 1).points,
                            b = solid::gauss_legendre(full, 0, 1).points;
  const Eigen::Map<const VectorX> from(a.data(), sparse), to(b.data(), full);
  MatrixX result = MatrixX::Ones(full, sparse);
  for (int j = 0; j < sparse; ++j)
    for (int k = 0; k < sparse; ++k)
      if (k != j) result.col(j).array() *= (to.array() - from(k)) / (from(j) - from(k));
  return result;
}

} // namespace

std::optional<FaceField> face_field(const std::string& name) {
  for (const FaceField field : face_fields)
    if (name == name_of(field)) return field;
  return {};
}

const char* name_of(FaceField field) {
  return names_of_fields[static_cast<int>(field)].name;
}

const char* label_of(FaceField field) {
  return names_of_fields[static_cast<int>(field)].label;
}

template <int D> MatrixX contact_point_values(const Model<D>& model, FaceField field, int contact, std::size_t face) {
  const contact::Formulation<D>& formulation = *model.system.contacts[contact];
  const Contact<D>& named = model.system.scene.contacts[contact];
  const int points = named.points;
  const contact::History<D>& history = model.present.contacts[contact];
  MatrixX all = MatrixX::Zero(D == 3 ? points * points : points, formulation.slave().elements());
  for (std::size_t i = 0; i < formulation.points().size(); ++i) {
    if (!acts(formulation.points(), history, i)) continue;
    const contact::ContactPoint& point = formulation.points().list[i];
    all(point.number, point.element) = point_value(formulation, history, field, i);
  }
  if (const int sparse = formulation.points().sparse; sparse > 0) {
    const MatrixX along = interpolation(sparse, points);
    for (int e = 0; e < std::ssize(history.sparse); ++e) {
      if (!history.sparse[e]) continue;
      if constexpr (D == 2)
        all.col(e) = (along * all.col(e).head(sparse)).eval();
      else
        all.col(e) = (along * all.col(e).head(sparse * sparse).reshaped(sparse, sparse) * along.transpose()).reshaped();
    }
  }
  const contact::Surface<D>& slave = formulation.slave();
  if (slave.sheets() > 1) {
    const int first = slave.first_element(static_cast<int>(face));
    return all.middleCols(first, slave.first_element(static_cast<int>(face) + 1) - first);
  }
  if (named.slave.size() == 1) return all;
  const contact::FacePlace& place = slave.places()[face];
  MatrixX result(all.rows(), place.elements[0] * place.elements[1]);
  for (int f = 0; f < result.cols(); ++f)
    for (int k = 0; k < result.rows(); ++k) result(k, f) = all(place.point(k, points), place.element(f));
  return result;
}

template <int D>
FaceValues<D>::FaceValues(const Model<D>& model, FaceField field, int contact, std::size_t face)
    : side_(model.system.scene.contacts[contact].slave[face].side),
      points_(model.system.scene.contacts[contact].points), places_(solid::gauss_legendre(points_, 0, 1).points),
      values_(contact_point_values(model, field, contact, face)) {}

template <int D> double FaceValues<D>::at_place(int e, const contact::FaceCoordinates<D>& fraction) const {
  double sum = 0;
  std::array<int, D - 1> first;
  std::array<double, D - 1> weight; // of the point after the first
  for (std::size_t d = 0; d < D - 1; ++d) {
    const double place = fraction(static_cast<int>(d));
    int i = 0;
    while (i + 2 < points_ && places_[i + 1] < place) ++i;
    const double gap = places_[std::min(i + 1, points_ - 1)] - places_[i];
    first[d] = i;
    weight[d] = gap > 0 ? std::clamp((place - places_[i]) / gap, 0.0, 1.0) : 0.0;
  }
  for (int corner = 0; corner < 1 << (D - 1); ++corner) {
    double share = 1;
    int number = 0, stride = 1;
    for (std::size_t d = 0; d < D - 1; ++d, stride *= points_) {
      const bool behind = corner >> d & 1;
      share *= behind ? weight[d] : 1 - weight[d];
      number += stride * std::min(first[d] + behind, points_ - 1);
    }
    sum += share * values_(number, e);
  }
  return sum;
}

namespace {

/// The parameter of a side.
double end_of(const nurbs::Discretization& space, nurbs::Side side) {
  return side.at_end ? space.interval(space.elements() - 1, side.direction)[1] : space.interval(0, side.direction)[0];
}

/// Throws the Error that lists the faces of a body with the field.
template <int D> [[noreturn]] void throw_without(const Model<D>& model, FaceField field, int body) {
  std::vector<Message> places;
  for (const auto& contact : model.system.scene.contacts)
    for (const auto& [on, side] : contact.slave) {
      if (on != body || !has(contact, field)) continue;
      const double end = end_of(model.system.scene.bodies[body].body->space(), side);
      places.push_back(
          Message("model.field.face_place", {{"direction", side.direction}, {"xi", end}, {"contact", contact.name}}));
    }
  if (places.empty()) fail("model.field.face_nowhere", {{"field", name_of(field)}});
  fail("model.field.face_known", {{"field", name_of(field)}, {"places", places}});
}

} // namespace

template <int D> double sample_face(const Model<D>& model, FaceField field, int body, const VectorX& xi) {
  const nurbs::Discretization& space = model.system.scene.bodies[body].body->space();
  const int e = space.find_element(xi); // throws Error outside
  double sum = 0;
  bool found = false;
  for (std::size_t c = 0; c < model.system.scene.contacts.size(); ++c) {
    if (!has(model.system.scene.contacts[c], field)) continue;
    const Faces& faces = model.system.scene.contacts[c].slave;
    for (std::size_t k = 0; k < faces.size(); ++k) {
      const int across = faces[k].side.direction;
      const double end = end_of(space, faces[k].side);
      if (faces[k].body != body || std::abs(xi(across) - end) > 1e-12 * std::max(1.0, std::abs(end))) continue;
      found = true;
      contact::FaceCoordinates<D> fraction;
      int on_face = 0;
      for (int d = 0, i = 0, stride = 1; d < D; ++d) {
        if (d == across) continue;
        const auto [from, to] = space.interval(e, d);
        fraction(i++) = (xi(d) - from) / (to - from);
        on_face += stride * space.element_index(e, d);
        stride *= space.elements(d);
      }
      sum += FaceValues<D>(model, field, static_cast<int>(c), k).at_place(on_face, fraction);
      break; // at a corner the first of the contact's faces
    }
  }
  if (!found) throw_without(model, field, body);
  return sum;
}

template MatrixX contact_point_values(const Model<2>&, FaceField, int, std::size_t);
template MatrixX contact_point_values(const Model<3>&, FaceField, int, std::size_t);
template class FaceValues<2>;
template class FaceValues<3>;
template double sample_face<2>(const Model<2>&, FaceField, int, const VectorX&);
template double sample_face<3>(const Model<3>&, FaceField, int, const VectorX&);

} // namespace signorini::model
