#pragma once
// Where bodies are sampled for pictures.

#include "base/window.hpp"
#include "model/model.hpp"

namespace signorini::tessellation {

using model::Model;

/// By direction and by the element's number along it: rising fractions of its interval, from 0 to 1. Neighbors share
/// those of their common border, so that no gap opens between them.
template <int D> using Sampling = std::array<std::vector<std::vector<double>>, D>;

/// The same number of pieces in all elements and directions.
template <int D> Sampling<D> even_sampling(const nurbs::Discretization& space, int divisions);

/// The same number of pieces, and as many more as windows need: of a plane body, or of the surface of a solid.
template <int D>
Sampling<D> sampling(const Model<D>& model, int body, int divisions, bool deformed, const std::vector<Window>& windows);

} // namespace signorini::tessellation
