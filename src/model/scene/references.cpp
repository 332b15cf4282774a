#include "model/scene/references.hpp"

#include "base/error.hpp"
#include "solid/load.hpp"

#include <algorithm>
#include <set>

namespace signorini::model {

namespace {

/// Checks the parts of one scene; `part`: the name of the part that is checked.
template <int D> struct SceneCheck {
  const Scene<D>& scene;
  std::string part;

  void expect(bool ok, const char* what) const { require(ok, "model.archive.part", {{"part", part}, {"what", what}}); }

  const solid::Body<D>& body(int index) const {
    expect(index >= 0 && index < std::ssize(scene.bodies), "a body");
    return *scene.bodies[index].body;
  }
  void obstacle(int index) const { expect(index >= 0 && index < std::ssize(scene.obstacles), "an obstacle"); }
  void obstacles(const std::vector<int>& list) const {
    for (const int index : list) obstacle(index);
  }
  void function(int of_body, int index) const {
    expect(index >= 0 && index < body(of_body).functions(), "a control point");
  }
  void face(const FaceReference& one) const {
    body(one.body);
    expect(one.side.direction >= 0 && one.side.direction < D, "a face");
  }
  void faces(const std::vector<FaceReference>& list) const {
    for (const FaceReference& one : list) face(one);
  }
  void some_faces(const Faces& list) const {
    expect(!list.empty(), "a face");
    faces(list);
  }

  void check(const Support<D>& support) const {
    for (const auto& [of, functions, shape] : support.on) {
      for (const int index : functions) function(of, index);
      expect(shape.empty() == !support.shaped() && (shape.empty() || shape.size() == D * functions.size()), "a shape");
    }
    obstacles(support.obstacles);
    faces(support.spring_faces);
    expect(!support.free_angle || support.rotates, "a free angle");
    expect((support.spring.array() >= 0).all() && (support.obstacle_spring.array() >= 0).all(), "a spring");
  }

  void check(const Load& load) const {
    faces(load.on);
    obstacles(load.obstacles);
    for (const PointShare& point : load.points) function(point.body, point.function);
    const std::size_t components = load.pressure() || load.kind == LoadKind::moment ? 1 : D;
    if (!load.values.empty()) {
      std::size_t points = 0;
      for (const int index : load.bodies) points += body(index).tables().points();
      for (const FaceReference& one : load.on)
        points += static_cast<std::size_t>(solid::face_point_count(body(one.body), one.side));
      expect(load.values.size() == components * points, "values of a load");
    }
    for (const int index : load.bodies) body(index);
    expect(load.start.size() == (load.values.empty() ? components : 1), "the value of a load");
    const bool volume = load.kind == LoadKind::body_force;
    expect(volume ? load.on.empty() && load.points.empty() : load.bodies.empty(), "the place of a load");
    expect(load.on.empty() || load.kind == LoadKind::traction || load.pressure(), "the place of a load");
  }

  void check(const Contact<D>& contact, int number) const {
    some_faces(contact.slave);
    if (const auto* master = std::get_if<Faces>(&contact.master))
      some_faces(*master);
    else
      obstacle(std::get<ObstacleReference>(contact.master).obstacle);
    const int faces = std::ssize(contact.slave);
    for (const auto& [first, second] : contact.apart)
      expect(is_set(contact) && first >= 0 && first <= second && second < faces, "faces of a set");
    constexpr int most_points = 100;
    expect(contact.points >= 1 && contact.points <= most_points, "a number of contact points");
    const int count = std::ssize(scene.contacts);
    const int other = contact.other_pass;
    expect(other == -1 ||
               (other >= 0 && other < count && other != number && scene.contacts[other].other_pass == number &&
                contact.method.pass == contact::Pass::half && std::holds_alternative<Faces>(contact.master)),
           "a half pass");
  }
};

template <class... Lists> void check_names(const Lists&... lists) {
  std::set<std::string> seen;
  const auto add = [&](const auto& list) {
    for (const auto& item : list) require(seen.insert(item.name).second, "model.archive.name", {{"name", item.name}});
  };
  (add(lists), ...);
}

} // namespace

template <int D> void check_references(const Scene<D>& scene) {
  SceneCheck<D> one{scene, {}};
  for (const Support<D>& support : scene.supports) one.part = support.name, one.check(support);
  for (const Load& load : scene.loads) one.part = load.name, one.check(load);
  for (std::size_t k = 0; k < scene.contacts.size(); ++k)
    one.part = scene.contacts[k].name, one.check(scene.contacts[k], static_cast<int>(k));
  for (const Tie& tie : scene.ties) {
    one.part = tie.name;
    one.some_faces(tie.slave);
    one.some_faces(tie.master);
  }
  for (const Join& join : scene.joins) {
    one.part = join.name;
    one.face(join.first);
    one.face(join.second);
  }
  check_names(scene.bodies);
  check_names(scene.supports, scene.loads, scene.contacts);
}

template void check_references(const Scene<2>&);
template void check_references(const Scene<3>&);

} // namespace signorini::model
