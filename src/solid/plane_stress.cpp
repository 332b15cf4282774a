#include "solid/respond_each.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::solid {

namespace {

constexpr int across = 4; ///< the row of F₃₃
constexpr int entries = entries_in(2);

/// The search for F₃₃ of one point: P₃₃ is negative at `low` and positive at `high`.
struct Search {
  double low = 0, high = std::numeric_limits<double>::infinity();
  bool done = false;
};

/// The next F₃₃: Newton's step, limited to the bracket and to a factor of 2.
double next_stretch(Search& search, double s, double p, double slope) {
  (p > 0 ? search.high : search.low) = s;
  const double step = slope > 0 ? s - p / slope : 0;
  const double least = std::max(search.low, 0.5 * s), most = std::min(search.high, 2 * s);
  if (step > least && step < most) return step;
  const bool bracketed = search.low > 0 && std::isfinite(search.high);
  return bracketed ? 0.5 * (search.low + search.high) : p > 0 ? least : most;
}

/// ∂P_ef −= ∂P_e3 ∂P_f3/∂P_33, so that P₃₃ stays zero [theory 2.7].
void condense(const PointBlock& block) {
  for (int q = 0; q < block.points; ++q) {
    const auto modulus = [&](int e, int o) -> double& {
      return block.moduli[packed(entries, e, o) * block.stride + q];
    };
    const double stiffness = modulus(across, across);
    for (int e = 0; e < across; ++e)
      for (int o = e; o < across; ++o) modulus(e, o) -= modulus(e, across) * modulus(o, across) / stiffness;
    for (int e = 0; e <= across; ++e) modulus(e, across) = 0;
  }
}

} // namespace

void respond_in_plane_stress(Respond respond, const void* law, double poissons_ratio, const PointBlock& block) {
  constexpr int most_iterations = 60;
  constexpr double tolerance = 1e-14; // Newton's method converges quadratically
  const auto row = [&](int e) { return block.f + e * block.stride; };
  std::vector<double> moduli(block.moduli ? 0 : packed_size(entries) * block.stride);
  PointBlock inner = block;
  if (!block.moduli) inner.moduli = moduli.data();
  std::vector<Search> searches(block.points);
  // ln F₃₃ = −ν/(1 − ν) ln det F₂ at small strains
  for (int q = 0; q < block.stride; ++q) {
    const double plane = row(0)[q] * row(3)[q] - row(1)[q] * row(2)[q];
    row(across)[q] = std::pow(plane, -poissons_ratio / (1 - poissons_ratio));
  }
  for (int iteration = 0, open = block.points; open > 0; ++iteration) {
    respond(law, inner);
    for (int q = 0; q < block.points; ++q) {
      Search& search = searches[q];
      if (search.done) continue;
      double& s = row(across)[q];
      const double p = block.stress[across * block.stride + q];
      const double slope = inner.moduli[packed(entries, across, across) * block.stride + q];
      const double next = iteration < most_iterations && std::isfinite(p) ? next_stretch(search, s, p, slope) : 0;
      search.done = next == 0 || std::abs(next - s) <= tolerance * s || p == 0;
      if (search.done) --open;
      if (search.done && next > 0) continue; // the response is that at s
      s = search.done ? 0 : next;
    }
  }
  for (int q = 0; q < block.points; ++q) block.stress[across * block.stride + q] = 0;
  if (block.moduli) condense(block);
}

double thickness_stretch(Respond respond, const void* law, double poissons_ratio, const Mat<2>& f,
                         const PointMemory& memory) {
  // Whole vectors with a valid F.
  constexpr int stride = vector_padding;
  std::array<double, entries * stride> deformation, stress;
  for (int q = 0; q < stride; ++q)
    for (int e = 0; e < across; ++e) deformation[e * stride + q] = f(e / 2, e % 2);
  respond_in_plane_stress(respond, law, poissons_ratio,
                          {1, stride, deformation.data(), stress.data(), nullptr, memory});
  return deformation[across * stride];
}

} // namespace signorini::solid
