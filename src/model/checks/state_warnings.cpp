#include "model/checks/state_warnings.hpp"

#include "model/checks/beyond_ends.hpp"
#include "model/checks/penetration.hpp"
#include "model/checks/resolution.hpp"
#include "model/checks/small_strain.hpp"
#include "model/checks/stability.hpp"
#include "model/checks/stiff_bending.hpp"
#include "model/checks/undeclared_obstacle.hpp"

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
  return warnings;
}

template std::vector<Message> state_warnings(Model<2>&, bool);
template std::vector<Message> state_warnings(Model<3>&, bool);

} // namespace signorini::model
