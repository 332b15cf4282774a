#include "solid/energy.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>

namespace signorini::solid {

namespace {

/// F = Σ_i λ_i n_i ⊗ N_i.
struct Principal {
  Principal() = default;
  explicit Principal(const Mat<3>& f) {
    const Eigen::SelfAdjointEigenSolver<Mat<3>> solver(f.transpose() * f);
    stretches = solver.eigenvalues().cwiseSqrt();
    reference = solver.eigenvectors();
    current = f * reference * stretches.cwiseInverse().asDiagonal();
  }
  Vec<3> stretches;
  Mat<3> reference, current; ///< N_i and n_i in columns
};

/// First and second derivatives of the energy by the stretches.
struct Slopes {
  Vec<3> first;
  Mat<3> second;
};

/// The entries of n_i ⊗ N_j in column 3i + j.
template <int D> auto dyads(const Principal& at) {
  Eigen::Matrix<double, entries_in(D), 9> all;
  for (int e = 0; e < entries_in(D); ++e) {
    const int entry = component<D>(e);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) all(e, 3 * i + j) = at.current(entry / 3, i) * at.reference(entry % 3, j);
  }
  return all;
}

/// The moduli in the basis of dyads().
// ∂P/∂F = Σ_ij W_ij (n_i ⊗ N_i)(n_j ⊗ N_j) + Σ_i≠j g_ij (n_i ⊗ N_j)(n_i ⊗ N_j) + h_ij (n_i ⊗ N_j)(n_j ⊗ N_i), where
// g_ij + h_ij = (W_i − W_j)/(λ_i − λ_j) and g_ij − h_ij = (W_i + W_j)/(λ_i + λ_j) [theory 2.4]. For almost equal
// stretches the first is (W_ii + W_jj)/2 − W_ij up to the square of their difference.
Moduli principal_moduli(const Vec<3>& stretches, const Slopes& w) {
  constexpr double equal = 1e-5;
  Moduli sum = Moduli::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      sum(4 * i, 4 * j) = w.second(i, j);
      if (i == j) continue;
      const double a = stretches(i), b = stretches(j);
      const double symmetric = std::abs(a - b) > equal * (a + b)
                                   ? (w.first(i) - w.first(j)) / (a - b)
                                   : (w.second(i, i) + w.second(j, j)) / 2 - w.second(i, j);
      const double skew = (w.first(i) + w.first(j)) / (a + b);
      sum(3 * i + j, 3 * i + j) = 0.5 * (symmetric + skew);
      sum(3 * i + j, 3 * j + i) = 0.5 * (symmetric - skew);
    }
  return sum;
}

constexpr int points_at_once = 32;

} // namespace

std::vector<double> stretches_of(const Mat<3>& f) {
  const Vec<3> stretches = Principal(f).stretches;
  return {stretches(0), stretches(1), stretches(2)};
}

template <int D> void respond_by_stretches(const Energy& energy, const PointBlock& block) {
  constexpr int entries = entries_in(D);
  const symbolic::Tape& tape = energy.derivatives;
  std::vector<double> registers(tape.registers * points_at_once);
  std::array<Principal, points_at_once> principal;
  for (int begin = 0; begin < block.points; begin += points_at_once) {
    const int points = std::min(points_at_once, block.points - begin);
    for (int q = 0; q < points; ++q) {
      principal[q] = Principal(deformation_at<D>(block, begin + q));
      for (int i = 0; i < 3; ++i) registers[i * points_at_once + q] = principal[q].stretches(i);
    }
    constexpr int first_derivatives = 3, all_derivatives = 9;
    symbolic::evaluate(tape, registers.data(), points_at_once, points,
                       block.moduli ? all_derivatives : first_derivatives);
    for (int q = 0; q < points; ++q) {
      const auto value = [&](std::size_t output) {
        const int place = tape.outputs[output];
        return place < 0 ? 0 : registers[place * points_at_once + q];
      };
      Slopes w;
      std::size_t next = 0;
      for (int i = 0; i < 3; ++i) w.first(i) = value(next++);
      const Principal& here = principal[q];
      const auto all = dyads<D>(here);
      // P = Σ_i W_i n_i ⊗ N_i
      const Eigen::Matrix<double, entries, 1> stress =
          all.col(0) * w.first(0) + all.col(4) * w.first(1) + all.col(8) * w.first(2);
      for (int e = 0; e < entries; ++e) block.stress[e * block.stride + begin + q] = stress(e);
      if (!block.moduli) continue;
      for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) w.second(i, j) = w.second(j, i) = value(next++);
      const Eigen::Matrix<double, entries, entries> moduli =
          all * principal_moduli(here.stretches, w) * all.transpose();
      for (int e = 0; e < entries; ++e)
        for (int o = e; o < entries; ++o) block.moduli[packed(entries, e, o) * block.stride + begin + q] = moduli(e, o);
    }
  }
}

template void respond_by_stretches<2>(const Energy&, const PointBlock&);
template void respond_by_stretches<3>(const Energy&, const PointBlock&);

} // namespace signorini::solid
