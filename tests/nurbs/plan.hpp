#pragma once
// Plans of refinement in one line.

#include "nurbs/discretization.hpp"

namespace signorini::nurbs::test {

/// One label for all directions: along the contact face, or without one of the whole body.
inline Plan plan_of(std::vector<int> elements, const std::string& contact, const std::string& label,
                    std::optional<int> thickness_degree = {}) {
  Plan plan;
  const int dimensions = static_cast<int>(elements.size());
  plan.elements = std::move(elements);
  if (!contact.empty()) plan.contact = {side_of(contact, dimensions)};
  plan.labels.assign(dimensions - (contact.empty() ? 0 : 1), parse_label(label));
  plan.thickness_degree = thickness_degree;
  return plan;
}

} // namespace signorini::nurbs::test
