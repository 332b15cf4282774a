#include "model/scene/check.hpp"

#include "base/error.hpp"
#include "model/scene/contact_faces.hpp"
#include "model/scene/default_penalty.hpp"
#include "model/scene/free_faces.hpp"
#include "model/scene/joins.hpp"
#include "model/scene/supports.hpp"

#include <algorithm>
#include <utility>

namespace signorini::model {

namespace {

template <int D> void check_bodies(const Scene<D>& scene) {
  require(!scene.bodies.empty(), "model.scene.no_body");
  for (const auto& named : scene.bodies)
    require(named.body->kind() == scene.kind, "model.scene.kind", {{"body", named.name}});
}

/// The faces of matching joins have no other use.
template <int D> void check_join(const Scene<D>& scene, const Join& join) {
  const auto expect_none = [&](const std::vector<FaceReference>& faces, const auto& message) {
    for (const FaceReference& face : faces)
      if (face == join.first || face == join.second) throw Error(message(face_message(scene, face)));
  };
  for (const Join& other : scene.joins)
    if (&other != &join)
      expect_none({other.first, other.second}, [&](const Message& face) {
        return Message("model.join.twice", {{"join", join.name}, {"other", other.name}, {"face", face}});
      });
  for (const Tie& tie : scene.ties)
    expect_none(faces_of(tie), [&](const Message& face) {
      return Message("model.join.tied", {{"join", join.name}, {"tie", tie_message(tie)}, {"face", face}});
    });
  for (const Contact<D>& contact : scene.contacts) {
    const auto* master = std::get_if<Faces>(&contact.master);
    for (const Faces& faces : {contact.slave, master ? *master : Faces{}})
      expect_none(faces, [&](const Message& face) {
        return Message("model.join.in_contact", {{"join", join.name}, {"contact", contact.name}, {"face", face}});
      });
  }
  const auto expect_no_action = [&](const std::vector<FaceReference>& faces, const Message& action) {
    expect_none(faces, [&](const Message& face) {
      return Message("model.join.loaded", {{"join", join.name}, {"action", action}, {"face", face}});
    });
  };
  for (const Load& load : scene.loads) expect_no_action(load.on, Message("model.action.load", {{"name", load.name}}));
  for (const Support<D>& support : scene.supports)
    expect_no_action(support.spring_faces, Message("model.action.springs", {{"name", support.name}}));
}

/// The faces of a list differ and do not collapse.
template <int D> void check_list(const Scene<D>& scene, const Faces& faces, const Message& list) {
  for (auto face = faces.begin(); face != faces.end(); ++face)
    require(std::find(faces.begin(), face, *face) == face, "model.contact.face_twice",
            {{"list", list}, {"face", face_message(scene, *face)}});
  for (const FaceReference& face : faces)
    require(!is_collapsed(scene, face), "model.contact.collapsed",
            {{"list", list}, {"face", face_message(scene, face)}});
}

template <int D> void check_contact(const Scene<D>& scene, const Contact<D>& contact) {
  const auto check = [&](const Faces& faces, const Message& list) {
    check_list(scene, faces, list);
    if (faces.size() > 1 && !is_loose(contact)) surface_of(scene, faces, list);
  };
  if (is_set(contact))
    return check_list(scene, contact.slave, Message("model.contact.among", {{"name", contact.name}}));
  const auto* master = std::get_if<Faces>(&contact.master);
  require(!master || !master->meets(contact.slave), "model.scene.own_face", {{"contact", contact.name}});
  check(contact.slave, Message("model.contact.slave", {{"name", contact.name}}));
  if (master) check(*master, Message("model.contact.master", {{"name", contact.name}}));
}

/// True if a tie connects a face of one list with a face of the other one.
bool acts_between(const Tie& tie, const Faces& first, const Faces& second) {
  return (tie.slave.meets(first) && tie.master.meets(second)) || (tie.slave.meets(second) && tie.master.meets(first));
}

/// Two faces are connected once.
template <int D> void check_tie(const Scene<D>& scene, const Tie& tie) {
  const Message slave = faces_message(scene, tie.slave), master = faces_message(scene, tie.master);
  require(!tie.slave.meets(tie.master), "model.tie.own_face", {{"tie", tie_message(tie)}});
  for (const Tie& other : scene.ties) {
    if (&other == &tie) break;
    require(!acts_between(other, tie.slave, tie.master), "model.tie.twice",
            {{"tie", tie_message(tie)}, {"other", tie_message(other)}, {"slave", slave}, {"master", master}});
  }
  for (const Contact<D>& contact : scene.contacts) {
    const auto* faces = std::get_if<Faces>(&contact.master);
    require(!faces || !acts_between(tie, contact.slave, *faces), "model.tie.in_contact",
            {{"tie", tie_message(tie)}, {"contact", contact.name}, {"slave", slave}, {"master", master}});
  }
}

/// One support rotates an obstacle; loads act on obstacles that supports free.
template <int D> void check_obstacles(const Scene<D>& scene) {
  for (int k = 0; k < std::ssize(scene.obstacles); ++k) {
    const Support<D>* turning = nullptr;
    for (const Support<D>& support : scene.supports)
      if (support.rotates && support.acts_on(k)) {
        if (turning) fail("model.scene.rotated_twice", {{"support", support.name}, {"other", turning->name}});
        turning = &support;
      }
  }
  for (const Load& load : scene.loads)
    for (const int k : load.obstacles) {
      const bool moment = load.kind == LoadKind::moment;
      const bool acts = std::ranges::any_of(scene.supports, [&](const Support<D>& support) {
        return support.acts_on(k) && (moment ? support.free_angle : std::ranges::count(support.freed, true) > 0);
      });
      require(acts, moment ? "model.load.no_angle" : "model.load.no_translation", {{"load", load.name}});
    }
}

/// Message code of the constraint of a component.
template <int D> const char* verb(const Support<D>& support, int component) {
  if (support.freed[component] && support.constraint[component] == Constraint::free) return "model.verb.frees";
  if (support.rotates) return "model.verb.turns";
  return support.constraint[component] == Constraint::driven ? "model.verb.drives" : "model.verb.fixes";
}

/// Supports constrain a component of a point once, or all fix it; axes are unit vectors.
template <int D> void check_supports(const Scene<D>& scene) {
  const int control_points = first_control_point(scene, static_cast<int>(scene.bodies.size()));
  const auto points = supported_points(scene, coincident_points(scene));
  std::vector<std::array<const Support<D>*, D>> support_of(control_points + scene.obstacles.size());
  // A rotation does not move points along its axis.
  const auto fixes = [](const Support<D>& support, int c) {
    return support.constraint[c] == Constraint::fixed && (!support.rotates || std::abs(support.axis(c)) == 1);
  };
  for (std::size_t s = 0; s < scene.supports.size(); ++s)
    for (int c = 0; c < D; ++c)
      for (const int point : points[s]) {
        const Support<D>& support = scene.supports[s];
        const bool obstacle = point >= control_points;
        if (!constrains(support, c, obstacle)) continue;
        const Support<D>* const other = std::exchange(support_of[point][c], &support);
        if (other && !(fixes(support, c) && fixes(*other, c)))
          fail(obstacle ? "model.scene.moved_twice" : "model.scene.constrained_twice",
               {{"support", support.name},
                {"verb", Message(verb(support, c))},
                {"component", component_name(c)},
                {"other", other->name},
                {"other_verb", Message(verb(*other, c))}});
      }
  for (const Support<D>& support : scene.supports)
    require(D == 2 || !support.rotates || std::abs(support.axis.norm() - 1) < 1e-9, "model.support.axis",
            {{"support", support.name}});
}

} // namespace

template <int D> const Scene<D>& complete(Scene<D>& scene) {
  check_bodies(scene);
  resolve_joins(scene);
  for (const Join& join : scene.joins) check_join(scene, join);
  for (const Contact<D>& contact : scene.contacts) check_contact(scene, contact);
  for (const Tie& tie : scene.ties) check_tie(scene, tie);
  check_obstacles(scene);
  check_supports(scene);
  set_default_penalties(scene);
  return scene;
}

template const Scene<2>& complete(Scene<2>&);
template const Scene<3>& complete(Scene<3>&);

} // namespace signorini::model
