#pragma once
// Models with other rows of control points in the same state: layers that follow the contact.

#include "model/scene/replaced_rows.hpp"
#include "model/steps/model.hpp"

namespace signorini::model {

/// A model of the same scene with these bodies, which differ from the present ones in their rows only, in the accepted
/// state of `model`. Displacements and multipliers are projected row by row (nurbs/row_projection.hpp): exactly, where
/// the new rows contain the old ones. Contact points, with the places on the master that they remember, are the same.
/// The contacts are evaluated. Where displacements have changed the state is not in equilibrium: the next step solves
/// for the rest. Reactions are those of the former equilibrium.
/// Null if an element would be inverted. No step may be pending. Throws Error as check_replaceable().
template <int D> std::shared_ptr<Model<D>> with_bodies(const Model<D>& model, const Bodies<D>& bodies);

} // namespace signorini::model
