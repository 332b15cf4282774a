#include "solid/viscoelastic.hpp"

#include "base/error.hpp"
#include "solid/volume_change.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::solid {

namespace {

/// Components of a symmetric tensor in a body of D dimensions: 11, 22, 33, 12 and in space 13, 23.
template <int D> constexpr int components = D == 2 ? 4 : 6;
constexpr int rows[] = {0, 1, 2, 0, 0, 1}, columns[] = {0, 1, 2, 1, 2, 2};

template <int D> Mat<3> tensor(const double* values) {
  Mat<3> all = Mat<3>::Zero();
  for (int c = 0; c < components<D>; ++c) all(rows[c], columns[c]) = all(columns[c], rows[c]) = values[c];
  return all;
}
template <int D> void put(const Mat<3>& tensor, double* values) {
  for (int c = 0; c < components<D>; ++c) values[c] = 0.5 * (tensor(rows[c], columns[c]) + tensor(columns[c], rows[c]));
}

/// The internal variables of a point: C̄ and Z of the last state, H_i of each term, and the viscous work w per volume.
template <int D, class Double> struct Variables {
  Double *strain, *stress, *overstress, *work;
  Variables(Double* values, std::size_t terms)
      : strain(values), stress(strain + components<D>), overstress(stress + components<D>),
        work(overstress + components<D> * terms) {}
};

std::size_t count(int dimensions, std::size_t terms) {
  return (dimensions == 2 ? components<2> : components<3>)*(terms + 2) + 1;
}

/// e = exp(−Δt/τ) and a = (1 − e) τ/Δt; 1 and 1 for Δt = 0, 0 and 0 for Δt = ∞.
struct Decay {
  double kept, mean;
};
Decay decay(double duration, double time) {
  const double ratio = duration / time;
  if (ratio == 0) return {1, 1};
  if (std::isinf(ratio)) return {0, 0};
  return {std::exp(-ratio), -std::expm1(-ratio) / ratio};
}

/// b = Σ g_i (1 − a_i)
double relaxed_fraction(const Viscoelastic& law, double duration) {
  double sum = 0;
  for (const auto& [fraction, time] : law.series) sum += fraction * (1 - decay(duration, time).mean);
  return sum;
}

/// K = Σ (e_i H_i⁰ − g_i a_i Z⁰)
template <int D> Mat<3> kept_stress(const Viscoelastic& law, const double* committed, double duration) {
  const Variables<D, const double> before(committed, law.series.size());
  std::array<double, components<D>> sum{};
  const double* h = before.overstress;
  for (const auto& [fraction, time] : law.series) {
    const auto [kept, mean] = decay(duration, time);
    for (double& value : sum) value += kept * *h++;
    for (int c = 0; c < components<D>; ++c) sum[c] -= fraction * mean * before.stress[c];
  }
  return tensor<D>(sum.data());
}

/// F̄: F, or without its change of volume.
Mat<3> relaxing(const Viscoelastic& law, const Mat<3>& f) {
  if (law.relaxes == Relaxes::all) return f;
  if (law.small_strains()) return f - (f.trace() - 3) / 3 * Mat<3>::Identity();
  return std::pow(f.determinant(), -1.0 / 3) * f;
}

/// C̄ of F̄; with small strains I + 2ε, whose changes do the same work.
Mat<3> strain_of(const Viscoelastic& law, const Mat<3>& f) {
  return law.small_strains() ? Mat<3>(f + f.transpose() - Mat<3>::Identity()) : Mat<3>(f.transpose() * f);
}

/// Z = 2 ∂V/∂C̄ of P̄ = ∂V/∂F̄; with small strains the stress.
Mat<3> second_stress(const Viscoelastic& law, const Mat<3>& f, const Mat<3>& p) {
  return law.small_strains() ? p : Mat<3>(f.inverse() * p);
}

/// H_i = e_i H_i⁰ + g_i a_i (Z − Z⁰) and w = w⁰ + ½ (H⁰ + H):½ (C̄ − C̄⁰) with H = Σ H_i [theory 2.12].
template <int D>
void write_trial(const Viscoelastic& law, const Mat<3>& c, const Mat<3>& z, const double* committed, double* trial,
                 double duration) {
  const Variables<D, const double> before(committed, law.series.size());
  const Variables<D, double> after(trial, law.series.size());
  put<D>(c, after.strain);
  put<D>(z, after.stress);
  std::array<double, components<D>> sum{}; // H⁰ + H
  const double* h0 = before.overstress;
  double* h = after.overstress;
  for (const auto& [fraction, time] : law.series) {
    const auto [kept, mean] = decay(duration, time);
    for (int k = 0; k < components<D>; ++k, ++h, ++h0) {
      *h = kept * *h0 + fraction * mean * (after.stress[k] - before.stress[k]);
      sum[k] += *h0 + *h;
    }
  }
  double work = 0;
  for (int k = 0; k < components<D>; ++k)
    work += (rows[k] == columns[k] ? 1 : 2) * sum[k] * (after.strain[k] - before.strain[k]) / 4;
  *after.work = *before.work + work;
}

template <int D> Entries<D> entries_of(const Mat<3>& tensor) {
  Entries<D> all;
  for (int e = 0; e < entries_in(D); ++e) all(e) = tensor(component<D>(e) / 3, component<D>(e) % 3);
  return all;
}

/// Turns P̄ and A of V into those of −b V + ½ K:C̄: −b P̄ + F̄ K and −b A + δ_ij K_kl; with small strains −b P̄ + K, −b A.
template <int D>
void add_memory(bool small_strains, double factor, const Mat<3>& f, const Mat<3>& kept, Entries<D>& p, double* moduli,
                int stride) {
  constexpr int entries = entries_in(D);
  p = factor * p + entries_of<D>(small_strains ? kept : Mat<3>(f * kept));
  for (int e = 0; moduli && e < entries; ++e)
    for (int o = e; o < entries; ++o) {
      const int ik = component<D>(e), jl = component<D>(o);
      double& modulus = moduli[packed(entries, e, o) * stride];
      modulus *= factor;
      if (!small_strains && ik / 3 == jl / 3) modulus += kept(ik % 3, jl % 3);
    }
}

/// Values at the points of a block, reused by all blocks of a thread.
template <int D> PointBlock scratch_block(const PointBlock& like) {
  constexpr int entries = entries_in(D), values = 2 * entries + packed_size(entries);
  thread_local std::vector<double> all;
  const auto stride = static_cast<std::size_t>(like.stride);
  if (all.size() < values * stride) all.resize(values * stride);
  double* const stress = all.data() + entries * stride;
  return {like.points, like.stride, all.data(), stress, like.moduli ? stress + entries * stride : nullptr};
}

int dimensions_of(const Viscoelastic& law, const Memory& memory) {
  return memory.committed.size() == count(2, law.series.size()) ? 2 : 3;
}

} // namespace

