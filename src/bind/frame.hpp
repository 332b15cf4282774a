#pragma once
// States of models and patches as pictures show them, free of their models.

#include "base/window.hpp"
#include "bind/arguments.hpp"
#include "bind/scene.hpp"
#include "tessellation/tessellate.hpp"
#include "view/panel.hpp"

namespace signorini::bind {

/// How a state, or patches, shall be shown.
struct Showing {
  std::string field = ""; ///< empty: gray
  double factor = 1;
  bool deformed = true, undeformed = false, mesh = true, control_points = false;
  bool obstacles = true;
  bool names = true;                ///< of patches: faces and directions, of several their numbers as well
  std::string vectors = "";         ///< "displacement", "traction", or none
  std::vector<int> bodies = {};     ///< those to be drawn
  std::string mirror = "";          ///< axes across which the model goes on, "xy"
  std::vector<Window> windows = {}; ///< what is shown larger than the whole, its images in the mirrors as well
};

/// Where a model of solids is cut open; without a point through the middle of what is shown.
struct Cut {
  Vec<3> normal;
  std::optional<Vec<3>> point = {};
};

/// `cut`: of solids.
template <int D> view::Panel show(const model::Model<D>& model, const Showing& showing, const std::optional<Cut>& cut);

/// Curves, surfaces and volumes before they are bodies; all in the plane, or all in space.
view::Panel show(const std::vector<nurbs::Patch>& patches, const Showing& showing);

/// What pictures draw of a body or of a patch.
view::Body picture_body(tessellation::Skin skin, const Showing& showing);

/// The field that is drawn on slave faces alone.
inline constexpr const char* pressure_name = "contact_pressure";

/// A band along the slave face of a contact, inside its body, that has the colors of the pressure; `size` is the
/// longest side of what is drawn.
view::Body pressure_band(const model::Model<2>& model, int contact, const Showing& showing, double size);

/// The tractions on the slave faces of the bodies that are drawn, at the contact points that touch.
template <int D> std::vector<view::PointVector> tractions(const model::Model<D>& model, const std::vector<int>& bodies);

} // namespace signorini::bind
