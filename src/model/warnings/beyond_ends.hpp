#pragma once
// Contact forces that act beyond the ends of masters, where a face is only continued (contact/point/master.hpp).

#include "model/steps/model.hpp"

namespace signorini::model {

/// Appends a warning about the contact of which the largest share of the force in the accepted state acts beyond open
/// ends of the master, if that is above 1 %.
template <int D> void warn_of_ends(const Model<D>& model, std::vector<Message>& warnings);

} // namespace signorini::model
