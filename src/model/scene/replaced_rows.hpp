#pragma once
// A scene with other rows of control points in some of its bodies, as layers that follow the contact have.

#include "model/scene/region.hpp"

namespace signorini::model {

template <int D> using Bodies = std::vector<std::shared_ptr<const solid::Body<D>>>;

/// True if the row of a body has other functions, or may have them.
template <int D> using RowChanges = std::function<bool(int body, int row)>;

/// Throws Error if something in the scene prevents other rows of a body: internal variables of its material; a load
/// that is given at its Gauss points; a driven shape on a row that changes, a force along an edge of it, a tie of it as
/// slave; in 3D a join.
template <int D> void check_replaceable(const Scene<D>& scene, const RowChanges<D>& changes);

/// The scene with these bodies, which have the elements, the stack and the shape of the present ones. Supports and
/// forces act on the same faces, edges and corners.
template <int D> Scene<D> with_bodies(Scene<D> scene, const Bodies<D>& bodies);

} // namespace signorini::model
