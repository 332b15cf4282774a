#pragma once
// Bodies that slide, because their contact has no friction or less than their loads demand.

#include "model/steps/model.hpp"

namespace signorini::model {

/// Remedy for a body that slides along a direction, by unknown, in frictionless contact; empty if there is none.
template <int D> std::vector<Message> remedies_of_sliding(const Model<D>& model, const VectorX& direction);

/// Says of the first body that one contact alone holds that no friction balances its present loads F; empty if there is
/// none. The loads press it on with N = F·n, n the mean normal of the touching points, and demand a friction of
/// |F − N n|. By statics this is at most N tan(arctan μ ± φ), φ the largest angle between n and the normal of a point;
/// between the two bounds all touching points of the failed step must slip. Bodies with supports against translations,
/// springs, joins, ties or other contacts are not examined.
template <int D> Message exhausted_friction(const Model<D>& model);

} // namespace signorini::model
