// Collapsed edges and closed seams: coincident functions are grouped, others are not.
#include "nurbs/coincident.hpp"

#include "nurbs/random_patch.hpp"
#include "nurbs/shapes.hpp"

#include <gtest/gtest.h>

#include <set>

namespace signorini::nurbs {
namespace coincident_test {

using Groups = std::vector<std::vector<int>>;

Discretization discretize(const Patch& patch, const std::string& label, const std::vector<std::string>& contact,
                          int finer = 1) {
  const int dimensions = patch.parametric_dimension();
  Plan plan;
  for (int d = 0; d < dimensions; ++d) plan.elements.push_back(patch.direction(d).elements() + finer);
  for (const std::string& face : contact) plan.contact.push_back(side_of(face, dimensions));
  if (!contact.empty()) plan.thickness_degree = patch.direction(plan.contact.front().direction).degree();
  plan.labels.assign(static_cast<std::size_t>(contact.empty() ? dimensions : dimensions - 1), parse_label(label));
  return {patch, plan};
}

/// A random displacement of the control points, equal within each group.
MatrixX random_displacement(test::Random& random, const Discretization& space, const Groups& groups) {
  MatrixX u = MatrixX::NullaryExpr(space.dimension(), space.functions(), [&] { return test::uniform(random, -1, 1); });
  for (const auto& group : groups)
    for (int function : group) u.col(function) = u.col(group.front());
  return u;
}

struct Sample {
  VectorX place, displacement;
};

/// Lattice points on all sides: positions and displacements.
std::vector<Sample> sample_sides(const Patch& patch, const Discretization& space, const MatrixX& u) {
  constexpr int steps = 7;
  const int dimensions = patch.parametric_dimension();
  std::vector<Sample> samples;
  const int total = dimensions == 2 ? steps * steps : steps * steps * steps;
  for (int n = 0; n < total; ++n) {
    VectorX xi(dimensions);
    bool on_side = false;
    for (int d = 0, rest = n; d < dimensions; ++d, rest /= steps) {
      const int i = rest % steps;
      on_side = on_side || i == 0 || i == steps - 1;
      const KnotVector& knots = patch.direction(d);
      xi(d) = i == steps - 1 ? knots.last() : knots.first() + (knots.last() - knots.first()) * i / (steps - 1);
    }
    if (!on_side) continue;
    const ElementBasis basis = space.basis(space.find_element(xi), xi);
    Sample sample{evaluate(patch, xi), VectorX::Zero(space.dimension())};
    for (std::size_t a = 0; a < basis.functions.size(); ++a)
      sample.displacement += basis.values(static_cast<int>(a)) * u.col(basis.functions[a]);
    samples.push_back(std::move(sample));
  }
  return samples;
}

/// The largest gap that opens between two parameters of the same point.
double tear(const Patch& patch, const Discretization& space, const MatrixX& u) {
  double widest = 0;
  const auto samples = sample_sides(patch, space, u);
  for (const Sample& a : samples)
    for (const Sample& b : samples)
      if ((a.place - b.place).norm() < 1e-10) widest = std::max(widest, (a.displacement - b.displacement).norm());
  return widest;
}

Patch upright(const Patch& plane) {
  return transform(plane, (MatrixX(3, 2) << 1, 0, 0, 0, 0, 1).finished(), Vec<3>::Zero());
}

/// A unit block with moved corners: `moves` lists corner (bits x y z) and position.
Patch bent_block(const std::vector<std::pair<int, Vec<3>>>& moves) {
  MatrixX corners = block({1, 1, 1}, Vec<3>(0, 0, 0)).points();
  for (const auto& [corner, place] : moves) corners.col(corner) = place;
  const KnotVector knots = KnotVector::single(1);
  return make_patch({knots, knots, knots}, corners);
}

struct Folded {
  std::string name;
  Patch patch;
};

std::vector<Folded> folded_patches() {
  const Vec<3> origin(0, 0, 0), z(0, 0, 1);
  const Patch meridian = upright(rectangle(1, 2, Vec<2>(0, 0)));
  return {
      {"ring", ruled(circle(Vec<2>(1, 2), 2), circle(Vec<2>(1, 2), 1))},
      {"sector", ruled(arc(Vec<2>(0, 0), 1, 0, 120), make_patch({KnotVector::single(1)}, MatrixX::Zero(2, 2)))},
      {"octant", sphere_octant(1, 2, Vec<3>(3, 2, 1))},
      {"cylinder", revolve(meridian, origin, z, 360)},
      {"half cylinder", revolve(meridian, origin, z, 180)},
      {"pipe", revolve(translate(meridian, Vec<3>(1, 0, 0)), origin, z, -360)},
      {"torus", revolve(upright(ruled(circle(Vec<2>(3, 0), 1), circle(Vec<2>(3, 0), 0.5))), origin, z, 360)},
      {"wedge", bent_block({{4, Vec<3>(0, 0, 0)}, {6, Vec<3>(0, 1, 0)}})},
      {"pyramid", bent_block({{4, Vec<3>(0, 0, 1)}, {5, Vec<3>(0, 0, 1)}, {6, Vec<3>(0, 0, 1)}, {7, Vec<3>(0, 0, 1)}})},
      {"one edge", bent_block({{4, Vec<3>(0, 0, 0)}})}};
}

TEST(Coincident, GroupsContainCoincidentFunctionsAndNothingTears) {
  test::Random random(51);
  for (const auto& [name, patch] : folded_patches()) {
    const int dimensions = patch.parametric_dimension();
    for (const char* label : {"N2", "N3.1", "L2"}) {
      SCOPED_TRACE(name + " " + label);
      const Discretization space = discretize(patch, label, {});
      const Groups groups = coincident_functions(space);
      ASSERT_FALSE(groups.empty());
      const MatrixX points = space.points();
      std::set<int> seen;
      for (const auto& group : groups) {
        EXPECT_GE(group.size(), 2u);
        EXPECT_TRUE(std::is_sorted(group.begin(), group.end()));
        for (int function : group) {
          EXPECT_LT((points.col(function) - points.col(group.front())).norm(), 1e-12);
          EXPECT_TRUE(seen.insert(function).second) << "function " << function << " in two groups";
        }
      }
      EXPECT_TRUE(std::is_sorted(groups.begin(), groups.end()));
      EXPECT_LT(tear(patch, space, random_displacement(random, space, groups)), 1e-12);
      EXPECT_GT(tear(patch, space, random_displacement(random, space, {})), 1e-2);
    }
    // Layers on any face that does not cross the collapsed side or seam
    for (int d = 0; d < dimensions; ++d)
      for (bool at_end : {false, true}) {
        const std::string face = name_of({d, at_end});
        SCOPED_TRACE(name + " layer on " + face);
        const Discretization space = discretize(patch, "N2-N2.1", {face, name_of({d, !at_end})}, 2);
        const auto is = [&, d = d, &name = name](std::initializer_list<const char*> names, int direction) {
          return d == direction && std::find(names.begin(), names.end(), name) != names.end();
        };
        if (is({"ring", "hemisphere, bottom"}, 0) || is({"cylinder", "pipe", "torus"}, 2) ||
            (name == "torus" && d == 0))
          EXPECT_ERROR(coincident_functions(space), "nurbs.body.seam");
        else if (is({"octant", "hemisphere, ends"}, 0) || is({"half cylinder", "wedge"}, 2))
          EXPECT_ERROR(coincident_functions(space), "nurbs.body.torn_layer");
        else
          EXPECT_LT(tear(patch, space, random_displacement(random, space, coincident_functions(space))), 1e-12);
      }
  }
}

TEST(Coincident, ContactFaceOnASeamIsRejectedForAllRowSpaces) {
  const Patch ring = ruled(circle(Vec<2>(0, 0), 2), circle(Vec<2>(0, 0), 1));
  for (const char* label : {"N2", "N2-N2.2"})
    EXPECT_ERROR(coincident_functions(discretize(ring, label, {"east"}, 2)), "nurbs.body.seam: face = east");
}

TEST(Coincident, CountsOfKnownGroups) {
  // Around the octant's pole: 4 + 1 + 2·3 functions in the layer (N2.2 on 3 elements, knots of multiplicity 3), and 2 +
  // 1 + 2 in each of the 3 other rows
  const Discretization octant = discretize(sphere_octant(1, 2, Vec<3>(0, 0, 0)), "N2-N2.2", {"front"}, 2);
  const Groups poles = coincident_functions(octant);
  ASSERT_EQ(poles.size(), 4u);
  EXPECT_EQ(poles[0].size(), 11u);
  for (int j = 1; j < 4; ++j) EXPECT_EQ(poles[j].size(), 5u);
  // The ring's seam: one pair per row
  const Patch ring = ruled(circle(Vec<2>(0, 0), 2), circle(Vec<2>(0, 0), 1));
  const Groups seam = coincident_functions(discretize(ring, "N2-N4", {"south"}, 3));
  ASSERT_EQ(seam.size(), 5u);
  for (const auto& pair : seam) EXPECT_EQ(pair.size(), 2u);
  // A collapsed edge along z: all its functions are one group
  const Groups edge = coincident_functions(discretize(bent_block({{4, Vec<3>(0, 0, 0)}}), "N2", {}, 2));
  ASSERT_EQ(edge.size(), 1u);
  EXPECT_EQ(edge[0].size(), 5u);
}

TEST(Coincident, TouchingPointsStayIndependent) {
  test::Random random(52);
  const auto none = [](const Patch& patch) { return coincident_functions(discretize(patch, "N2", {})).empty(); };
  EXPECT_TRUE(none(rectangle(3, 1, Vec<2>(0, 0))));
  EXPECT_TRUE(none(block({1, 2, 3}, Vec<3>(0, 0, 0))));
  EXPECT_TRUE(none(half_cylinder_shell(1, 2, 3, Vec<3>(0, 0, 0))));
  for (int run = 0; run < 20; ++run) {
    const int dimensions = 2 + run % 2;
    const Patch patch = test::random_patch(random, dimensions, dimensions, 2);
    EXPECT_TRUE(coincident_functions(discretize(patch, "N2", {})).empty());
  }

  // A ring that closes only at its outer radius
  const Patch inner = arc(Vec<2>(0, 0), 1, 0, 350), outer = arc(Vec<2>(0, 0), 2, 0, 360);
  EXPECT_TRUE(none(ruled(outer, inner)));
  // A ring with different weights on the two sides of the seam
  Patch closed = ruled(outer, arc(Vec<2>(0, 0), 1, 0, 360));
  MatrixX homogeneous = closed.homogeneous();
  homogeneous.col(0) *= 2;
  EXPECT_TRUE(none(Patch(closed.directions(), homogeneous)));
  // Coincident neighboring control points do not collapse an edge
  const Patch finer = make_patch({KnotVector(1, {0, 0, 0.5, 1, 1}), KnotVector::single(1)},
                                 (MatrixX(2, 6) << 0, 0, 2, 0, 1, 2, 0, 0, 0, 1, 1, 1).finished());
  EXPECT_TRUE(coincident_functions(discretize(finer, "N1", {}, 0)).empty());
  // Opposite corners of a block that touch
  EXPECT_TRUE(none(bent_block({{7, Vec<3>(0, 0, 0)}})));
}

} // namespace coincident_test
} // namespace signorini::nurbs
