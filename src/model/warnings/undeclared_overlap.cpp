#include "model/warnings/undeclared_overlap.hpp"

#include "model/checks/constants.hpp"
#include "model/results/results.hpp"
#include "model/scene/joins.hpp"
#include "nurbs/coincident.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace signorini::model {

namespace {

/// What a contact declares of its faces' overlap: penetrations, gaps by negative offsets, wear, and overlaps of the
/// initial shapes that are allowed.
template <int D> double declared_overlap(const contact::Formulation<D>& contact, const contact::History<D>& history) {
  double overlap = 0;
  for (const double depth : contact.parameters().overlap) overlap = std::max(overlap, depth);
  const contact::Resultant<D> sum = contact::resultant(history);
  return sum.max_penetration + sum.max_wear + std::abs(contact.parameters().offset(history.changes)) + overlap;
}

/// True if a side lies on the axis of revolution, where the other half of the body is behind it.
template <int D> bool lies_on_axis(const Outline<D>& outline, nurbs::Side side) {
  double size = 0, radius = 0;
  for (const Facet<D>& facet : outline.facets())
    for (const Vec<D>& corner : facet.corners) {
      size = std::max(size, corner.cwiseAbs().maxCoeff());
      if (facet.side == side) radius = std::max(radius, std::abs(corner(0)));
    }
  return radius <= outline_rounding * size;
}

/// True if faces that satisfy two conditions are those of a contact or a tie.
template <int D, class First, class Second>
bool any_pair(const Scene<D>& scene, const First& first, const Second& second) {
  const auto pairs = [&](const Faces& slave, const Faces& master) {
    return (first(slave) && second(master)) || (first(master) && second(slave));
  };
  return std::any_of(scene.ties.begin(), scene.ties.end(),
                     [&](const Tie& tie) { return pairs(tie.slave, tie.master); }) ||
         std::any_of(scene.contacts.begin(), scene.contacts.end(), [&](const Contact<D>& contact) {
           const auto* master = std::get_if<Faces>(&contact.master);
           return master && pairs(contact.slave, *master);
         });
}

template <int D> bool paired(const Scene<D>& scene, const FaceReference& a, const FaceReference& b) {
  return any_pair(
      scene, [&](const Faces& faces) { return faces.contains(a); },
      [&](const Faces& faces) { return faces.contains(b); });
}

/// The sides of a body that are in contact with or tied to another one.
template <int D> Sides<D> sides_against(const Scene<D>& scene, int body, int other) {
  Sides<D> against;
  for (const nurbs::Side side : nurbs::sides(D))
    against[number_of(side)] = any_pair(
        scene,
        [&](const Faces& faces) {
          return faces.contains({body, side});
        },
        [&](const Faces& faces) { return faces.on(other); });
  return against;
}

/// True if places of a facet are examined.
template <int D> bool is_examined(const PresentOutlines<D>& outlines, int body, const Facet<D>& facet) {
  return facet.radius > shortest_piece * outlines[body].thickness() && !facet.normal.isZero(0) &&
         !outlines.within(body, facet.side);
}

/// The deepest corner of faces in contact with or tied to each other, of two parts: neighbors start from there.
template <int D> double declared_depth(const PresentOutlines<D>& outlines, int first, int second) {
  const auto parts = [&](int a, int b) { return std::minmax({outlines.part(a), outlines.part(b)}); };
  const auto any = [](const Facet<D>&) { return true; };
  double depth = 0;
  const auto find_deeper = [&](const Outline<D>& outline, const Vec<D>& corner) {
    if (!outline.boxes(corner) || outline.layers(corner) < 1) return;
    depth = std::max(depth, outline.nearest(corner, any, depth).distance);
  };
  for (int b = 0; b < outlines.bodies(); ++b)
    for (int other = 0; other < outlines.bodies(); ++other) {
      if (parts(b, other) != parts(first, second) || !outlines[b].meets(outlines[other])) continue;
      const Sides<D> against = sides_against(outlines.scene(), b, other);
      for (std::size_t i = 0; i < outlines[b].facets().size(); i += Outline<D>::stride)
        if (const Facet<D>& facet = outlines[b].facets()[i];
            against[number_of(facet.side)] && is_examined(outlines, b, facet))
          for (const Vec<D>& corner : facet.corners) find_deeper(outlines[other], corner);
    }
  return depth;
}

/// A place of an overlap.
template <int D> struct Overlapping {
  double depth;
  FaceReference face, behind; ///< `face` lies behind `behind`
  Vec<D> position;
  bool paired; ///< the faces are those of a contact or a tie
};

/// The middle of a piece of one body's outline, if it lies in a body deeper than allowed.
template <int D>
std::optional<Overlapping<D>> overlapping(const PresentOutlines<D>& outlines, int body, const Facet<D>& facet,
                                          int other) {
  const Outline<D>& outline = outlines[other];
  const Vec<D> outside = facet.middle + beside_outline * facet.radius * facet.normal; // of its own outline
  if (!outline.boxes(outside) || outline.layers(outside) < 1) return {};
  const double allowed = outlines.allowed(body, facet);
  const auto may_be_behind = [&](const Facet<D>& behind) {
    if (outlines.within(other, behind.side)) return false;
    if (body != other) return true;
    return behind.normal.dot(facet.normal) < same_bend && behind.normal.dot(facet.middle - behind.middle) < 0;
  };
  const auto nearest = outline.nearest(facet.middle, may_be_behind, allowed);
  if (!nearest.facet || nearest.distance <= std::max(allowed, outlines.allowed(other, *nearest.facet))) return {};
  // At this depth a whole ball is covered. A tiny fold at an edge is not, far from all other faces.
  if (outline.layers(facet.middle + 0.5 * nearest.distance * facet.normal) < 1) return {};
  const FaceReference face{body, facet.side}, behind{other, nearest.facet->side};
  return Overlapping<D>{nearest.distance, face, behind, facet.middle, paired(outlines.scene(), face, behind)};
}

/// The deepest overlaps of two bodies.
template <int D> struct Overlaps {
  std::optional<Overlapping<D>> deepest, paired; ///< between other faces, and between paired ones

  void add(const Overlapping<D>& found) {
    auto& most = found.paired ? paired : deepest;
    if (!most || found.depth > most->depth) most = found;
  }
};

template <int D> DeclaredContacts contacts_between(const Model<D>& model, int first, int second) {
  return declared_contacts(model, [&](const Contact<D>& contact) {
    const auto* master = std::get_if<Faces>(&contact.master);
    return master &&
           ((contact.slave.on(first) && master->on(second)) || (contact.slave.on(second) && master->on(first)));
  });
}

} // namespace

