#include "model/results/tie_results.hpp"

#include "model/scene/ties.hpp"

namespace signorini::model {

namespace {

/// Components of λ = s χ, D per row of the tie.
template <int D> VectorX tractions(const Model<D>& model, int tie) {
  const System<D>& system = model.system;
  const double scale = tie_scale * tied_stiffness(system.scene, system.scene.ties[tie]);
  return scale * model.present.displacement.segment(system.unknowns.of_tie(tie), system.ties[tie].multipliers());
}

} // namespace

template <int D> TieResultant<D> tie_resultant(const Model<D>& model, int tie) {
  const contact::Tie<D>& own = model.system.ties[tie];
  const VectorX lambda = tractions(model, tie);
  TieResultant<D> result{Vec<D>::Zero(), own.seam().area, own.seam().area / own.seam().whole,
                         own.seam().distance.value};
  // ∫ λ dA = Σ_A λ_A ∫ M_A dA
  for (std::size_t a = 0; a < own.rows().size(); ++a)
    result.force += own.rows()[a].area * lambda.segment<D>(D * static_cast<Eigen::Index>(a));
  return result;
}

template <int D> TieProfile tie_profile(const Model<D>& model, int tie) {
  const System<D>& system = model.system;
  const contact::Tie<D>& own = system.ties[tie];
  const VectorX lambda = tractions(model, tie);
  contact::Surface<D> slave = own.slave(), master = own.master();
  slave.move(model.present.displacement.data());
  master.move(model.present.displacement.data());
  TieProfile result;
  contact::FacePoint<D> now, foot, foot_before;
  const auto& points = own.seam().points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [slave_element, master_element, slave_xi, master_xi, place, area] = points[i];
    slave.locate(slave_element, slave_xi, 1, now);
    master.locate(master_element, master_xi, 0, foot);
    own.master().locate(master_element, master_xi, 0, foot_before);
    const Vec<D> traction = own.combine(i, lambda.data()), normal = outward(slave, now).normalized();
    for (std::size_t c = 0; c < D; ++c) {
      const auto k = static_cast<Eigen::Index>(c);
      result.position[c].push_back(now.position(k));
      result.reference[c].push_back(place(k));
      result.traction[c].push_back(traction(k));
    }
    result.area.push_back(area);
    result.pressure.push_back(-traction.dot(normal));
    const Vec<D> tangential = traction - traction.dot(normal) * normal;
    result.shear.push_back(D == 2 ? traction.dot(now.tangent[0].normalized()) : tangential.norm());
    result.jump.push_back((foot.position - foot_before.position - now.position + place).norm());
  }
  return result;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template TieResultant<D> tie_resultant(const Model<D>&, int);                                                        \
  template TieProfile tie_profile(const Model<D>&, int);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
