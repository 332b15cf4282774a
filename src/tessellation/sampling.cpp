#include "tessellation/sampling.hpp"

#include "model/results/sample.hpp"

namespace signorini::tessellation {

using model::BodyPoint;
namespace {

/// Visible part of a body: pieces of elements in two directions.
template <int D> struct Pieces {
  const Model<D>& model;
  int body;
  bool deformed;

  Vec<3> place(int e, const VectorX& xi) const {
    const BodyPoint<D> point = body_point(model, body, e, xi);
    Vec<3> result = Vec<3>::Zero();
    result.template head<D>() = point.reference;
    if (deformed) result.template head<D>() += point.state.displacement;
    return result;
  }

  /// Divides the piece of element e in two directions; in a solid, `fractions` fixes the third one.
  void cut(Sampling<D>& sampling, int e, std::array<int, 2> along, Vec<D> fractions,
           const std::vector<Window>& windows) const {
    const nurbs::Discretization& space = model.system.scene.bodies[body].body->space();
    const auto at_fractions = [&](double s, double t) {
      fractions(along[0]) = s;
      fractions(along[1]) = t;
      return place(e, space.parameter(e, fractions));
    };
    const auto cuts = window_divisions(at_fractions, windows, true);
    for (std::size_t i : {0, 1}) add_divisions(sampling[along[i]][space.element_index(e, along[i])], cuts[i]);
  }
};

} // namespace

template <int D> Sampling<D> even_sampling(const nurbs::Discretization& space, int divisions) {
  Sampling<D> sampling;
  for (int d = 0; d < D; ++d) sampling[d].assign(space.elements(d), even_cuts(divisions));
  return sampling;
}

template <int D>
Sampling<D> sampling(const Model<D>& model, int body, int divisions, bool deformed,
                     const std::vector<Window>& windows) {
  const nurbs::Discretization& space = model.system.scene.bodies[body].body->space();
  Sampling<D> result = even_sampling<D>(space, divisions);
  if (windows.empty()) return result;
  const Pieces<D> pieces{model, body, deformed};
  for (int e = 0; e < space.elements(); ++e) {
    if constexpr (D == 2)
      pieces.cut(result, e, {0, 1}, Vec<2>::Zero(), windows);
    else
      for (int d = 0; d < 3; ++d)
        for (bool at_end : {false, true})
          if (space.touches(e, {d, at_end}))
            pieces.cut(result, e, {d == 0 ? 1 : 0, d == 2 ? 1 : 2}, at_end ? Vec<3>::Ones() : Vec<3>::Zero(), windows);
  }
  return result;
}

template Sampling<2> even_sampling<2>(const nurbs::Discretization&, int);
template Sampling<3> even_sampling<3>(const nurbs::Discretization&, int);
template Sampling<2> sampling<2>(const Model<2>&, int, int, bool, const std::vector<Window>&);
template Sampling<3> sampling<3>(const Model<3>&, int, int, bool, const std::vector<Window>&);

} // namespace signorini::tessellation
