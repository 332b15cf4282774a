#pragma once
// Warnings of wear whose depth is not small: bodies keep the shape and the stiffness that they had before.

#include "model/steps/model.hpp"

namespace signorini::model {

template <int D> void warn_of_deep_wear(const Model<D>& model, std::vector<Message>& warnings);

} // namespace signorini::model
