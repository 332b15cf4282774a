// Checkpoints whose checksum is right, but not their contents: each is an error or a model, never a crash.
#include "model/files/checkpoint.hpp"
#include "model/scene/references.hpp"
#include "model/scenes.hpp"
#include "os/archive.hpp"
#include "os/whole_file.hpp"
#include "scratch.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace signorini::model {
namespace damaged_checkpoint_test {

using namespace test;
using signorini::test::message_of;
using signorini::test::ScratchFolder;

/// Two small blocks in contact with friction.
Scene<2> blocks() {
  Scene<2> scene;
  const solid::Material soft = solid::neo_hookean(1, 0.3);
  scene.bodies.push_back(
      {"upper", make_body(nurbs::rectangle(1, 0.5, Eigen::Vector2d(0.5, 0)), {1, 1}, "N2", "south", soft)});
  scene.bodies.push_back(
      {"lower", make_body(nurbs::rectangle(2, 0.5, Eigen::Vector2d(0, -0.5)), {2, 1}, "N2-N2.1", "north", soft)});
  scene.supports.push_back({"bed", {face_points(scene, 1, "south")}, {Constraint::fixed, Constraint::fixed}});
  scene.supports.push_back({"grip", {face_points(scene, 0, "north")}, {Constraint::driven, Constraint::driven}});
  scene.loads.push_back({"wind", {{0, nurbs::side_of("west", 2)}}, LoadKind::traction, {0.001, 0}});
  scene.contacts.push_back({"touch",
                            {0, nurbs::side_of("south", 2)},
                            FaceReference{1, nurbs::side_of("north", 2)},
                            contact::InterfaceLaw{10, 10, 0.2},
                            4});
  return scene;
}

/// The file with another checksum, that of its bytes.
void correct(std::string& bytes) {
  ArchiveWriter sum;
  const std::size_t body = bytes.size() - sizeof(std::uint64_t);
  sum.put(checksum(std::string_view(bytes).substr(0, body)));
  bytes.replace(body, sizeof(std::uint64_t), sum.bytes());
}

template <class T> void overwrite(std::string& bytes, std::size_t place, const T& value) {
  std::memcpy(bytes.data() + place, &value, sizeof value);
}

TEST(DamagedCheckpoint, IsAnErrorOrAModel) {
  const ScratchFolder folder;
  const std::string file = folder.file("a");
  Model<2> model(blocks());
  for (const double depth : {-0.01, -0.02}) {
    ASSERT_EQ(step_to(model, drive_of_grip, 0.5 * depth, depth).outcome, solve::Outcome::converged);
    accept(model);
  }
  save(model, file);
  const std::string good = read_file(file);
  const std::size_t head = std::strlen("SIGNORINI checkpoint\n") + 12;
  int errors = 0, models = 0;
  for (std::size_t place = head; place + 16 < good.size(); place += 11) {
    std::string bytes = good;
    switch (place % 5) {
    case 0:
      overwrite(bytes, place, 0xffffffffu);
      break;
    case 1:
      overwrite(bytes, place, std::numeric_limits<double>::quiet_NaN());
      break;
    case 2:
      overwrite(bytes, place, 0x7fffffff);
      break;
    case 3:
      overwrite(bytes, place, 1e300);
      break;
    default:
      bytes[place] = static_cast<char>(bytes[place] + 1);
    }
    correct(bytes);
    write_record(file, bytes);
    const std::string message = message_of([&] {
      const auto loaded = std::get<0>(load(file));
      EXPECT_TRUE(loaded->present.displacement.allFinite() && loaded->present.force.allFinite()) << place;
    });
    ++(message == "no error" ? models : errors);
  }
  EXPECT_GT(errors, 100);
  EXPECT_GT(models, 20);
}

/// A file of a few hundred bytes can describe a body that fills the memory.
TEST(DamagedCheckpoint, HasNoMoreElementsThanItsStateHasNumbers) {
  const ScratchFolder folder;
  const std::string file = folder.file("a");
  Model<2> model(blocks());
  save(model, file);
  std::string bytes = read_file(file);
  std::string list(16, '\0'); // the elements of the lower body, which is stored by its recipe: two numbers
  const auto lower = bytes.find("lower");
  overwrite(list, 0, std::uint64_t(2));
  overwrite(list, 8, 2);
  overwrite(list, 12, 1);
  const auto place = bytes.find(list, lower);
  ASSERT_NE(place, std::string::npos);
  overwrite(bytes, place + 8, 30000);
  overwrite(bytes, place + 12, 30000);
  correct(bytes);
  write_record(file, bytes);
  EXPECT_NE(message_of([&] { load(file); }).find("nurbs.archive.elements"), std::string::npos);
}

TEST(DamagedScene, RefersToPartsThatItHas) {
  const nurbs::Side side = nurbs::side_of("west", 2);
  using Damage = void (*)(Scene<2>&);
  EXPECT_NO_THROW(check_references(blocks()));
  for (const Damage damage : {
           Damage([](Scene<2>& scene) { scene.supports[0].on[0].body = 2; }),
           Damage([](Scene<2>& scene) { scene.supports[0].on[0].functions[0] = 1000; }),
           Damage([](Scene<2>& scene) { scene.supports[0].on[0].shape = {1}; }),
           Damage([](Scene<2>& scene) { scene.supports[0].obstacles = {0}; }),
           Damage([](Scene<2>& scene) { scene.supports[0].spring(0) = -1; }),
           Damage([](Scene<2>& scene) { scene.supports[1].name = "bed"; }),
           Damage([](Scene<2>& scene) { scene.loads[0].on[0].body = -1; }),
           Damage([](Scene<2>& scene) { scene.loads[0].on[0].side.direction = 2; }),
           Damage([](Scene<2>& scene) { scene.loads[0].start = {1}; }),
           Damage([](Scene<2>& scene) {
             scene.loads[0].values = {1, 2, 3};
           }),
           Damage([](Scene<2>& scene) { scene.loads[0].kind = LoadKind::body_force; }),
           Damage([](Scene<2>& scene) { scene.loads[0].obstacles = {0}; }),
           Damage([](Scene<2>& scene) { scene.contacts[0].slave = {}; }),
           Damage([](Scene<2>& scene) { scene.contacts[0].master = ObstacleReference{0}; }),
           Damage([](Scene<2>& scene) { scene.contacts[0].points = 101; }),
           Damage([](Scene<2>& scene) { scene.contacts[0].other_pass = 0; }),
       }) {
    Scene<2> scene = blocks();
    damage(scene);
    EXPECT_NE(message_of([&] { check_references(scene); }).find("model.archive."), std::string::npos);
  }
  Scene<2> tied = blocks();
  tied.ties.push_back({"seam", {3, side}, {0, side}, contact::MultiplierSpace::equal});
  EXPECT_THROW(check_references(tied), Error);
}

} // namespace damaged_checkpoint_test
} // namespace signorini::model
