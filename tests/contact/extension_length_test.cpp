// How far a master's face is extended beyond its open ends.
#include "contact/couple3d.hpp"

#include <algorithm>

namespace signorini::contact {
namespace extension_length_test {

using namespace test;

/// Distance of the extension's end from the face's end in the reference configuration; of a surface at the parameter
/// `across` along the border.
template <int D> double reach(const Surface<D>& face, const Surface<D>& longer, int alpha, bool at_end, double across) {
  FacePoint<D> end, tip;
  const auto locate = [&](const Surface<D>& surface, FacePoint<D>& point) {
    FaceCoordinates<D> xi;
    xi.setConstant(across);
    xi(alpha) = at_end ? surface.direction(alpha).last() : surface.direction(alpha).first();
    surface.locate(surface.find_element(xi), xi, 0, point);
  };
  locate(face, end);
  locate(longer, tip);
  return (tip.position - end.position).norm();
}

TEST(ExtensionLength, IsThatOfTheShorterElements) {
  // A line of one element, and with short last elements: 0.3 of the element or the given length
  for (const auto& [knots, expected] : std::vector<std::pair<std::vector<double>, double>>{
           {{0, 0, 4, 4}, 0.06}, {{0, 0, 0.1, 3.9, 4, 4}, 0.03}, {{0, 0, 0.2, 3.8, 4, 4}, 0.06}}) {
    const nurbs::KnotVector vector(1, knots);
    MatrixX points = MatrixX::Zero(2, vector.functions());
    for (int i = 0; i < vector.functions(); ++i) points(0, i) = 5 - knots[static_cast<std::size_t>(i + 1)];
    const Surface<2> line(nurbs::make_patch({vector}, points, VectorX::Ones(vector.functions())));
    Surface<2> longer = line;
    longer.extend(0.3, 0.06);
    for (bool at_end : {false, true}) EXPECT_NEAR(reach(line, longer, 0, at_end, 0), expected, 1e-14);
  }
  // In space the longest of the ends and middles of the border's elements counts.
  Random random(5);
  const Surface<3> face = top_of(wavy_plate(random, 3, 0.1, 2, 3));
  Surface<3> longer = face;
  longer.extend(0.3, 0.1);
  for (int alpha : {0, 1})
    for (bool at_end : {false, true}) {
      const nurbs::Space1D& along = face.direction(1 - alpha);
      double most = 0;
      for (int e = 0; e < along.elements(); ++e)
        for (double t : {0.0, 0.5, 1.0}) {
          const auto [from, to] = along.interval(e);
          most = std::max(most, reach(face, longer, alpha, at_end, from + t * (to - from)));
        }
      // Lengths are those that the tangents at the end predict: of rational faces they change with the weights.
      EXPECT_NEAR(most, 0.1, 0.015);
    }
}

} // namespace extension_length_test
} // namespace signorini::contact
