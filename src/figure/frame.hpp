#pragma once
// Contents of pictures of models and patches, independent of these after sampling.

#include "base/window.hpp"
#include "model/results/face_values.hpp"
#include "tessellation/tessellate.hpp"
#include "view/panel.hpp"

namespace signorini::figure {

/// Options for the display of a state or of patches.
struct Showing {
  std::string field = ""; ///< empty: gray
  double factor = 1;
  bool deformed = true, undeformed = false, mesh = true, control_points = false;
  bool obstacles = true;
  bool names = true;                ///< of patches: faces and directions, and numbers if there are several
  std::string vectors = "";         ///< "displacement", "traction", or none
  std::vector<int> bodies = {};     ///< those to be drawn
  std::vector<int> gray = {};       ///< those without the field
  std::string mirror = "";          ///< mirror axes, such as "xy"
  std::vector<Window> windows = {}; ///< regions shown magnified, with their mirror images
};

/// A cut of a model of solids; default point: center of the bodies.
struct Cut {
  Vec<3> normal;
  std::optional<Vec<3>> point = {};
};

/// `cut`: for solids only.
template <int D> view::Panel show(const model::Model<D>& model, const Showing& showing, const std::optional<Cut>& cut);

/// Curves, surfaces and volumes without body; all in the plane, or all in space.
view::Panel show(const std::vector<nurbs::Patch>& patches, const Showing& showing);

/// The drawing of a body or patch.
view::Body picture_body(tessellation::Skin skin, const Showing& showing);

/// A band along a slave face, inside its body, colored by the field of all its contacts; `size`: longest side of the
/// drawn bodies.
view::Body face_band(const model::Model<2>& model, model::FaceField field, const model::FaceReference& face,
                     const Showing& showing, double size);

/// The tractions at the closed contact points on the slave faces of the drawn bodies.
template <int D> std::vector<view::PointVector> tractions(const model::Model<D>& model, const std::vector<int>& bodies);

} // namespace signorini::figure
