#pragma once
// Sampling points of bodies for pictures.

#include "base/window.hpp"
#include "model/steps/model.hpp"

namespace signorini::tessellation {

using model::Model;

/// Per direction and element index in it: increasing fractions of the element's interval from 0 to 1. Neighbors share
/// the fractions on their common border, so that pictures have no gaps.
template <int D> using Sampling = std::array<std::vector<std::vector<double>>, D>;

/// `divisions` equal pieces in all elements and directions.
template <int D> Sampling<D> even_sampling(const nurbs::Discretization& space, int divisions);

/// At least `divisions` pieces, and more where windows need them: of a plane body, or of the surface of a solid.
template <int D>
Sampling<D> sampling(const Model<D>& model, int body, int divisions, bool deformed, const std::vector<Window>& windows);

} // namespace signorini::tessellation
