#include "contact/point/contact_points.hpp"

#include "base/error.hpp"
#include "contact/constants.hpp"
#include "contact/point/local.hpp"
#include "solid/quadrature.hpp"

namespace signorini::contact {

template <int D>
ContactPoints<D>::ContactPoints(const Surface<D>& slave, int per_direction, bool is_revolved, const Region<D>& where,
                                int few)
    : revolved(is_revolved), full(per_direction), sparse(few) {
  FacePoint<D> face;
  LocalGeometry<D> geometry;
  LocalRow<D> derivative;
  geometry.revolved = revolved;
  const auto add = [&](int e, int count, bool of_sparse) {
    std::vector<solid::QuadratureRule> rules;
    for (int a = 0; a < D - 1; ++a) {
      const auto [from, to] = slave.interval(e, a);
      rules.push_back(solid::gauss_legendre(count, from, to));
    }
    const solid::ElementQuadrature rule = solid::tensor_product(rules);
    for (int q = 0; q < rule.weights.size(); ++q) {
      slave.locate(e, rule.points.col(q), 1, face);
      if (where && !where(face.position)) {
        whole = false;
        continue;
      }
      slave.functions(face, 1);
      geometry.slave = face.position;
      geometry.slave_tangent = face.tangent;
      list.push_back({e, q, rule.weights(q), slave_measure(geometry, derivative), values.size(), of_sparse});
      reference.push_back(face.position);
      const int n = slave.functions_on(e);
      values.insert(values.end(), face.value.begin(), face.value.begin() + n);
      for (const auto& rates : face.derivative) values.insert(values.end(), rates.begin(), rates.begin() + n);
    }
  };
  for (int e = 0; e < slave.elements(); ++e) {
    starts.push_back(list.size());
    add(e, full, false);
    if (sparse > 0) add(e, sparse, true);
  }
  starts.push_back(list.size());
  require(!list.empty(), "contact.points.none");
}

namespace {

/// Σ_A R_A x_A at point i (k = 0), or with R_A,k in place of R_A.
template <int D> inline Vec<D> sum_at(const ContactPoints<D>& points, const Surface<D>& slave, std::size_t i, int k) {
  const int element = points.list[i].element, n = slave.functions_on(element);
  const int* nodes = slave.nodes(element);
  const double *values = points.functions(i) + k * n, *x = slave.points().data();
  std::array<double, D> sum{};
  for (int a = 0; a < n; ++a)
    for (int d = 0; d < D; ++d) sum[d] += values[a] * x[D * nodes[a] + d];
  return Eigen::Map<const Vec<D>>(sum.data());
}

} // namespace

template <int D> Vec<D> position(const ContactPoints<D>& points, const Surface<D>& slave, std::size_t i) {
  return sum_at(points, slave, i, 0);
}

template <int D>
std::array<Vec<D>, D - 1> tangents(const ContactPoints<D>& points, const Surface<D>& slave, std::size_t i) {
  std::array<Vec<D>, D - 1> result;
  for (int k = 0; k < D - 1; ++k) result[k] = sum_at(points, slave, i, k + 1);
  return result;
}

template <int D> Vec<D> normal_at(const ContactPoints<D>& points, const Surface<D>& slave, std::size_t i) {
  return (slave.sheet_data(slave.sheet(points.list[i].element)).orientation * normal_of<D>(tangents(points, slave, i)))
      .normalized();
}

template <int D> void make_set(ContactPoints<D>& points, const Surface<D>& faces, double share) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    points.list[i].weight *= share;
    points.outward.push_back(normal_at(points, faces, i));
  }
}

template <int D> void set_axes(ContactPoints<D>& points, const Surface<D>& slave, const Vec<D>& direction) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::array<Vec<D>, D - 1> tangent = tangents(points, slave, i);
    Eigen::Matrix<double, D, D - 1> basis;
    for (int a = 0; a < D - 1; ++a) basis.col(a) = tangent[a];
    // a^α = m^{αβ} xˢ_,β·a
    const FaceCoordinates<D> axis = (basis.transpose() * basis).inverse() * (basis.transpose() * direction);
    require(direction_of<D>(axis, tangent).norm() > least_axis * direction.norm(), "contact.friction.normal_axis",
            {{"place", points.reference[i]}});
    points.axes.push_back(axis);
  }
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template struct ContactPoints<D>;                                                                                    \
  template Vec<D> position(const ContactPoints<D>&, const Surface<D>&, std::size_t);                                   \
  template std::array<Vec<D>, D - 1> tangents(const ContactPoints<D>&, const Surface<D>&, std::size_t);                \
  template Vec<D> normal_at(const ContactPoints<D>&, const Surface<D>&, std::size_t);                                  \
  template void make_set(ContactPoints<D>&, const Surface<D>&, double);                                                \
  template void set_axes(ContactPoints<D>&, const Surface<D>&, const Vec<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