std::vector<double> Viscoelastic::initial_values(int dimensions) const {
  std::vector<double> values(count(dimensions, series.size()), 0.0);
  std::fill_n(values.begin(), 3, 1.0); // C̄ = I
  return values;
}

// W_step = W − b V + ½ K:C̄
double Viscoelastic::energy(const Mat<3>& f, const Memory& memory) const {
  const Mat<3> bar = relaxing(*this, f);
  const Mat<3> kept = dimensions_of(*this, memory) == 2
                          ? kept_stress<2>(*this, memory.committed.data(), memory.duration)
                          : kept_stress<3>(*this, memory.committed.data(), memory.duration);
  return elastic.energy(f) - relaxed_fraction(*this, memory.duration) * elastic.energy(bar) +
         0.5 * kept.cwiseProduct(strain_of(*this, bar)).sum();
}

Mat<3> Viscoelastic::stress(const Mat<3>& f, const Memory& memory) const {
  if (dimensions_of(*this, memory) == 2) return PointResponse<2>(respond<2>, this, f, memory, false).stress();
  return PointResponse<3>(respond<3>, this, f, memory, false).stress();
}

Moduli Viscoelastic::moduli(const Mat<3>& f, const Memory& memory) const {
  if (dimensions_of(*this, memory) == 2) return PointResponse<2>(respond<2>, this, f, memory, true).moduli();
  return PointResponse<3>(respond<3>, this, f, memory, true).moduli();
}

Account Viscoelastic::account(const Mat<3>& f, std::span<const double> values) const {
  double sum = 0;
  for (const auto& [fraction, time] : series) sum += fraction;
  return {elastic.energy(f) - sum * elastic.energy(relaxing(*this, f)), values.back()};
}

