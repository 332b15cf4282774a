#include "model/warnings/state_warnings.hpp"

#include "model/warnings/beyond_ends.hpp"
#include "model/warnings/deep_wear.hpp"
#include "model/warnings/penetration.hpp"
#include "model/warnings/resolution.hpp"
#include "model/warnings/small_strain.hpp"
#include "model/warnings/stability.hpp"
#include "model/warnings/stiff_bending.hpp"
#include "model/warnings/undeclared_obstacle.hpp"

namespace signorini::model {

template <int D> std::vector<Message> state_warnings(Model<D>& model, bool everything) {
  std::vector<Message> warnings;
  if (!settled(model)) return warnings;
  if (everything) {
    const PresentOutlines<D> outlines(model);
    warn_of_overlaps(model, outlines, warnings);
    warn_of_obstacles(model, outlines, warnings);
    warn_of_stiff_bending(model, warnings);
  }
  warn_of_narrow_contacts(model, warnings);
  warn_of_soft_penalties(model, warnings);
  if (everything) {
    warn_of_large_strains(model, warnings);
    warn_of_instability(model, warnings);
  }
  warn_of_ends(model, warnings);
  warn_of_deep_wear(model, warnings);
  return warnings;
}

template std::vector<Message> state_warnings(Model<2>&, bool);
template std::vector<Message> state_warnings(Model<3>&, bool);

} // namespace signorini::model
