#include "model/system/stored_energy.hpp"

#include "solid/internal.hpp"

namespace signorini::model {

template <int D>
double StoredEnergy<D>::of_body(int index, const VectorX& displacement,
                                const std::vector<std::vector<double>>& internal) const {
  const solid::Body<D>& body = *scene_.bodies[index].body;
  const Eigen::Map<const VectorX> own(displacement.data() + unknowns_.offset(index), D * body.functions());
  if (stiffness_.empty()) {
    Known& known = known_[index];
    if (known.displacement.size() != own.size() || known.displacement != own || known.internal != internal[index])
      known = {own, internal[index], solid::stored_energy(body, own.data(), internal[index])};
    return known.energy;
  }
  // ½ u·K u
  VectorX force = VectorX::Zero(own.size());
  stiffness_[index].multiply(own.data(), force.data());
  return 0.5 * force.dot(own);
}

template <int D>
double StoredEnergy<D>::of_all(const VectorX& displacement, const std::vector<std::vector<double>>& internal) const {
  double sum = 0;
  for (int b = 0; b < std::ssize(scene_.bodies); ++b) sum += of_body(b, displacement, internal);
  return sum;
}

template class StoredEnergy<2>;
template class StoredEnergy<3>;

} // namespace signorini::model
