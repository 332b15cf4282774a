// Histories carried from the points of one rule to those of another, by place.
#include "contact/gauss/history_transfer.hpp"

#include "contact/couple.hpp"
#include "contact/faces.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace signorini::contact {
namespace history_transfer_test {

using namespace test;

const InterfaceLaw law{100, 50, 0.4};

/// A block above a slab, both with `elements` along the contact; the block's lower face is the slave.
struct Blocks {
  explicit Blocks(int points, int elements, const InterfaceLaw& law = history_transfer_test::law)
      : block(discretize(nurbs::rectangle(2, 1, Eigen::Vector2d(0.5, 1)), {elements, 1}, "N2", "south")),
        slab(discretize(nurbs::rectangle(3, 1, Eigen::Vector2d(0, 0)), {7, 1}, "N2", "north")),
        contact(make_formulation<2>(law, {Surface<2>(block, nurbs::side_of("south", 2)),
                                          Master<2>(Surface<2>(slab, nurbs::side_of("north", 2))), points})),
        accepted(contact->points()), present(accepted), still(2 * slab.functions(), 0.0) {}

  /// The block moves down by 0.01 and along by shift(x).
  template <class Shift> void go(const Shift& shift) {
    std::vector<double> u(2 * block.functions());
    for (int i = 0; i < block.functions(); ++i) {
      u[2 * i] = shift(block.points()(0, i));
      u[2 * i + 1] = -0.01;
    }
    contact->move(u.data(), still.data());
  }
  void evaluate() {
    const Controls controls;
    for (int part = 0; part < contact->parts(); ++part)
      contact->evaluate_part(part, {present, accepted, controls}, false);
    contact->gather({present, accepted, controls}, false);
  }
  void accept() {
    contact->commit(present, accepted, 1);
    accepted = present;
  }
  std::vector<std::size_t> all() const {
    std::vector<std::size_t> numbers(contact->points().size());
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
  }

  nurbs::Discretization block, slab;
  std::unique_ptr<Formulation<2>> contact;
  History<2> accepted, present;
  std::vector<double> still;
};

/// Friction of the points after the block was pressed, moved along by shift(x), and described by other points.
template <class Shift> void carries(const Shift& shift, int points, int elements) {
  Blocks old(9, 5);
  old.go([](double) { return 0.0; });
  old.evaluate();
  old.accept();
  old.go(shift);
  old.evaluate();
  old.accept();
  Blocks now(points, elements);
  now.go(shift);
  recall(memories<2>(*old.contact, old.present, old.all()), *now.contact, now.all(), now.accepted);
  now.present = now.accepted;
  now.evaluate();
  for (std::size_t i = 0; i < now.present.results.size(); ++i) {
    const PointResult<2>& result = now.present.results[i];
    ASSERT_TRUE(touches(result.state));
    EXPECT_NEAR(result.pressure, 1, 0.05);
    // ε_T times the slip, within Coulomb's cone
    const double x = now.contact->points().reference[i](0);
    EXPECT_NEAR(result.friction.norm(), std::min(50 * std::abs(shift(x)), 0.4 * result.pressure), 2e-4) << x;
  }
}

TEST(HistoryTransfer, ConstantTractionStaysConstant) {
  carries([](double) { return 0.004; }, 3, 5);
  carries([](double) { return 0.004; }, 4, 8);
}
TEST(HistoryTransfer, LinearTractionStaysLinear) {
  carries([](double x) { return 0.004 * (x - 0.5); }, 3, 5);
  carries([](double x) { return 0.004 * (x - 0.5); }, 5, 3);
}
TEST(HistoryTransfer, SlidingTractionStaysOnTheCone) {
  carries([](double) { return 0.1; }, 3, 5);
  carries([](double) { return 0.1; }, 4, 8);
}

TEST(HistoryTransfer, OpenPointsBeginWithoutHistory) {
  Blocks old(9, 5), now(3, 5);
  recall(memories<2>(*old.contact, old.accepted, old.all()), *now.contact, now.all(), now.accepted);
  for (const PointHistory<2>& point : now.accepted.points) EXPECT_FALSE(point.slips);
}

TEST(HistoryTransfer, WearIsCarriedAlsoByOpenPoints) {
  symbolic::Graph graph(slip_variables());
  const int rate = graph.constant(0.1);
  InterfaceLaw wearing = law;
  wearing.wear = {make_slip_formula({graph, rate})};
  Blocks old(9, 5, wearing), now(3, 8, wearing);
  for (const std::size_t i : old.all()) old.accepted.points[i].worn = 0.01 * old.contact->points().reference[i](0);
  recall(memories<2>(*old.contact, old.accepted, old.all()), *now.contact, now.all(), now.accepted);
  for (const std::size_t i : now.all())
    EXPECT_NEAR(now.accepted.points[i].worn, 0.01 * now.contact->points().reference[i](0), 1e-10);
}

} // namespace history_transfer_test
} // namespace signorini::contact
