#include "contact/mortar/multiplier_functions.hpp"

#include "nurbs/bezier.hpp"
#include "nurbs/tensor.hpp"
#include "solid/quadrature.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace signorini::contact {

void sort_once(std::vector<int>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

namespace {

/// The functions of an element at the Gauss points, functions × points.
MatrixX values_on(const nurbs::Space1D& space, int element, int points) {
  const int degree = space.degree(element);
  const solid::QuadratureRule rule = solid::gauss_legendre(points, 0, 1);
  MatrixX bernsteins(degree + 1, points);
  for (int q = 0; q < points; ++q) nurbs::bernstein(degree, rule.points[q], 1, 0, bernsteins.col(q).data());
  return space.extraction(element) * bernsteins;
}

} // namespace

template <int D>
MultiplierFunctions<D>::MultiplierFunctions(const Surface<D>& slave, const ContactPoints<D>& points, int per_direction,
                                            MultiplierSpace kind, int joined)
    : numbers_(slave.elements()) {
  const FaceMultipliers<D> face(slave, kind, joined);
  const nurbs::Space1D& u = face.along.front();
  supports_.resize(face.count);
  largest_.assign(face.count, 0);
  std::vector<double> most(face.count, 0.0);
  std::size_t i = 0;
  for (int e = 0; e < slave.elements(); ++e) {
    nurbs::ElementFunctions functions;
    std::array<MatrixX, 2> along{MatrixX::Ones(1, per_direction), MatrixX::Ones(1, per_direction)};
    for (std::size_t d = 0; d < D - 1; ++d) {
      const int own = d == 0 ? e % u.elements() : e / u.elements();
      functions.along[d] = face.along[d].functions_on(own);
      functions.stride[d] = d == 0 ? 1 : u.functions();
      along[d] = values_on(face.along[d], own, per_direction);
    }
    std::vector<int>& numbers = numbers_[e];
    std::vector<std::size_t> place; // of each product's function among the element's
    functions.each([&](int product, const std::array<int, 3>&) {
      const int multiplier = face.number[product];
      const auto found = std::find(numbers.begin(), numbers.end(), multiplier);
      place.push_back(static_cast<std::size_t>(found - numbers.begin()));
      if (found != numbers.end()) return;
      numbers.push_back(multiplier);
      supports_[multiplier].push_back(e);
    });
    for (; i < points.size() && points.list[i].element == e; ++i) {
      const int q = points.list[i].number;
      offsets_.push_back(values_.size());
      values_.resize(values_.size() + numbers.size(), 0.0);
      double* const values = values_.data() + offsets_.back();
      const std::size_t* own = place.data();
      functions.each([&](int, const std::array<int, 3>& a) {
        values[*own++] += along[0](a[0], q % per_direction) * along[1](a[1], q / per_direction);
      });
      for (std::size_t k = 0; k < numbers.size(); ++k) {
        if (values[k] <= most[numbers[k]]) continue;
        most[numbers[k]] = values[k];
        largest_[numbers[k]] = static_cast<int>(i);
      }
    }
  }
  make_groups(slave);
}

/// Groups multipliers by the first element of their supports, in 3D by tiles of 2 × 2 elements.
template <int D> void MultiplierFunctions<D>::make_groups(const Surface<D>& slave) {
  const int tile = D - 1, width = slave.direction(0).elements(), across = (width + tile - 1) / tile;
  std::map<int, MultiplierGroup> by_tile;
  for (int a = 0; a < count(); ++a) {
    const int first = supports_[a].front();
    MultiplierGroup& group = by_tile[first % width / tile + across * (first / width / tile)];
    group.members.push_back(a);
    group.support.insert(group.support.end(), supports_[a].begin(), supports_[a].end());
  }
  for (auto& [place, group] : by_tile) {
    sort_once(group.support);
    for (const int e : group.support)
      group.nodes.insert(group.nodes.end(), slave.nodes(e), slave.nodes(e) + slave.functions_on(e));
    sort_once(group.nodes);
    groups_.push_back(std::move(group));
  }
}

template <int D> std::vector<double> MultiplierFunctions<D>::areas(const ContactPoints<D>& points) const {
  std::vector<double> sums(count(), 0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ContactPoint& own = points.list[i];
    const double* values = at_point(i);
    for (const int a : on(own.element)) sums[a] += *values++ * own.weight * own.reference_area;
  }
  return sums;
}

template <int D> double MultiplierFunctions<D>::memory() const {
  const auto bytes = [](const auto& list) { return static_cast<double>(list.capacity() * sizeof(list[0])); };
  double sum = bytes(offsets_) + bytes(values_);
  for (const auto* lists : {&numbers_, &supports_})
    for (const auto& list : *lists) sum += bytes(list);
  for (const MultiplierGroup& group : groups_) sum += bytes(group.members) + bytes(group.support) + bytes(group.nodes);
  return sum;
}

template class MultiplierFunctions<2>;
template class MultiplierFunctions<3>;

} // namespace signorini::contact
