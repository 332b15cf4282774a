// Dead loads: totals are areas, a uniform pressure is self-equilibrated and does the work of the volume.
#include "solid/load.hpp"

#include "solid/bodies.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

namespace signorini::solid {
namespace load_test {

using namespace test;
using nurbs::side_of;
using std::numbers::pi;

const LinearElastic steel = linear_elastic(3, 0.3);

template <int D> double total(const VectorX& load, int component) {
  double sum = 0;
  for (int i = component; i < load.size(); i += D) sum += load(i);
  return sum;
}

template <int D> double volume(const Body<D>& body) {
  double sum = 0;
  for (int e = 0; e < body.elements(); ++e)
    sum = std::accumulate(body.tables().weights_of(e), body.tables().weights_of(e) + body.tables().element(e).points,
                          sum);
  return sum;
}

/// The total of a unit traction is the area, in its direction only and on the face only.
template <int D> void expect_area(const Body<D>& body, const std::string& face, double area) {
  for (int component = 0; component < D; ++component) {
    VectorX load = traction_load(body, side_of(face, D), component);
    for (int c = 0; c < D; ++c)
      EXPECT_NEAR(total<D>(load, c), c == component ? area : 0, 1e-12 * area) << face << " " << c;
    for (int a : body.space().face_functions(side_of(face, D))) load(D * a + component) = 0;
    EXPECT_EQ(load.norm(), 0) << face;
  }
}

TEST(Load, TotalTractionIsTheArea) {
  const nurbs::Patch ring = nurbs::half_annulus(0.3, 0.7, Eigen::Vector2d(2, 1));
  for (const char* label : {"N2", "N2-N4", "N2-N2.2x2"}) {
    const Body<2> body = make_body<2>(ring, {6, 2}, label, "south", steel);
    expect_area<2>(body, "south", pi * 0.7);
    expect_area<2>(body, "north", pi * 0.3);
    expect_area<2>(body, "west", 0.4);
    expect_area<2>(body, "east", 0.4);
  }
  const Body<3> block =
      make_body<3>(nurbs::block({2, 0.5, 0.4}, Eigen::Vector3d(1, 1, 1)), {2, 1, 1}, "N2-N2.1", "back", steel);
  expect_area<3>(block, "back", 1.0);
  expect_area<3>(block, "front", 1.0);
  const Body<3> shell = make_body<3>(nurbs::half_cylinder_shell(0.3, 0.7, 0.5, Eigen::Vector3d(0, 0, 0)), {6, 2, 1},
                                     "N2", "front", steel);
  expect_area<3>(shell, "front", pi * 0.7 * 0.5);
  expect_area<3>(shell, "east", 0.4 * 0.5);
}

/// Area and first moments ∫X dA of a face, from a unit traction.
void expect_moments(const Body<3>& body, const std::string& face, double area, const Vec<3>& moments) {
  const VectorX load = traction_load(body, side_of(face, 3), 0);
  const MatrixX points = body.space().points();
  Vec<3> found = Vec<3>::Zero();
  for (int a = 0; a < body.functions(); ++a) found += load(3 * a) * points.col(a);
  EXPECT_NEAR(total<3>(load, 0), area, 1e-12 * area) << face;
  EXPECT_LT((found - moments).norm(), 1e-12 * (moments.norm() + 1)) << face;
}

TEST(Load, SidesThatCrossALayerAreIntegratedOverBothSpaces) {
  const Vec<3> corner(1, 2, 3), size(2, 0.5, 0.4);
  for (const char* contact : {"back", "south", "east"})
    for (const char* label : {"N2-N2.1", "N2-N2.2x2", "N2-N4"}) {
      const Body<3> block =
          make_body<3>(nurbs::block({size(0), size(1), size(2)}, corner), {3, 3, 3}, label, contact, steel);
      for (int d = 0; d < 3; ++d)
        for (bool at_end : {false, true}) {
          Vec<3> middle = corner + size / 2;
          middle(d) = corner(d) + (at_end ? size(d) : 0);
          const double area = size.prod() / size(d);
          expect_moments(block, nurbs::name_of({d, at_end}), area, area * middle);
        }
      expect_area<3>(block, "west", 0.5 * 0.4);
    }
  const double a = 0.4, b = 0.7, cubes = (b * b * b - a * a * a) / 3;
  const Body<3> octant =
      make_body<3>(nurbs::sphere_octant(a, b, Eigen::Vector3d(0, 0, 0)), {4, 4, 2}, "N2-N2.2", "front", steel);
  const double flat = pi / 4 * (b * b - a * a);
  expect_moments(octant, "front", pi / 2 * b * b, pi / 4 * b * b * b * Vec<3>(1, 1, -1));
  expect_moments(octant, "back", pi / 2 * a * a, pi / 4 * a * a * a * Vec<3>(1, 1, -1));
  expect_moments(octant, "south", flat, cubes * Vec<3>(1, 1, 0));
  expect_moments(octant, "west", flat, cubes * Vec<3>(1, 0, -1));
  expect_moments(octant, "east", flat, cubes * Vec<3>(0, 1, -1));
}

TEST(Load, CollapsedSideCarriesNoLoad) {
  for (const char* label : {"N2", "N2-N2.2"}) {
    const Body<3> octant =
        make_body<3>(nurbs::sphere_octant(0.4, 0.7, Eigen::Vector3d(0, 0, 0)), {2, 2, 1}, label, "front", steel);
    EXPECT_LT(traction_load(octant, side_of("north", 3), 0).norm(), 1e-16);
    EXPECT_LT(pressure_load(octant, side_of("north", 3)).norm(), 1e-16);
  }
}

TEST(Load, TotalTractionOfABodyOfRevolutionIsTheAreaOfTheFullCircle) {
  const auto bowl = revolved(
      make_body<2>(nurbs::quarter_annulus(0.3, 0.7, Eigen::Vector2d(0, 0), 270), {4, 2}, "N2", "south", steel));
  expect_area<2>(*bowl, "south", 2 * pi * 0.7 * 0.7);
  expect_area<2>(*bowl, "north", 2 * pi * 0.3 * 0.3);
  expect_area<2>(*bowl, "east", pi * (0.7 * 0.7 - 0.3 * 0.3));
  const auto tube =
      revolved(make_body<2>(nurbs::rectangle(0.5, 2, Eigen::Vector2d(1, -3)), {2, 3}, "N2-N2.1", "west", steel));
  expect_area<2>(*tube, "west", 2 * pi * 1 * 2);
  expect_area<2>(*tube, "north", pi * (1.5 * 1.5 - 1));
}

/// A pressure on all faces: no resultant except the hoop tension of bodies of revolution, no moment, and by Gauss's
/// theorem −Σ_A f_A·X_A = ∫ X·N dA = 3V in space and for a body of revolution, 2V in the plane.
template <int D> void expect_balance(const Body<D>& body) {
  VectorX load = VectorX::Zero(D * body.functions());
  for (int d = 0; d < D; ++d)
    for (bool at_end : {false, true}) load += pressure_load(body, nurbs::Side{d, at_end});
  const MatrixX points = body.space().points();
  double work = 0;
  Mat<D> moment = Mat<D>::Zero();
  for (int a = 0; a < body.functions(); ++a) {
    work += load.segment<D>(D * a).dot(points.col(a));
    moment += load.segment<D>(D * a) * points.col(a).transpose();
  }
  const bool around = body.kind() == Kind::axisymmetric;
  const double scale = load.cwiseAbs().sum();
  for (int c = around ? 1 : 0; c < D; ++c) EXPECT_LT(std::abs(total<D>(load, c)), 1e-13 * scale);
  if (!around) {
    EXPECT_LT((moment - moment.transpose()).norm(), 1e-13 * scale * points.cwiseAbs().maxCoeff());
  }
  // Accurate to the bulk's quadrature of the volume: the Jacobian of a rational map is not a polynomial.
  EXPECT_NEAR(work, -(around ? 3 : D) * volume(body), 1e-8 * volume(body));
}

/// A patch with displaced points and random weights.
nurbs::Patch distorted(Random& random, nurbs::Patch patch) {
  for (int d = 0; d < patch.parametric_dimension(); ++d) patch = nurbs::elevate(patch, d, 1);
  MatrixX points = patch.points();
  VectorX weights = patch.weights();
  for (int a = 0; a < points.cols(); ++a) {
    for (int i = 0; i < points.rows(); ++i) points(i, a) += uniform(random, -0.05, 0.05);
    weights(a) = uniform(random, 0.9, 1.1);
  }
  return nurbs::make_patch(patch.directions(), points, weights);
}

TEST(Load, PressureOnAllFacesIsSelfEquilibrated) {
  Random random(8);
  for (int trial = 0; trial < 5; ++trial) {
    const Body<2> plane = make_body<2>(distorted(random, nurbs::rectangle(2, 1, Eigen::Vector2d(0.1, 0.3))), {5, 4},
                                       trial % 2 ? "N2-N2.2" : "N3", "south", steel, 3);
    expect_balance<2>(plane);
    expect_balance<2>(*revolved(plane));
    expect_balance<3>(make_body<3>(distorted(random, nurbs::block({1, 1, 0.5}, Eigen::Vector3d(1, 2, 3))), {3, 3, 2},
                                   trial % 2 ? "N3-N4" : "N3", "front", steel, 3));
  }
  for (const char* label : {"N3", "N3-N3.1"})
    expect_balance<3>(
        make_body<3>(nurbs::sphere_octant(0.4, 0.7, Eigen::Vector3d(0, 0, 0)), {4, 4, 2}, label, "front", steel, 3));
  expect_balance<2>(make_body<2>(nurbs::half_annulus(0.3, 0.7, Eigen::Vector2d(1, 2)), {8, 2}, "N3", "south", steel));
}

/// In the reference configuration a follower pressure is the dead one.
template <int D> void expect_dead_at_rest(const Body<D>& body, const std::string& face) {
  const MatrixX points = body.space().points();
  VectorX load = -pressure_load(body, side_of(face, D));
  for (const FacePoints<D>& part : face_points(body, side_of(face, D))) {
    const MatrixX x = points(Eigen::all, part.functions), own = follower_load(part, x);
    for (std::size_t a = 0; a < part.functions.size(); ++a)
      load.segment<D>(D * part.functions[a]) += own.col(static_cast<int>(a));
  }
  EXPECT_LT(load.norm(), 1e-12 * pressure_load(body, side_of(face, D)).norm()) << face;
}

TEST(Load, FollowerPressureAtRestIsTheDeadOne) {
  for (const char* label : {"N2", "N2-N4"}) {
    const Body<2> arc =
        make_body<2>(nurbs::half_annulus(0.3, 0.7, Eigen::Vector2d(2, 1)), {6, 2}, label, "south", steel);
    for (const char* face : {"south", "north", "west", "east"}) {
      expect_dead_at_rest(arc, face);
      expect_dead_at_rest(*revolved(arc), face);
    }
  }
  const Body<3> octant =
      make_body<3>(nurbs::sphere_octant(0.4, 0.7, Eigen::Vector3d(0, 0, 0)), {2, 2, 1}, "N3-N3.1", "front", steel, 3);
  for (const char* face : {"front", "back", "west", "east", "south"}) expect_dead_at_rest(octant, face);
}

TEST(Load, TotalBodyForceIsTheVolume) {
  const Body<2> arc =
      make_body<2>(nurbs::half_annulus(0.3, 0.7, Eigen::Vector2d(2, 1)), {6, 2}, "N2-N4", "south", steel);
  EXPECT_NEAR(total<2>(body_load(arc, 1), 1), pi / 2 * (0.49 - 0.09), 1e-6);
  EXPECT_EQ(total<2>(body_load(arc, 1), 0), 0);
  EXPECT_NEAR(total<2>(body_load(*revolved(arc), 0), 0), volume(*revolved(arc)), 1e-12);
  EXPECT_ERROR(body_load(arc, 2), "solid.load.component: component = 2, most = 1");
}

TEST(Load, UnknownComponentIsAnError) {
  const Body<2> body = make_body<2>(nurbs::rectangle(2, 1, Eigen::Vector2d(0, 0)), {2, 1}, "N2", "south", steel);
  EXPECT_ERROR(traction_load(body, side_of("south", 2), 2), "solid.load.component: component = 2, most = 1");
  EXPECT_ERROR(traction_load(body, side_of("south", 2), -1), "solid.load.component: component = -1, most = 1");
}

} // namespace load_test
} // namespace signorini::solid
