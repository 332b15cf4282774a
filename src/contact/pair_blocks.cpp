// The blocks that contact points add to: residual and tangent by slave, master and slip-point element.
#include "contact/pair.hpp"

#include <algorithm>

namespace signorini::contact {

/// Index of the group in the part; a new one where there is none.
template <int D>
std::size_t Pair<D>::group(int slave_element, int master_element, int slip_element, bool tangent, Part& part) {
  // Points come element by element, so a group to add to is among the last ones.
  std::vector<Group>& groups = part.groups;
  std::size_t own = 0; // groups of this slave element
  for (; own < groups.size() && groups[groups.size() - 1 - own].slave_element == slave_element; ++own) {
    const std::size_t index = groups.size() - 1 - own;
    if (groups[index].master_element == master_element && groups[index].slip_element == slip_element) return index;
  }
  if (part.spare.empty()) {
    groups.emplace_back();
  } else {
    groups.push_back(std::move(part.spare.back()));
    part.spare.pop_back();
  }
  Group& result = groups.back();
  const int ns = slave_.functions_on(slave_element), nm = master_.functions_on(master_element);
  result.slave_element = slave_element;
  result.master_element = master_element;
  result.slip_element = slip_element;
  result.rows = D * (ns + nm);
  result.columns = D * (ns + nm + (slip_element >= 0 ? master_.functions_on(slip_element) : 0));
  result.force.assign(static_cast<std::size_t>(result.rows), 0.0);
  result.matrix.assign(tangent ? static_cast<std::size_t>(result.rows * result.columns) : 0, 0.0);
  if constexpr (D == 3) {
    if (part.products.size() <= own) part.products.emplace_back();
    part.products[own].start(ns + nm, nm, result.columns, result.matrix.data());
  }
  return groups.size() - 1;
}

template <int D>
void Pair<D>::add(const Point& point, const FacePoint<D>& master, const FacePoint<D>* slip_point,
                  const LocalForce<D>& force, bool tangent, Part& part) {
  using Force = LocalForce<D>;
  const bool rigid = master_.rigid(); // one node, whatever the element
  const bool own_columns = slip_point && !rigid && slip_point->element != master.element;
  const std::size_t index =
      group(point.element, rigid ? 0 : master.element, own_columns ? slip_point->element : -1, tangent, part);
  Group& block = part.groups[index];
  const int ns = slave_.functions_on(block.slave_element), nm = master_.functions_on(block.master_element);
  const int nl = own_columns ? master_.functions_on(block.slip_element) : 0, width = block.columns;
  const double* r = values_.data() + point.values;
  const double w = point.weight;

  // f_A = −R_A T on the slave, +R̄_A(ξ̄) T on the master
  double* out = block.force.data();
  for (int a = 0; a < ns; ++a)
    for (int i = 0; i < D; ++i) *out++ -= w * r[a] * force.force(i);
  for (int a = 0; a < nm; ++a)
    for (int i = 0; i < D; ++i) *out++ += w * master.value[static_cast<std::size_t>(a)] * force.force(i);
  if (!tangent) return;

  // ∂T/∂x_B and ∂ξ̄/∂x_B of every column node B: the local derivatives times the functions that carry the variables.
  double* __restrict dt = part.rows.data();
  double* __restrict dxi = dt + D * width;
  for (int c = 0; c < D; ++c) {
    for (int b = 0; b < ns; ++b) {
      const int column = b * D + c;
      for (int i = 0; i < D; ++i) {
        double sum = force.tangent(i, c) * r[b];
        for (int k = 0; k < D - 1; ++k)
          sum += force.tangent(i, Force::slave_tangent_column + k * D + c) * r[(k + 1) * ns + b];
        dt[i * width + column] = w * sum;
      }
      for (int k = 0; k < D - 1; ++k) dxi[k * width + column] = w * force.shift(k, c) * r[b];
    }
    for (int b = 0; b < nm; ++b) {
      const int column = (ns + b) * D + c;
      const std::size_t m = static_cast<std::size_t>(b);
      for (int i = 0; i < D; ++i) {
        double sum = force.tangent(i, Force::master_column + c) * master.value[m];
        for (int k = 0; k < D - 1; ++k)
          sum +=
              force.tangent(i, Force::tangent_column + k * D + c) * master.derivative[static_cast<std::size_t>(k)][m];
        if (slip_point && !own_columns) sum += force.tangent(i, Force::slip_column + c) * slip_point->value[m];
        dt[i * width + column] = w * sum;
      }
      for (int k = 0; k < D - 1; ++k) {
        double sum = force.shift(k, Force::master_column + c) * master.value[m];
        for (int l = 0; l < D - 1; ++l)
          sum += force.shift(k, Force::tangent_column + l * D + c) * master.derivative[static_cast<std::size_t>(l)][m];
        dxi[k * width + column] = w * sum;
      }
    }
    for (int b = 0; b < nl; ++b) {
      const int column = (ns + nm + b) * D + c;
      const double value = slip_point->value[static_cast<std::size_t>(b)];
      for (int i = 0; i < D; ++i) dt[i * width + column] = w * (force.tangent(i, Force::slip_column + c) * value);
      for (int k = 0; k < D - 1; ++k) dxi[k * width + column] = 0;
    }
  }

  // ∂f_A = −R_A ∂T on the slave, R̄_A ∂T + T R̄_A,α ∂ξ̄^α on the master
  if constexpr (D == 3) {
    std::size_t first = index; // group of this slave element
    while (first > 0 && part.groups[first - 1].slave_element == point.element) --first;
    const Products::Room room = part.products[index - first].add();
    for (int a = 0; a < ns; ++a) room.left[a] = -r[a];
    std::copy_n(master.value.data(), nm, room.left + ns);
    for (std::size_t k = 0; k < 2; ++k) {
      std::copy_n(master.derivative[k].data(), nm, room.rates + k * static_cast<std::size_t>(nm));
      double* turn = room.turn + k * 3 * static_cast<std::size_t>(width);
      for (int i = 0; i < 3; ++i)
        for (int c = 0; c < width; ++c) *turn++ = force.force(i) * dxi[static_cast<int>(k) * width + c];
    }
    std::copy_n(dt, 3 * width, room.traction);
  } else {
    double* __restrict matrix = block.matrix.data();
    for (int a = 0; a < ns; ++a)
      for (int i = 0; i < D; ++i, matrix += width) {
        const double factor = r[a];
        const double* row = dt + i * width;
        for (int c = 0; c < width; ++c) matrix[c] -= factor * row[c];
      }
    for (int a = 0; a < nm; ++a) {
      const std::size_t m = static_cast<std::size_t>(a);
      for (int i = 0; i < D; ++i, matrix += width) {
        const double factor = master.value[m];
        const double* row = dt + i * width;
        double turn[D - 1];
        for (std::size_t k = 0; k < D - 1; ++k) turn[k] = master.derivative[k][m] * force.force(i);
        for (int c = 0; c < width; ++c) {
          double sum = factor * row[c];
          for (int k = 0; k < D - 1; ++k) sum += turn[k] * dxi[k * width + c];
          matrix[c] += sum;
        }
      }
    }
  }
}

template void Pair<2>::add(const Point&, const FacePoint<2>&, const FacePoint<2>*, const LocalForce<2>&, bool, Part&);
template void Pair<3>::add(const Point&, const FacePoint<3>&, const FacePoint<3>*, const LocalForce<3>&, bool, Part&);

} // namespace signorini::contact
