#include "model/diagnosis/failure_places.hpp"

#include "base/orthonormal.hpp"
#include "model/constants.hpp"
#include "model/diagnosis/unheld_motions.hpp"
#include "model/scene/turning.hpp"
#include "model/system/rigid_motions.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::model {

namespace {

/// Displacement of a control point in the accepted state.
template <int D> VectorX accepted_displacement(const Model<D>& model, int body, int function) {
  return model.accepted.displacement.template segment<D>(model.system.unknowns.offset(body) + D * function);
}

/// A control point of a body.
template <int D> FailurePlace control_point(const Model<D>& model, int body, int function) {
  const auto& named = model.system.scene.bodies[body];
  const VectorX reference = named.body->space().points().col(function);
  return {"control point",
          named.name,
          function,
          reference,
          reference + accepted_displacement(model, body, function),
          0,
          {}};
}

} // namespace

template <int D>
std::vector<FailurePlace> largest_shares(const Model<D>& model, const VectorX& values,
                                         const std::function<Message(double)>& what) {
  struct Share {
    int body, function;
    double size;
  };
  std::vector<Share> shares;
  const VectorX all = model.system.unknowns.spread(values);
  for (int b = 0; b < std::ssize(model.system.scene.bodies); ++b)
    for (int a = 0; a < model.system.scene.bodies[b].body->functions(); ++a)
      shares.push_back({b, a, all.template segment<D>(model.system.unknowns.offset(b) + D * a).norm()});
  const std::size_t count = std::min<std::size_t>(3, shares.size());
  std::partial_sort(shares.begin(), shares.begin() + static_cast<std::ptrdiff_t>(count), shares.end(),
                    [](const Share& a, const Share& b) { return a.size > b.size; });
  std::vector<FailurePlace> spots;
  for (std::size_t k = 0; k < count && shares[k].size > least_share * values.lpNorm<Eigen::Infinity>(); ++k) {
    FailurePlace spot = control_point(model, shares[k].body, shares[k].function);
    spot.value = shares[k].size;
    spot.what = what(spot.value);
    spots.push_back(std::move(spot));
  }
  return spots;
}

template <int D>
FailurePlace contact_point(const Model<D>& model, std::size_t contact, std::size_t i, double gap, Message what) {
  const contact::ContactPoints<D>& points = model.system.contacts[contact]->points();
  return {"contact point",
          model.system.scene.contacts[contact].name,
          points.list[i].element,
          points.reference[i],
          model.accepted.contacts[contact].results[i].position,
          gap,
          std::move(what)};
}

template <int D> FailurePlace inverted_element(const Model<D>& model) {
  const auto& [body, inversion] = *model.inversion;
  const auto& named = model.system.scene.bodies[body];
  const nurbs::Discretization& space = named.body->space();
  const solid::ElementQuadrature rule = solid::element_quadrature(space, inversion.element);
  VectorX current = inversion.point;
  for (Eigen::Index q = 0; q < rule.points.cols(); ++q)
    if (solid::reference_point(*named.body, inversion.element, static_cast<int>(q)) == inversion.point) {
      const nurbs::ElementBasis basis = space.basis(inversion.element, rule.points.col(q));
      for (std::size_t a = 0; a < basis.functions.size(); ++a)
        current += basis.values(static_cast<Eigen::Index>(a)) * accepted_displacement(model, body, basis.functions[a]);
    }
  return {"element",
          named.name,
          inversion.element,
          inversion.point,
          current,
          inversion.jacobian,
          Message("model.place.jacobian", {{"jacobian", inversion.jacobian}})};
}

template <int D> Message obstacle_part(const Model<D>& model, const VectorX& all) {
  const Scene<D>& scene = model.system.scene;
  const Unknowns<D>& unknowns = model.system.unknowns;
  const auto message = [&](int obstacle, const std::string& component) {
    return Message("model.diagnosis.obstacle",
                   {{"component", component}, {"support", support_of(scene, obstacle, component)}});
  };
  for (int k = 0; k < std::ssize(scene.obstacles); ++k)
    for (int c = 0; c < D; ++c)
      if (std::abs(all(unknowns.obstacle_offset(k) + c)) > own_part * all.norm()) return message(k, component_name(c));
  for (const FreeAngle<D>& angle : unknowns.free_angles())
    if (std::abs(all(angle.dof)) > own_part * all.norm()) return message(angle.obstacle, "angle");
  return {};
}

template <int D> Message rigid_part(const Model<D>& model, const VectorX& direction) {
  const VectorX all = model.system.unknowns.spread(direction);
  if (Message obstacle = obstacle_part(model, all); !obstacle.code.empty()) return obstacle;
  for (std::size_t b = 0; b < model.system.scene.bodies.size(); ++b) {
    const auto& named = model.system.scene.bodies[b];
    const auto own = model.system.unknowns.of_body(static_cast<int>(b), all);
    const Vec<D> mean = own.rowwise().mean();
    if (own.norm() < own_part * all.norm()) continue;
    // An axisymmetric body translates as a rigid one along its axis alone.
    const bool radial =
        model.system.scene.kind == solid::Kind::axisymmetric && std::abs(mean(0)) > deformed_part * mean.norm();
    if (Message several = unheld_motions(model, static_cast<int>(b)); !several.code.empty()) return several;
    if (!radial && (own.colwise() - mean).norm() <= deformed_part * own.norm())
      return Message("model.diagnosis.moves", {{"body", named.name}, {"direction", Vec<D>(mean / mean.norm())}});
    // least-squares residual of u = Σ_m a_m m with the rigid-body modes m
    const std::vector<VectorX> motions = rigid_motions<D>(named.body->space().points(), model.system.scene.kind);
    MatrixX columns(own.size(), static_cast<Eigen::Index>(motions.size()));
    for (std::size_t m = 0; m < motions.size(); ++m) columns.col(static_cast<Eigen::Index>(m)) = motions[m];
    const VectorX flat = Eigen::Map<const VectorX>(own.data(), own.size());
    if (residual_of(orthonormal(columns), flat).norm() <= deformed_part * flat.norm())
      return Message("model.diagnosis.turns", {{"body", named.name}});
  }
  return {};
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template std::vector<FailurePlace> largest_shares(const Model<D>&, const VectorX&,                                   \
                                                    const std::function<Message(double)>&);                            \
  template FailurePlace contact_point(const Model<D>&, std::size_t, std::size_t, double, Message);                     \
  template FailurePlace inverted_element(const Model<D>&);                                                             \
  template Message obstacle_part(const Model<D>&, const VectorX&);                                                     \
  template Message rigid_part(const Model<D>&, const VectorX&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
