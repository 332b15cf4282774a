#include "model/warnings/beyond_ends.hpp"

#include <cmath>

namespace signorini::model {

namespace {

/// Share of a contact's force beyond the ends above which a warning is given: a master is wider by about that much.
constexpr double noticeable_share = 0.01;

/// Share of the sum of the points' forces that acts at points opposite an extension; 0 without forces.
template <int D> double share_beyond(const contact::Formulation<D>& contact, const contact::History<D>& history) {
  double all = 0, beyond = 0;
  contact::FaceCoordinates<D> rate;
  for (std::size_t i = 0; i < history.results.size(); ++i) {
    const double force = history.results[i].force.norm();
    if (force == 0) continue;
    all += force;
    if (contact.master().fade(history.points[i].projection.xi, rate) < 1) beyond += force;
  }
  return all > 0 ? beyond / all : 0;
}

} // namespace

template <int D> void warn_of_ends(const Model<D>& model, std::vector<Message>& warnings) {
  double most = 0;
  std::size_t worst = 0;
  for (std::size_t k = 0; k < model.system.contacts.size(); ++k) {
    const double share = share_beyond(*model.system.contacts[k], model.accepted.contacts[k]);
    if (share <= most) continue;
    most = share;
    worst = k;
  }
  if (most <= noticeable_share) return;
  const Contact<D>& contact = model.system.scene.contacts[worst];
  Message remedy;
  if (std::holds_alternative<Faces>(contact.master)) remedy = Message("model.beyond_end.swap");
  warnings.push_back(
      Message("model.warning.beyond_end", {{"contact", contact.name}, {"percent", 100 * most}, {"remedy", remedy}}));
}

template void warn_of_ends(const Model<2>&, std::vector<Message>&);
template void warn_of_ends(const Model<3>&, std::vector<Message>&);

} // namespace signorini::model
