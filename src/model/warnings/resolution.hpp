#pragma once
// Contacts whose pressure the slave's elements, or Gauss points with a high penalty, do not resolve.

#include "model/steps/model.hpp"

namespace signorini::model {

/// Appends a warning for each contact whose zone around its largest pressure is narrower than the one from which peaks
/// are within 10 % of closed forms. A zone that ends with the slave face at both ends is not narrow, as of a block on
/// its whole face; one that ends with it at one end counts twice, as at a plane of symmetry. Peaks that the mean over
/// an element confirms, which needs a smaller width, are exempt.
template <int D> void warn_of_narrow_contacts(const Model<D>& model, std::vector<Message>& warnings);

/// True for a contact with such a zone.
template <int D> bool is_narrow(const Model<D>& model, int contact);

} // namespace signorini::model