template <int D> void Viscoelastic::respond(const void* given, const PointBlock& block) {
  const Viscoelastic& law = *static_cast<const Viscoelastic*>(given);
  const Respond of_elastic = law.elastic.respond<D>();
  const auto& [committed, trial, variables, duration] = block.memory;
  const bool small = law.small_strains(), shape = law.relaxes == Relaxes::shape;
  const double relaxed = relaxed_fraction(law, duration);
  of_elastic(law.elastic.law(), {block.points, block.stride, block.f, block.stress, block.moduli});
  PointBlock bar = block; // that of V at F̄
  if (shape) {
    bar = scratch_block<D>(block);
    for (int q = 0; q < block.stride; ++q) {
      const Entries<D> f = entries_of<D>(relaxing(law, deformation_at<D>(block, q)));
      for (int e = 0; e < entries_in(D); ++e) bar.f[e * bar.stride + q] = f(e);
    }
    of_elastic(law.elastic.law(), bar);
  }
  for (int q = 0; q < block.points; ++q) {
    const Mat<3> f = deformation_at<D>(bar, q);
    Entries<D> p;
    for (int e = 0; e < entries_in(D); ++e) p(e) = bar.stress[e * bar.stride + q];
    if (trial) {
      Mat<3> full = Mat<3>::Zero();
      for (int e = 0; e < entries_in(D); ++e) full(component<D>(e) / 3, component<D>(e) % 3) = p(e);
      write_trial<D>(law, strain_of(law, f), second_stress(law, f, full), committed + q * variables,
                     trial + q * variables, duration);
    }
    const Mat<3> kept = kept_stress<D>(law, committed + q * variables, duration);
    double* const moduli = bar.moduli ? bar.moduli + q : nullptr;
    add_memory<D>(small, shape ? -relaxed : 1 - relaxed, f, kept, p, moduli, bar.stride);
    if (shape) {
      const Mat<3> whole = deformation_at<D>(block, q), inverse = small ? whole : Mat<3>(whole.inverse().transpose());
      const Entries<D> own = small ? entries_of<D>(Mat<3>::Identity()) : entries_of<D>(f);
      const double mean = own.dot(p) / 3;
      const VolumeChange<D> change{small, small ? 1 : std::pow(whole.determinant(), -1.0 / 3),
                                   mean,  -mean,
                                   own,   small ? own : entries_of<D>(inverse)};
      change_volume(change, p, moduli, bar.stride);
    }
    for (int e = 0; e < entries_in(D); ++e) {
      double& stress = block.stress[e * block.stride + q];
      stress = shape ? stress + p(e) : p(e);
    }
    if (!shape || !moduli) continue;
    for (int e = 0; e < packed_size(entries_in(D)); ++e) block.moduli[e * block.stride + q] += moduli[e * bar.stride];
  }
}

Viscoelastic viscoelastic(Material elastic, std::vector<Relaxation> series, Relaxes relaxes) {
  require(elastic.initial_values(3).empty(), "solid.viscoelastic.law", {{"material", elastic.name()}});
  require(!series.empty(), "solid.viscoelastic.empty");
  double sum = 0;
  for (const auto& [fraction, time] : series) {
    require(fraction > 0, "solid.viscoelastic.fraction", {{"value", fraction}});
    require(time > 0 && std::isfinite(time), "solid.viscoelastic.time", {{"value", time}});
    sum += fraction;
  }
  require(sum < 1, "solid.viscoelastic.sum", {{"sum", sum}});
  const ElasticConstants constants = elastic.constants();
  return {constants, std::move(elastic), relaxes, std::move(series)};
}

const Viscoelastic* viscoelastic_law(const Material& material) {
  return material.name() == Viscoelastic::name ? static_cast<const Viscoelastic*>(material.law()) : nullptr;
}

double step_error(const Viscoelastic& law, const Memory& memory) {
  const std::size_t size = dimensions_of(law, memory) == 2 ? components<2> : components<3>;
  const Eigen::Map<const VectorX> before(memory.committed.data() + size, static_cast<Eigen::Index>(size)),
      after(memory.trial.data() + size, static_cast<Eigen::Index>(size));
  const double scale = after.norm(), change = (after - before).norm();
  if (!(scale > 0)) return 0;
  double largest = 0;
  for (const auto& [fraction, time] : law.series) {
    const double euler = 1 / (1 + memory.duration / time);
    largest = std::max(largest, fraction * std::abs(decay(memory.duration, time).mean - euler));
  }
  return largest * change / scale;
}

template void Viscoelastic::respond<2>(const void*, const PointBlock&);
template void Viscoelastic::respond<3>(const void*, const PointBlock&);
template Material::Material(Viscoelastic);

} // namespace signorini::solid
