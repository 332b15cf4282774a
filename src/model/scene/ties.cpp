#include "model/scene/ties.hpp"

#include "base/error.hpp"
#include "model/constants.hpp"
#include "model/scene/contact_faces.hpp"
#include "model/scene/thickness.hpp"
#include "nurbs/constants.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace signorini::model {

namespace {

/// In percent, with two digits.
double rounded_percent(double part) {
  return part < 0.1 ? std::round(1000 * part) / 10 : std::round(100 * part);
}

template <int D> void check_seam(const Scene<D>& scene, const Tie& named, const contact::Seam<D>& seam) {
  const Message slave = faces_message(scene, named.slave), master = faces_message(scene, named.master);
  require(!seam.points.empty(), "model.tie.apart", {{"tie", tie_message(named)}, {"slave", slave}, {"master", master}});
  const auto& [distance, place] = seam.distance;
  require(distance <= most_seam_distance * seam.length, "model.tie.distance",
          {{"tie", tie_message(named)},
           {"slave", slave},
           {"master", master},
           {"distance", distance},
           {"at", place},
           {"percent", rounded_percent(distance / seam.length)},
           {"most", rounded_percent(most_seam_distance)}});
  require(seam.facing.value <= 0, "model.tie.facing",
          {{"tie", tie_message(named)}, {"slave", slave}, {"master", master}, {"at", seam.facing.place}});
}

} // namespace

Message tie_message(const Tie& tie) {
  return Message(tie.from_join ? "model.tie.name_of_join" : "model.tie.name", {{"name", tie.name}});
}

template <int D> contact::Ties<D> make_ties(const Scene<D>& scene) {
  contact::Ties<D> ties;
  for (const Tie& tie : scene.ties) {
    const auto surface = [&](const Faces& faces, const char* side) {
      return surface_of(scene, faces, Message("model.tie.faces", {{"tie", tie_message(tie)}, {"side", side}}));
    };
    const contact::Surface<D> slave = surface(tie.slave, "slave"), master = surface(tie.master, "master");
    contact::Seam<D> seam = contact::find_seam(slave, master, scene.kind == solid::Kind::axisymmetric);
    check_seam(scene, tie, seam);
    ties.emplace_back(slave, master, std::move(seam), tie.multipliers);
  }
  return ties;
}

template <int D>
void warn_of_ties(const Scene<D>& scene, const contact::Ties<D>& ties, std::vector<Message>& warnings) {
  for (std::size_t k = 0; k < ties.size(); ++k) {
    const Tie& tie = scene.ties[k];
    const contact::Seam<D>& seam = ties[k].seam();
    if (tie.from_join && seam.distance.value > nurbs::joinable * seam.length)
      warnings.push_back(Message("model.warning.tied_gap", {{"tie", tie_message(tie)},
                                                            {"slave", faces_message(scene, tie.slave)},
                                                            {"master", faces_message(scene, tie.master)},
                                                            {"distance", seam.distance.value},
                                                            {"at", seam.distance.place}}));
    const bool whole = seam.area >= least_whole * seam.whole;
    if (!whole)
      warnings.push_back(Message("model.warning.tied_part", {{"tie", tie_message(tie)},
                                                             {"slave", faces_message(scene, tie.slave)},
                                                             {"percent", rounded_percent(seam.area / seam.whole)},
                                                             {"master", faces_message(scene, tie.master)}}));
    for (const Contact<D>& contact : scene.contacts) {
      const auto* master = std::get_if<Faces>(&contact.master);
      if (whole && (contact.slave.meets(tie.slave) || (master && master->meets(tie.slave))))
        warnings.push_back(
            Message("model.warning.tied_in_contact",
                    {{"contact", contact.name}, {"face", faces_message(scene, tie.slave)}, {"tie", tie_message(tie)}}));
    }
  }
}

template <int D> double tied_stiffness(const Scene<D>& scene, const Tie& tie) {
  double least = std::numeric_limits<double>::infinity();
  for (const Faces* faces : {&tie.slave, &tie.master})
    for (const FaceReference& face : *faces) least = std::min(least, element_stiffness(scene, face));
  return least;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template contact::Ties<D> make_ties(const Scene<D>&);                                                                \
  template void warn_of_ties(const Scene<D>&, const contact::Ties<D>&, std::vector<Message>&);                         \
  template double tied_stiffness(const Scene<D>&, const Tie&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