template <int D> PresentOutlines<D>::PresentOutlines(const Model<D>& model) : scene_(model.system.scene) {
  const int count = std::ssize(scene_.bodies);
  const Groups joined = connected_bodies(scene_, false), connected = connected_bodies(scene_, true);
  for (int b = 0; b < count; ++b) {
    const nurbs::Discretization& space = scene_.bodies[b].body->space();
    outlines_.emplace_back(space, space.points() + body_displacement(model, b));
    within_.emplace_back();
    for (const int d : nurbs::closed_directions(space)) within_.back()[2 * d] = within_.back()[2 * d + 1] = true;
    if (scene_.kind == solid::Kind::axisymmetric)
      for (const nurbs::Side side : nurbs::sides(D))
        if (lies_on_axis(outlines_.back(), side)) within_.back()[number_of(side)] = true;
  }
  for (const Join& join : scene_.joins)
    for (const FaceReference& face : {join.first, join.second}) within_[face.body][number_of(face.side)] = true;
  declared_.assign(count, 0);
  std::vector<double> declared(count, 0);
  for (std::size_t k = 0; k < scene_.contacts.size(); ++k) {
    const double overlap = declared_slack * declared_overlap(*model.system.contacts[k], model.present.contacts[k]);
    for (int b = 0; b < count; ++b)
      if (acts_on(scene_.contacts[k], b)) {
        double& most = declared[connected.leader(b)];
        most = std::max(most, overlap);
      }
  }
  for (int b = 0; b < count; ++b) {
    parts_.push_back(joined.leader(b));
    declared_[b] = declared[connected.leader(b)];
  }
}

