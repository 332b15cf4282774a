#include "model/stability/mass_matrix.hpp"

#include "solid/mass.hpp"

namespace signorini::model {

template <int D>
std::vector<double> mass_matrix(const Scene<D>& scene, const Unknowns<D>& unknowns, const solve::Pattern& pattern) {
  std::vector<double> values(static_cast<std::size_t>(pattern.entries()), 0.0);
  for (int b = 0; b < std::ssize(scene.bodies); ++b) {
    const solid::Body<D>& body = *scene.bodies[b].body;
    for (int e = 0; e < body.elements(); ++e) {
      const MatrixX mass = element_mass(body, e);
      const auto functions = body.tables().functions_of(e);
      for (int c = 0; c < D; ++c) {
        const auto unknown = [&](int a) { return unknowns.unknown(unknowns.offset(b) + D * functions[a] + c); };
        for (int a = 0; a < mass.rows(); ++a)
          for (int other = 0; other < mass.cols(); ++other)
            if (unknown(a) >= 0 && unknown(other) >= 0)
              values[pattern.find(unknown(a), unknown(other))] += mass(a, other);
      }
    }
  }
  return values;
}

template std::vector<double> mass_matrix(const Scene<2>&, const Unknowns<2>&, const solve::Pattern&);
template std::vector<double> mass_matrix(const Scene<3>&, const Unknowns<3>&, const solve::Pattern&);

} // namespace signorini::model
