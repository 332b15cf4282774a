// Saved models: bitwise equal results after any history; invalid files.
#include "model/files/checkpoint.hpp"

#include "model/scenes.hpp"
#include "os/archive.hpp"
#include "scratch.hpp"
#include "text_of.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace signorini::model {
namespace checkpoint_test {

using namespace test;
using signorini::test::message_of;
using signorini::test::ScratchFolder;

template <class Matrix> bool same_bits(const Matrix& a, const Matrix& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

/// All results of a state as one list of numbers.
template <int D> VectorX seen(Model<D>& model) {
  std::vector<double> numbers(model.present.displacement.begin(), model.present.displacement.end());
  const auto append = [&](const auto& values) { numbers.insert(numbers.end(), values.begin(), values.end()); };
  for (std::size_t s = 0; s < model.system.scene.supports.size(); ++s) append(reaction(model, static_cast<int>(s)));
  for (std::size_t k = 0; k < model.system.contacts.size(); ++k) {
    append(gaps(*model.system.contacts[k], model.present.contacts[k]));
    for (const auto& result : model.present.contacts[k].results) {
      append(result.position);
      append(result.friction);
      append(result.force);
      append(result.tangents.reshaped());
      append(std::array{result.gap, result.pressure, result.area, result.potential, 1.0 * int(result.state)});
    }
  }
  const Energies energy = energies(model);
  append(std::array{energy.stored, energy.contact, energy.friction, energy.work, last_length(model)});
  return Eigen::Map<VectorX>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

/// Steps of the ironing path, larger than published, so that the contact area grows quickly.
void iron(Model<2>& model, int from, int to, const StepOptions& options = {}) {
  for (int step = from; step <= to; ++step) {
    const double press = std::min(step, 5) / 5.0, slide = std::max(step - 5, 0) / 44.0;
    const auto report = step_to(model, drive_of_grip, 1.5 * slide, -0.15 * press, options);
    ASSERT_EQ(report.outcome, solve::Outcome::converged) << step << ": " << text_of(report.messages);
    accept(model);
  }
}

std::shared_ptr<Model<2>> load_plane(const std::string& file) {
  return std::get<std::shared_ptr<Model<2>>>(load(file));
}

TEST(Rollback, RestoresTheAcceptedStateBitwise) {
  Model<2> model(ironing("N2"));
  iron(model, 1, 9);
  const VectorX before = seen(model);
  const double target = accepted_target(model, drive_of_grip, 0);
  ASSERT_GT(resultant(model.present.contacts[0]).slipping, 0);
  StepOptions hasty;
  hasty.newton.iterations = 2;
  for (const double far : {0.3, 3.0}) {
    EXPECT_NE(step_to(model, drive_of_grip, far, -0.15, hasty).outcome, solve::Outcome::converged);
    EXPECT_FALSE(same_bits(seen(model), before));
    rollback(model);
    EXPECT_TRUE(same_bits(seen(model), before));
    EXPECT_EQ(accepted_target(model, drive_of_grip, 0), target);
  }
  const Snapshot<2> saved = snapshot(model);
  iron(model, 10, 12);
  restore(model, saved);
  EXPECT_TRUE(same_bits(seen(model), before));
}

/// A failed attempt leaves no trace, also without another attempt.
TEST(Rollback, AcceptingAfterwardsChangesNothing) {
  Model<2> model(ironing("N2"));
  iron(model, 1, 5);
  StepOptions hasty;
  hasty.newton.iterations = 2;
  EXPECT_NE(step_to(model, drive_of_grip, 3, -0.15, hasty).outcome, solve::Outcome::converged);
  rollback(model);
  const VectorX force = reaction(model, grip);
  const double work = energies(model).work;
  accept(model);
  rollback(model);
  EXPECT_TRUE(same_bits(VectorX(reaction(model, grip)), force));
  EXPECT_EQ(energies(model).work, work);
}

TEST(Checkpoint, TheSavedAndTheLoadedModelContinueBitwiseEqual) {
  const ScratchFolder folder;
  for (const auto linear : {solve::LinearKind::automatic, solve::LinearKind::umfpack, solve::LinearKind::reuse}) {
    StepOptions options;
    options.linear = linear;
    Model<2> model(ironing("N2-N2.1")), undisturbed(ironing("N2-N2.1"));
    iron(model, 1, 8, options);
    iron(undisturbed, 1, 14, options);
    const VectorX before = seen(model);
    save(model, folder.file("a.sgn"), "a text");
    EXPECT_TRUE(same_bits(seen(model), before));
    const auto loaded = load_plane(folder.file("a.sgn"));
    EXPECT_TRUE(same_bits(seen(*loaded), before));
    EXPECT_EQ(load_text(folder.file("a.sgn")), "a text");
    iron(model, 9, 14, options);
    iron(*loaded, 9, 14, options);
    EXPECT_TRUE(same_bits(seen(model), seen(*loaded)));
    // This requires settling: otherwise rounding error depends on the past.
    EXPECT_FALSE(same_bits(seen(model), seen(undisturbed)));
    EXPECT_LT((model.present.displacement - undisturbed.present.displacement).norm(), 1e-9);
  }
}

/// Failed attempts, other states and other solvers before a restore leave no trace.
TEST(Checkpoint, RestoredModelsAreIndependentOfTheirPast) {
  const ScratchFolder folder;
  Model<2> model(ironing("N2"));
  auto restored = std::make_shared<Model<2>>(ironing("N2"));
  Model<2>& other = *restored;
  iron(model, 1, 8);
  save(model, folder.file("a.sgn"));
  StepOptions reuse, hasty;
  reuse.linear = solve::LinearKind::reuse;
  hasty.newton.iterations = 2;
  iron(other, 1, 20, reuse);
  EXPECT_NE(step_to(other, drive_of_grip, 3, -0.15, hasty).outcome, solve::Outcome::converged);
  restore(restored, folder.file("a.sgn"));
  iron(model, 9, 14);
  iron(other, 9, 14);
  EXPECT_TRUE(same_bits(seen(model), seen(other)));
}

TEST(Checkpoint, ARegionKeepsItsPoints) {
  const ScratchFolder folder;
  Scene<2> scene = ironing("N2");
  scene.contacts[0].where = [](const Vec<2>& x) { return x(0) < 0.8; };
  Model<2> model(scene);
  iron(model, 1, 7);
  save(model, folder.file("a.sgn"));
  const auto loaded = load_plane(folder.file("a.sgn"));
  ASSERT_LT(loaded->present.contacts[0].results.size(), Model<2>(ironing("N2")).present.contacts[0].results.size());
  iron(model, 8, 9);
  iron(*loaded, 8, 9);
  EXPECT_TRUE(same_bits(seen(model), seen(*loaded)));
}

TEST(Checkpoint, NamesThePartsOfAnotherScene) {
  const ScratchFolder folder;
  const std::string file = folder.file("a.sgn");
  Model<2> model(ironing("N2"));
  iron(model, 1, 2);
  save(model, file);
  const auto refused = [&](const auto& change) {
    Scene<2> scene = ironing("N2");
    change(scene);
    auto other = std::make_shared<Model<2>>(std::move(scene));
    iron(*other, 1, 1);
    const VectorX before = seen(*other);
    const std::string message = message_of([&] { restore(other, file); });
    EXPECT_EQ(same_bits(seen(*other), before), message != "no error");
    return message;
  };
  const auto holds = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  EXPECT_EQ(refused([](Scene<2>&) {}), "no error");
  holds(refused([](Scene<2>& s) { s.contacts[0].points = 5; }), "differences = (contact 'interface')");
  holds(refused([](Scene<2>& s) {
          s.contacts[0].method = contact::InterfaceLaw{100, 100, 0.3};
        }),
        "contact 'interface'");
  holds(refused([](Scene<2>& s) { s.supports[0].name = "base"; }), "differences = (support 'bed', support 'base')");
  holds(refused([](Scene<2>& s) {
          s.bodies[1].body =
              std::make_shared<const solid::Body<2>>(s.bodies[1].body->shared_space(), solid::neo_hookean(1, 0.29));
        }),
        "differences = (body 'slab')");
  holds(refused([](Scene<2>& s) { s = ironing("N2-N3"); }), "body 'die', body 'slab'");
}

TEST(Checkpoint, FilesOfAnotherKindAreErrors) {
  const ScratchFolder folder;
  write_archive(folder.file("a"), {"something else", 1, 1}, {});
  EXPECT_NE(message_of([&] { load(folder.file("a")); }).find("os.archive.kind"), std::string::npos);
  write_archive(folder.file("b"), {"checkpoint", 99, 99}, {});
  EXPECT_NE(message_of([&] {
              load(folder.file("b"));
            }).find("os.archive.newer: file = " + folder.file("b") + ", written = 99"),
            std::string::npos);
  write_archive(folder.file("c"), {"checkpoint", 2, 2}, {});
  EXPECT_NE(message_of([&] { load(folder.file("c")); }).find("os.archive.older"), std::string::npos);
}

} // namespace checkpoint_test
} // namespace signorini::model
