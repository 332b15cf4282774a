// Beyond its open ends a master's face is extended along its tangents, and the traction fades.
#include "contact/couple.hpp"
#include "contact/couple3d.hpp"

#include "nurbs/shapes.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::contact {
namespace open_end_test {

using namespace test;

/// Checks that functions and their derivatives reproduce position and tangents at a located point.
template <int D> void expect_own_functions(const Surface<D>& face, FacePoint<D>& point) {
  face.functions(point, 1);
  Vec<D> sum = Vec<D>::Zero(), slope = Vec<D>::Zero();
  for (int i = 0; i < face.functions_on(point.element); ++i) {
    sum += point.value[static_cast<std::size_t>(i)] * face.points().col(face.nodes(point.element)[i]);
    slope += point.derivative[0][static_cast<std::size_t>(i)] * face.points().col(face.nodes(point.element)[i]);
  }
  EXPECT_LT((sum - point.position).norm(), 1e-12);
  EXPECT_LT((slope - point.tangent[0]).norm(), 1e-11);
}

TEST(OpenEnd, TheFaceIsExtendedAlongItsTangents) {
  Random random(1);
  for (int degree : {1, 2, 3}) {
    const auto plate = wavy_plate(random, 3, 0.1, degree, 3);
    const Surface<3> face = top_of(plate);
    Surface<3> longer = top_of(plate);
    longer.extend(0.3);
    ASSERT_EQ(longer.elements(), (face.direction(0).elements() + 2) * (face.direction(1).elements() + 2));
    FacePoint<3> point, other;
    for (int trial = 0; trial < 40; ++trial) {
      FaceCoordinates<3> xi, nearest;
      for (int a = 0; a < 2; ++a) {
        const auto& knots = longer.direction(a);
        xi(a) = uniform(random, knots.first(), knots.last());
        nearest(a) = std::clamp(xi(a), face.direction(a).first(), face.direction(a).last());
      }
      face.locate(face.find_element(nearest), nearest, 1, point);
      longer.locate(longer.find_element(xi), xi, 2, other);
      expect_own_functions(longer, other);
      const Eigen::Vector2d out = xi - nearest;
      if (out(0) != 0 && out(1) != 0) continue; // at the corners the extensions of both directions meet
      // The extension is straight: x(ξ_end + t) − x_end is parallel to t τ_end, in the same sense.
      const Vec<3> tangent = out(0) * point.tangent[0] + out(1) * point.tangent[1],
                   way = other.position - point.position;
      EXPECT_LE(way.cross(tangent).norm(), 1e-12 * tangent.norm());
      EXPECT_GE(way.dot(tangent), 0);
    }
  }
}

TEST(OpenEnd, AnArcIsExtendedAlongItsTangents) {
  const double h = std::sqrt(0.5);
  MatrixX points(2, 3);
  points << 1, 1, 0, 0, 1, 1;
  Surface<2> arc(nurbs::make_patch({nurbs::KnotVector(2, {0, 0, 0, 1, 1, 1})}, points, Eigen::Vector3d(1, h, 1)));
  arc.extend(0.3);
  ASSERT_EQ(arc.elements(), 3);
  FacePoint<2> point;
  for (double t : {1e-9, 0.1, 0.3}) {
    arc.locate(0, FaceCoordinates<2>(-t), 2, point); // below (1, 0)
    EXPECT_NEAR(point.position(0), 1, 1e-14);
    EXPECT_LT(point.position(1), 0);
    EXPECT_NEAR(point.tangent[0](0), 0, 1e-14);
    expect_own_functions(arc, point);
    arc.locate(2, FaceCoordinates<2>(1 + t), 2, point); // to the left of (0, 1)
    EXPECT_LT(point.position(0), 0);
    EXPECT_NEAR(point.position(1), 1, 1e-14);
    expect_own_functions(arc, point);
  }
}

TEST(OpenEnd, WeightsStayPositive) {
  MatrixX points(2, 3);
  points << 1, 0.5, 0, 0, 1, 0;
  Surface<2> spike(nurbs::make_patch({nurbs::KnotVector(2, {0, 0, 0, 1, 1, 1})}, points, Eigen::Vector3d(1, 4, 1)));
  spike.extend(0.3); // on which the weight would fall to 1 + 2 · 0.3 (1 − 4) < 0
  FacePoint<2> point, end;
  spike.locate(0, FaceCoordinates<2>(spike.direction(0).first()), 1, point);
  spike.locate(1, FaceCoordinates<2>(0), 1, end);
  EXPECT_LT(spike.direction(0).first(), 0);
  EXPECT_GT((end.position - point.position).dot(end.tangent[0]), 0);
}

TEST(OpenEnd, SeamsAndPolesAreNotOpen) {
  // A closed square
  MatrixX points(2, 5);
  points << 0, 1, 1, 0, 0, 0, 0, 1, 1, 0;
  const nurbs::KnotVector knots(1, {0, 0, 1, 2, 3, 4, 4});
  Surface<2> square(nurbs::make_patch({knots}, points, VectorX::Ones(5)));
  square.extend(0.2);
  EXPECT_EQ(square.direction(0).breaks(), knots.breaks());

  nurbs::Plan plan;
  plan.elements = {2, 2, 1};
  plan.contact = {nurbs::side_of("front", 3)};
  plan.labels.assign(2, nurbs::parse_label("N2"));
  const nurbs::Discretization octant(nurbs::sphere_octant(0.5, 1, Vec<3>(0, 0, 0)), plan);
  Surface<3> ball(octant, nurbs::side_of("front", 3));
  const double equator = ball.direction(1).first(), pole = ball.direction(1).last(), west = ball.direction(0).first();
  ball.extend(0.2);
  EXPECT_EQ(ball.direction(1).last(), pole);
  EXPECT_LT(ball.direction(1).first(), equator);
  EXPECT_LT(ball.direction(0).first(), west);
}

TEST(OpenEnd, TheFadeDecreasesFromOneToZeroWithContinuousSlope) {
  Random random(2);
  Surface<3> face = top_of(wavy_plate(random, 3, 0.1, 2, 3));
  std::array<double, 2> from, to;
  for (int a = 0; a < 2; ++a) from[static_cast<std::size_t>(a)] = face.direction(a).first();
  face.extend(0.4, 0.2);
  for (int a = 0; a < 2; ++a) to[static_cast<std::size_t>(a)] = face.direction(a).first();
  FaceCoordinates<3> rate, unused;
  EXPECT_EQ(face.sheet_data().extension.fade({from[0] + 1e-9, from[1]}, rate), 1);
  EXPECT_EQ(rate, Eigen::Vector2d(0, 0));
  EXPECT_NEAR(face.sheet_data().extension.fade({(from[0] + to[0]) / 2, from[1]}, rate), 0.5, 1e-14);
  EXPECT_NEAR(face.sheet_data().extension.fade({(from[0] + to[0]) / 2, (from[1] + to[1]) / 2}, rate), 0.25, 1e-14);
  EXPECT_NEAR(face.sheet_data().extension.fade({to[0], from[1]}, rate), 0, 1e-15);
  EXPECT_NEAR(rate.norm(), 0, 1e-12);
  for (int trial = 0; trial < 20; ++trial) {
    FaceCoordinates<3> xi;
    for (int a = 0; a < 2; ++a) {
      const double beyond = face.direction(a).last();
      xi(a) = uniform(random, 0, 1) < 0.5
                  ? uniform(random, to[static_cast<std::size_t>(a)], beyond)
                  : uniform(random, to[static_cast<std::size_t>(a)], from[static_cast<std::size_t>(a)]);
    }
    face.sheet_data().extension.fade(xi, rate);
    for (int a = 0; a < 2; ++a)
      EXPECT_NEAR(
          signorini::test::derivative<double>(
              [&](double h) { return face.sheet_data().extension.fade(xi + h * FaceCoordinates<3>::Unit(a), unused); },
              1e-6),
          rate(a), 1e-7);
  }
}

/// Number of touching points beyond the slab's end, x = 3.
template <int D> int beyond(const Pair<D>& pair, double end = 3) {
  int count = 0;
  for (const auto& point : pair.results())
    count += point.state != ContactState::open && point.area > 0 && point.position(0) > end;
  return count;
}

TEST(OpenEnd, TangentIsTheForcesDerivative) {
  Census sum;
  unsigned seed = 40;
  int past = 0;
  for (const char* label : {"N4", "N2-N2.2", "L1"})
    for (double mu : {0.0, 0.3})
      for (bool revolved : {false, true}) {
        Couple couple("N2", slab(label), InterfaceLaw{100, 80, mu}, 2.95, 1.0, revolved);
        Random random(++seed);
        couple.shake(random, 0.001).touch().move_die(0, -0.06);
        for (double drag : {0.0, 3e-4, 0.03, 0.1}) {
          couple.move_die(drag, 0).shake(random, 0.0005);
          compare_with_differences(couple, sum);
          past += beyond(couple.pair);
          couple.pair.accept();
        }
      }
  sum.expect({.states = 30});
  EXPECT_GT(past, 60);
  EXPECT_GT(sum.stick, 100);
  EXPECT_GT(sum.slip, 100);
}

TEST(OpenEnd, PointsThatWaitBeyondAnEndTouchWhenTheyArrive) {
  // A die that wanders about the end of a slab, in small steps and leaps; a contact without memory projects all points.
  Random random(11);
  int waiting = 0, touching = 0;
  for (const double lift : {0.0, 0.3}) {
    Couple couple("N2", slab("N2"), InterfaceLaw{100, 80, 0}, 3.2, 1 + lift);
    const Couple start = couple;
    for (int step = 0; step < 60; ++step) {
      const double size = step % 5 == 0 ? 0.2 : 0.02;
      couple.move_die(uniform(random, -size, size), uniform(random, -size, size) - 0.05 * lift).shake(random, 0.002);
      couple.evaluate();
      Couple fresh = start;
      fresh.evaluate(couple.u);
      const History<2>& history = couple.pair.present();
      for (std::size_t i = 0; i < history.points.size(); ++i) {
        const PointResult<2>&own = history.results[i], &expected = fresh.pair.results()[i];
        EXPECT_EQ(own.state, expected.state);
        EXPECT_NEAR(own.pressure, expected.pressure, 1e-10);
        waiting += own.beyond;
        touching += own.state != ContactState::open;
      }
    }
  }
  EXPECT_GT(waiting, 500);
  EXPECT_GT(touching, 100);
}

/// The end of a slab bends up: points beyond it, 0.6 away, are behind it then, although nothing moved that far.
TEST(OpenEnd, PointsBeyondAnEndAreFoundBehindItWhenItTurns) {
  const nurbs::Discretization fine = discretize(nurbs::rectangle(3, 1, Eigen::Vector2d(0, 0)), {30, 3}, "N2", "north");
  Couple couple("N2", fine, InterfaceLaw{100, 80, 0}, 4, 1);
  const Couple start = couple;
  couple.evaluate();
  for (const auto& point : couple.pair.results()) EXPECT_EQ(point.state, ContactState::open);
  const Eigen::Vector2d hinge(2.8, 1);
  const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(1.4).toRotationMatrix();
  const MatrixX points = fine.points();
  for (int i = 0; i < fine.functions(); ++i) {
    const Eigen::Vector2d arm = points.col(i) - hinge;
    if (arm(0) > 0 && arm(1) > -0.01) couple.u.segment<2>(couple.die_dofs() + 2 * i) = rotation * arm - arm;
  }
  couple.evaluate();
  Couple fresh = start;
  fresh.evaluate(couple.u);
  int behind = 0;
  for (std::size_t i = 0; i < couple.pair.results().size(); ++i) {
    const PointResult<2>&own = couple.pair.results()[i], &expected = fresh.pair.results()[i];
    EXPECT_EQ(own.state, expected.state);
    EXPECT_NEAR(own.pressure, expected.pressure, 1e-10 * expected.pressure);
    behind += expected.state != ContactState::open;
  }
  EXPECT_GT(behind, 10);
}

/// Points of a master on an even grid of each of its elements.
template <int D> std::vector<Vec<D>> samples(const Master<D>& master) {
  const Surface<D>& face = *master.surface();
  std::vector<Vec<D>> list;
  FacePoint<D> point;
  for (int e = 0; e < face.elements(); ++e)
    for (int k = 0; k < (D == 2 ? 5 : 25); ++k) {
      FaceCoordinates<D> xi;
      for (int a = 0; a < D - 1; ++a) {
        const auto [from, to] = face.interval(e, a);
        xi(a) = from + (to - from) * (a == 0 ? k % 5 : k / 5) / 4;
      }
      face.locate(e, xi, 0, point);
      list.push_back(point.position);
    }
  return list;
}

/// Deforms a face at random; returns how often a point of it moved farther than all control points.
template <int D> int check_bound(const Surface<D>& face, Random& random) {
  Master<D> master(face);
  int last = 0, farther = 0;
  for (int i = 0; i < face.functions(); ++i) last = std::max(last, face.body_function(i));
  VectorX before = VectorX::Zero(D * (last + 1)), after = before;
  for (int trial = 0; trial < 20; ++trial, before = after) {
    const std::vector<Vec<D>> old = samples(master);
    for (double& u : after) u = uniform(random, -0.1, 0.1);
    const double bound = master.move(after.data());
    const std::vector<Vec<D>> now = samples(master);
    double farthest = 0, of_controls = 0;
    for (std::size_t i = 0; i < now.size(); ++i) farthest = std::max(farthest, (now[i] - old[i]).norm());
    for (int i = 0; i < face.functions(); ++i) {
      const int f = D * face.body_function(i);
      of_controls = std::max(of_controls, (after - before).template segment<D>(f).norm());
    }
    EXPECT_LE(farthest, bound * (1 + 1e-12));
    farther += farthest > of_controls;
  }
  return farther;
}

TEST(OpenEnd, MovesOfTheExtensionAreBounded) {
  // It is extrapolated: bending of the end moves it farther than any control point.
  Random random(8);
  int farther = check_bound(Surface<2>(slab("N2"), nurbs::side_of("north", 2)), random);
  farther += check_bound(top_of(wavy_plate(random, 3, 0.1, 2, 3)), random);
  EXPECT_GT(farther, 10);
}

TEST(OpenEnd, TangentIsTheForcesDerivativeWithAdhesionAndOnRigidCurves) {
  MatrixX points(2, 3);
  points << 4, 2, 0, 0.95, 1.02, 0.95;
  const nurbs::Patch curve = nurbs::make_patch({nurbs::KnotVector(2, {0, 0, 0, 1, 1, 1})}, points, VectorX::Ones(3));
  Census sum;
  Random random(7);
  for (int round = 0; round < 4; ++round) {
    std::vector<Couple> couples;
    couples.emplace_back("N2-N2.1", slab("N2"), adhesive({0.02, 0.05}), 2.9, 1.02);
    couples.emplace_back("N2", Obstacle<2>(curve), InterfaceLaw{100, 80, 0.3}, 3.95, 1.0);
    for (Couple& couple : couples) {
      couple.touch().move_die(0.02 * round, -0.02 * round).shake(random, 0.002);
      compare_with_differences(couple, sum);
    }
  }
  sum.expect({.states = 6});
}

TEST(OpenEnd, TangentIsTheForcesDerivativeIn3D) {
  Census sum;
  Random random(3);
  int past = 0;
  for (double mu : {0.0, 0.3})
    for (const Vec<3>& at : {Vec<3>(2.9, 1.5, 0.1), Vec<3>(2.9, 2.9, 0.1)}) { // at an edge, at a corner
      Couple3 couple("N2", wavy_plate(random, 3, 0.02, 2, 4), InterfaceLaw{100, 80, mu}, at);
      couple.touch().move_die({0, 0, -0.05});
      for (const Vec<3>& drag : {Vec<3>(0, 0, 0), Vec<3>(3e-4, 1e-4, 0), Vec<3>(0.03, 0.02, 0)}) {
        couple.move_die(drag).shake(random, 0.0005);
        compare_with_differences(couple, random, sum);
        past += beyond(couple.pair);
        couple.pair.accept();
      }
    }
  sum.expect({.states = 8});
  EXPECT_GT(past, 20);
}

/// Largest change of the force between steps while the die is dragged off the slab's end.
double largest_jump(int steps) {
  Couple couple("N2", slab("N2"), InterfaceLaw{100, 100, 0}, 2.8, 0.95);
  double jump = 0;
  Vec<2> before = Vec<2>::Zero();
  for (int step = 0; step <= steps; ++step, couple.move_die(0.6 / steps, 0)) {
    couple.evaluate();
    const Vec<2> force = couple.pair.resultant().force;
    if (step > 0) jump = std::max(jump, (force - before).norm());
    before = force;
  }
  EXPECT_EQ(before.norm(), 0); // beyond the extension
  return jump;
}

TEST(OpenEnd, TheForceIsContinuousWhilePointsPassTheEnd) {
  EXPECT_LT(largest_jump(4000), 0.6 * largest_jump(2000));
}

TEST(OpenEnd, ForcesAndMomentsBalance) {
  Couple couple("N2", slab("N3"), InterfaceLaw{100, 100, 0}, 3.0, 0.95);
  couple.evaluate();
  EXPECT_GT(beyond(couple.pair), 0);
  const VectorX force = couple.dense().force;
  Vec<2> sum = Vec<2>::Zero();
  double moment = 0;
  const auto add = [&](const MatrixX& points, int offset) {
    for (int i = 0; i < points.cols(); ++i) {
      const Vec<2> f = force.segment<2>(offset + 2 * i),
                   x = Vec<2>(points.col(i)) + couple.u.segment<2>(offset + 2 * i);
      sum += f;
      moment += x(0) * f(1) - x(1) * f(0);
    }
  };
  add(couple.die.points(), 0);
  add(couple.base->points(), couple.die_dofs());
  EXPECT_LT(sum.norm(), 1e-13 * force.norm());
  EXPECT_LT(std::abs(moment), 1e-12 * force.norm());
}

} // namespace open_end_test
} // namespace signorini::contact
