// Interfaces and boundaries in files: found in any orientation, written and read in every format.
#include "exchange/interfaces.hpp"

#include "nurbs/directions.hpp"
#include "nurbs/random_patch.hpp"
#include "nurbs/refine.hpp"
#include "nurbs/shapes.hpp"
#include "os/whole_file.hpp"
#include "scratch.hpp"

#include <gtest/gtest.h>

namespace signorini::exchange {
namespace interfaces_test {

using namespace nurbs;
using signorini::test::holds;
using signorini::test::ScratchFolder;

constexpr Side west{0, false}, east{0, true}, south{1, false}, north{1, true}, front{2, false}, back{2, true};

/// A quarter annulus with a square on its end at the y axis; the second patch in another order of directions.
Geometry bracket() {
  const Patch arc = elevate(quarter_annulus(1, 2, Vec<2>::Zero(), 0), 1, 1);
  const Patch bar = elevate(elevate(rectangle(2, 1, Vec<2>(-2, 1)), 0, 1), 1, 1);
  return {{arc, swap_directions(reverse(bar, 0), 0, 1)}};
}

TEST(Interfaces, AreFoundInEveryOrientation) {
  Geometry plane = bracket();
  const auto found = interfaces_of(plane);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].faces, (Interface{{{0, east}, {1, south}}}));
  EXPECT_TRUE(found[0].way.flip[0]); // the arc's rows run inward, the bar's upward

  // A side of a random volume and the same side of its copies in the eight orientations
  nurbs::test::Random random(5);
  const Patch first = nurbs::test::random_patch(random, 3, 3, 2);
  for (const Orientation& way : orientations(2)) {
    Patch second = first;
    if (way.to[0] == 1) second = swap_directions(second, 0, 1);
    for (std::size_t k = 0; k < 2; ++k)
      if (way.flip[k]) second = reverse(second, static_cast<int>(way.to[k]));
    Geometry solid{{first, second}};
    solid.interfaces = std::vector{Interface{{{0, back}, {1, back}}}};
    const auto listed = interfaces_of(solid);
    ASSERT_EQ(listed.size(), 1U);
    EXPECT_EQ(listed[0].way.to, way.to);
    EXPECT_EQ(listed[0].way.flip, way.flip);
  }
}

TEST(Interfaces, ListedFacesThatDoNotMatchAreAnError) {
  Geometry plane = bracket();
  plane.interfaces = std::vector{Interface{{{0, west}, {1, south}}}};
  EXPECT_ERROR(interfaces_of(plane), "exchange.write.interface");
  plane.interfaces.emplace();
  EXPECT_TRUE(interfaces_of(plane).empty()); // a slit
}

TEST(Interfaces, AreWrittenAndReadInEveryFormat) {
  ScratchFolder folder;
  const Patch square = rectangle(1, 1, Vec<2>(0, 0));
  Geometry row{{square, rectangle(1, 1, Vec<2>(1, 0)), rectangle(1, 1, Vec<2>(1, 1))}};
  const std::vector<PatchFace> top{{0, north}, {2, north}}, end{{1, east}, {2, east}};
  row.boundaries = {{"end", end}, {"top", top}};
  for (const std::string& form : forms()) {
    const std::string file = folder.file(form);
    write_geometry(file, row, form);
    const Geometry read = read_geometry(file);
    ASSERT_TRUE(read.interfaces.has_value()) << form;
    EXPECT_EQ(*read.interfaces, (std::vector<Interface>{{{{0, east}, {1, west}}}, {{{1, north}, {2, south}}}})) << form;
    ASSERT_GE(read.boundaries.size(), 2U) << form;
    const bool numbered = form == "mfem";
    EXPECT_EQ(read.boundaries.size(), numbered ? 3U : 2U); // with the other faces
    for (const Boundary& boundary : row.boundaries) {
      const std::string name = numbered ? boundary.name == "end" ? "1" : "2" : boundary.name;
      const auto found = std::find_if(read.boundaries.begin(), read.boundaries.end(),
                                      [&](const Boundary& one) { return one.name == name; });
      ASSERT_NE(found, read.boundaries.end()) << form;
      EXPECT_EQ(found->faces, boundary.faces) << form;
    }
  }
}

/// Two cubes of which the second is turned about the normal of the common face: x is its direction 2.
TEST(Interfaces, GismoAndGeopdesStateTheOrientation) {
  ScratchFolder folder;
  const Patch cube = block({1, 1, 1}, Vec<3>(0, 0, 0));
  const Patch turned = reverse(swap_directions(block({1, 1, 1}, Vec<3>(1, 0, 0)), 0, 1), 0);
  write_geometry(folder.file("p.xml"), {{cube, turned}}, "gismo");
  // Patch 0, side 2 (east), patch 1, side 3 (south); x, y, z are directions 1, 0, 2 of the second one, y reversed.
  EXPECT_TRUE(holds(read_file(folder.file("p.xml")), {"<interfaces>0 2 1 3 1 0 2 1 0 1\n</interfaces>"}));
  write_geometry(folder.file("p.txt"), {{cube, turned}}, "geopdes");
  EXPECT_TRUE(holds(read_file(folder.file("p.txt")), {"INTERFACE 1\n1 2\n2 3\n1 -1 1\n"}));
}

TEST(Interfaces, ASolidInMfemHasCommonVerticesAndEdges) {
  ScratchFolder folder;
  const Geometry two{{block({1, 1, 1}, Vec<3>(0, 0, 0)), block({1, 1, 1}, Vec<3>(1, 0, 0))}};
  write_geometry(folder.file("p"), two, "mfem");
  const std::string text = read_file(folder.file("p"));
  EXPECT_TRUE(holds(text, {"elements\n2\n1 5 0 1 2 3 4 5 6 7\n1 5 1 8 9 2 5 10 11 6\n", "\nboundary\n10\n",
                           "\nedges\n20\n", "\nvertices\n12\n"}));
  EXPECT_EQ(read_geometry(folder.file("p")).interfaces, (std::vector<Interface>{{{{0, east}, {1, west}}}}));
  // A patch that runs against its neighbor
  const Patch opposite = reverse(reverse(two.patches[1], 1), 2);
  EXPECT_ERROR(write_geometry(folder.file("q"), {{two.patches[0], opposite}}, "mfem"), "exchange.mfem.opposite");
}

/// Two halves of a ring share all four corners, so that MFEM would also join their arcs.
TEST(Interfaces, PatchesWithTheSameCornersAreAnErrorInMfem) {
  ScratchFolder folder;
  const Patch upper = nurbs::half_annulus(1, 2, Vec<2>(0, 0));
  MatrixX lower = upper.homogeneous();
  lower.topRows(2) *= -1;
  const Geometry ring{{upper, reverse(Patch(upper.directions(), lower), 0)}};
  EXPECT_EQ(interfaces_of(ring).size(), 2U);
  EXPECT_ERROR(write_geometry(folder.file("p"), ring, "mfem"), "exchange.mfem.same_vertices");
}

} // namespace interfaces_test
} // namespace signorini::exchange
