#pragma once
// Solid scenes that are bodies of revolution, or sectors of them: a section would do.

#include "model/model.hpp"

namespace signorini::model {

struct Revolution {
  int axis;                    ///< 0, 1, 2: the axis is parallel to x, y or z
  Vec<3> centre;               ///< a point of it
  std::vector<int> directions; ///< per body: the parametric direction around it
};

/// The axis that all of a scene turns around, if there is one. Bodies: along one parametric direction the map runs on
/// circles about it (tangents t at sampled points: t·e = 0 and t·(x − c) = 0); they are whole turns, or end in
/// planes normal to coordinate axes that supports hold as symmetry planes. Supports hold both or none of the components
/// across the axis, and drive none; loads, contact faces and obstacles fit too. Regions (`where`) are taken for none
/// that do.
std::optional<Revolution> find_revolution(const Model<3>& model);

/// Unknowns of the section: two per control point, the radius held on the axis.
int unknowns_of_section(const Model<3>& model, const Revolution& revolution);

} // namespace signorini::model