template <int D>
void warn_of_overlaps(const Model<D>& model, const PresentOutlines<D>& outlines, std::vector<Message>& warnings) {
  const Scene<D>& scene = model.system.scene;
  std::map<std::array<int, 2>, Overlaps<D>> overlaps;
  for (int b = 0; b < outlines.bodies(); ++b)
    for (int other = 0; other < outlines.bodies(); ++other) {
      if (!outlines[b].meets(outlines[other])) continue;
      for (std::size_t i = 0; i < outlines[b].facets().size(); i += Outline<D>::stride) {
        const Facet<D>& facet = outlines[b].facets()[i];
        if (!is_examined(outlines, b, facet)) continue;
        if (const auto found = overlapping(outlines, b, facet, other))
          overlaps[{std::min(b, other), std::max(b, other)}].add(*found);
      }
    }
  for (const auto& [bodies, found] : overlaps) {
    const int first = bodies[0], second = bodies[1];
    const DeclaredContacts between = contacts_between(model, first, second);
    const bool untouched = between.everywhere && between.active == 0;
    const bool unseen = found.paired && untouched;
    // What is declared includes the edges and corners of faces in contact, from which their neighbors start.
    const bool undeclared =
        !unseen && found.deepest && (untouched || found.deepest->depth > declared_depth(outlines, first, second));
    if (!unseen && !undeclared) continue;
    const Overlapping<D>& overlap = undeclared ? *found.deepest : *found.paired;
    const Message face = face_message(scene, overlap.face), behind = face_message(scene, overlap.behind);
    const double depth = overlap.depth;
    const Vec<D>& at = overlap.position;
    if (unseen) {
      warnings.push_back(
          Message("model.warning.unseen_overlap",
                  {{"contact", between.first}, {"face", face}, {"behind", behind}, {"depth", depth}, {"at", at}}));
    } else if (outlines.joined(first, second)) {
      warnings.push_back(
          Message("model.warning.self_overlap", {{"face", face}, {"behind", behind}, {"depth", depth}, {"at", at}}));
    } else {
      const Message hint = between.first.empty() ? Message("model.overlap.define")
                                                 : Message("model.overlap.extend", {{"contact", between.first}});
      warnings.push_back(Message("model.warning.undeclared_overlap",
                                 {{"face", face}, {"behind", behind}, {"depth", depth}, {"at", at}, {"hint", hint}}));
    }
  }
}

template <int D> void warn_of_folded_shapes(const Model<D>& model, std::vector<Message>& warnings) {
  const Scene<D>& scene = model.system.scene;
  const auto set_on = [&](int body) {
    return std::ranges::find_if(scene.contacts,
                                [&](const Contact<D>& contact) { return is_set(contact) && contact.slave.on(body); });
  };
  if (std::ranges::none_of(scene.contacts, is_set<D>)) return;
  const PresentOutlines<D> outlines(model);
  for (int b = 0; b < outlines.bodies(); ++b) {
    const auto set = set_on(b);
    if (set == scene.contacts.end()) continue;
    std::optional<Overlapping<D>> deepest;
    for (std::size_t i = 0; i < outlines[b].facets().size(); i += Outline<D>::stride) {
      const Facet<D>& facet = outlines[b].facets()[i];
      if (!is_examined(outlines, b, facet)) continue;
      const auto found = overlapping(outlines, b, facet, b);
      if (found && (!deepest || found->depth > deepest->depth)) deepest = found;
    }
    if (!deepest) continue;
    warnings.push_back(Message("model.warning.folded_shape", {{"contact", set->name},
                                                              {"face", face_message(scene, deepest->face)},
                                                              {"behind", face_message(scene, deepest->behind)},
                                                              {"depth", deepest->depth},
                                                              {"at", deepest->position}}));
  }
}

template class PresentOutlines<2>;
template class PresentOutlines<3>;
template void warn_of_overlaps<2>(const Model<2>&, const PresentOutlines<2>&, std::vector<Message>&);
template void warn_of_overlaps<3>(const Model<3>&, const PresentOutlines<3>&, std::vector<Message>&);
template void warn_of_folded_shapes<2>(const Model<2>&, std::vector<Message>&);
template void warn_of_folded_shapes<3>(const Model<3>&, std::vector<Message>&);

} // namespace signorini::model
