#include "model/system/tie_terms.hpp"

#include "base/orthonormal.hpp"
#include "model/constants.hpp"
#include "model/scene/ties.hpp"
#include "model/system/rigid_motions.hpp"

#include <algorithm>

namespace signorini::model {

void TieTerms::multiply(const VectorX& vector, VectorX& product) const {
  for (const auto& [multiplier, displacement, value] : couplings) {
    product(multiplier) += value * vector(displacement);
    product(displacement) += value * vector(multiplier);
  }
}

template <int D> TieTerms tie_terms(const Scene<D>& scene, const Unknowns<D>& unknowns, const contact::Ties<D>& ties) {
  TieTerms terms;
  for (std::size_t k = 0; k < ties.size(); ++k) {
    const double scale = tie_scale * tied_stiffness(scene, scene.ties[k]);
    int multiplier = unknowns.of_tie(k);
    for (const auto& row : ties[k].rows())
      for (int c = 0; c < D; ++c, ++multiplier) {
        for (const auto& [function, value] : row.slave)
          terms.couplings.push_back({multiplier, D * function + c, -scale * value});
        for (const auto& [function, value] : row.master)
          terms.couplings.push_back({multiplier, D * function + c, scale * value});
        terms.proximal.push_back({multiplier, -tie_proximal * scale * row.area});
      }
  }
  return terms;
}

namespace {

/// True if the prescribed degrees of freedom of a body prevent all its rigid-body modes.
template <int D> bool is_held(const Scene<D>& scene, const Unknowns<D>& unknowns, int body) {
  std::vector<int> prescribed;
  for (int i = 0; i < D * scene.bodies[body].body->functions(); ++i)
    if (unknowns.unknown(unknowns.offset(body) + i) < 0) prescribed.push_back(i);
  const auto motions = rigid_motions<D>(scene.bodies[body].body->space().points(), scene.kind);
  MatrixX columns(static_cast<Eigen::Index>(prescribed.size()), static_cast<Eigen::Index>(motions.size()));
  for (Eigen::Index m = 0; m < columns.cols(); ++m)
    for (Eigen::Index i = 0; i < columns.rows(); ++i) columns(i, m) = motions[m](prescribed[i]);
  // A mode that depends on those before it leaves no residual.
  for (Eigen::Index m = 0; m < columns.cols(); ++m) {
    const MatrixX rest = residual_of(orthonormal(columns.leftCols(m)), columns.col(m));
    if (rest.norm() <= dependent_modes * std::max(1.0, columns.col(m).norm())) return false;
  }
  return true;
}

} // namespace

template <int D>
std::vector<int> tie_border(const Scene<D>& scene, const Unknowns<D>& unknowns, const contact::Ties<D>& ties) {
  std::vector<int> border;
  const auto add = [&](int dof) {
    if (const int i = unknowns.unknown(dof); i >= 0) border.push_back(i);
  };
  for (std::size_t k = 0; k < ties.size(); ++k) {
    for (int i = 0; i < ties[k].multipliers(); ++i) add(unknowns.of_tie(k) + i);
    const auto add_faces = [&](const contact::Surface<D>& surface, const Faces& faces) {
      if (std::all_of(faces.begin(), faces.end(),
                      [&](const FaceReference& face) { return is_held(scene, unknowns, face.body); }))
        return;
      for (int i = 0; i < surface.functions(); ++i)
        for (int c = 0; c < D; ++c) add(D * surface.body_function(i) + c);
    };
    add_faces(ties[k].slave(), scene.ties[k].slave);
    add_faces(ties[k].master(), scene.ties[k].master);
  }
  std::sort(border.begin(), border.end());
  border.erase(std::unique(border.begin(), border.end()), border.end());
  return border;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template TieTerms tie_terms(const Scene<D>&, const Unknowns<D>&, const contact::Ties<D>&);                           \
  template std::vector<int> tie_border(const Scene<D>&, const Unknowns<D>&, const contact::Ties<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
