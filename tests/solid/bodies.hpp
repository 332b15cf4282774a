#pragma once
// Bodies for tests, and a slow dense assembly and solution.

#include "base/dense.hpp"
#include "nurbs/plan.hpp"
#include "nurbs/random_patch.hpp"
#include "nurbs/shapes.hpp"
#include "solid/internal.hpp"
#include "solid/linear_elastic.hpp"
#include "solid/neo_hookean.hpp"

#include <limits>
#include <map>

namespace signorini::solid::test {

using nurbs::test::Random;
using nurbs::test::uniform;

/// A body with one contact face; the label applies along it.
template <int D>
Body<D> make_body(const nurbs::Patch& patch, std::vector<int> elements, const std::string& label,
                  const std::string& contact, const Material& material, std::optional<int> thickness_degree = 1) {
  return {nurbs::Discretization(patch, nurbs::test::plan_of(std::move(elements), contact, label, thickness_degree)),
          material};
}

template <int D> VectorX random_displacement(Random& random, const Body<D>& body, double size) {
  VectorX u(D * body.functions());
  for (int i = 0; i < u.size(); ++i) u(i) = uniform(random, -size, size);
  return u;
}

/// Displacements x ↦ F x + shift of the control points.
template <int D> VectorX affine(const Body<D>& body, const Mat<D>& f, const Vec<D>& shift = Vec<D>::Zero()) {
  const MatrixX points = body.space().points();
  VectorX u(points.size());
  for (int a = 0; a < points.cols(); ++a)
    u.segment<D>(D * a) = f * Vec<D>(points.col(a)) + shift - Vec<D>(points.col(a));
  return u;
}

struct Assembled {
  VectorX force;
  MatrixX tangent;
  std::optional<Inversion> inversion;
};

/// `memory` and `before` as for internal_force().
template <int D>
Assembled assemble(const Body<D>& body, const VectorX& u, const Memory& memory = {}, const double* before = nullptr) {
  Assembled sum{VectorX::Zero(u.size()), MatrixX::Zero(u.size(), u.size()), {}};
  ElementArrays<D> arrays(body);
  for (int e = 0; e < body.macro_elements(); ++e) {
    if ((sum.inversion = internal_force(body, e, u.data(), arrays, true, memory, before))) return sum;
    const auto functions = body.functions_of_macro(e);
    const int n = std::ssize(functions);
    const auto dof = [&](int a, int i) { return D * functions[a] + i; };
    const double* block = arrays.blocks.data();
    for (int i = 0; i < D; ++i) {
      for (int a = 0; a < n; ++a) sum.force(dof(a, i)) += arrays.force[i * n + a];
      for (int j = i; j < D; ++j, block += n * n)
        for (int a = 0; a < n; ++a)
          for (int b = 0; b < n; ++b) {
            sum.tangent(dof(a, i), dof(b, j)) += block[a * n + b];
            if (i != j) sum.tangent(dof(b, j), dof(a, i)) += block[a * n + b];
          }
    }
  }
  return sum;
}

/// ∫ W dV of a step, whose derivative is the force.
template <int D> double step_energy(const Body<D>& body, const double* displacement, const Memory& memory) {
  const std::size_t variables = body.internal_variables();
  double sum = 0;
  const bool valid = visit_points(body, displacement, memory, [&](std::size_t point, double weight, const Mat<3>& f) {
    const auto committed = memory.committed.subspan(point * variables, variables);
    sum += weight * body.material().energy(f, {committed, {}, memory.duration});
  });
  return valid ? sum : std::numeric_limits<double>::infinity();
}
template <int D> double stored_energy(const Body<D>& body, const double* displacement) {
  return account(body, displacement).stored;
}

/// Prescribes component c of all control points of a face as `value`(X).
template <int D, class Value>
void prescribe(const Body<D>& body, const std::string& face, int component, Value value, std::map<int, double>& dofs) {
  const MatrixX points = body.space().points();
  for (int function : body.space().face_functions(nurbs::side_of(face, D)))
    dofs[D * function + component] = value(Vec<D>(points.col(function)));
}

/// Newton's method from zero displacement with dense algebra under dead nodal forces (empty: none); reactions are the
/// force at the end minus the load.
template <int D>
Assembled equilibrate(const Body<D>& body, const std::map<int, double>& prescribed, int iterations, VectorX& u,
                      const VectorX& load = {}) {
  u = VectorX::Zero(D * body.functions());
  std::vector<int> free;
  for (int i = 0; i < u.size(); ++i)
    if (!prescribed.count(i)) free.push_back(i);
  VectorX increment = VectorX::Zero(u.size());
  for (const auto& [dof, value] : prescribed) increment(dof) = value;
  for (int k = 0; k < iterations; ++k) {
    const Assembled now = assemble(body, u);
    VectorX right = -(now.force + now.tangent * increment);
    if (load.size() > 0) right += load;
    increment(free) += dense::solve(now.tangent(free, free), right(free));
    u += increment;
    increment.setZero();
  }
  return assemble(body, u);
}

} // namespace signorini::solid::test
