#include "model/coincident_faces.hpp"

#include "base/index.hpp"
#include "contact/projection.hpp"
#include "model/constants.hpp"
#include "nurbs/constants.hpp"
#include "nurbs/matching.hpp"

#include <algorithm>
#include <array>

namespace signorini::model {

namespace {

/// Faces are compared at these fractions of their elements: an overlap of less than a tenth of an element of both is
/// not seen.
constexpr std::array<double, 3> coincidence_probes = {0.1, 0.5, 0.9};

/// A face with the bounding box of its control points, which contains it.
template <int D> struct BoxedFace {
  FaceReference face;
  const nurbs::Discretization* space;
  Vec<D> low, high;
};

template <int D>
std::vector<BoxedFace<D>> boxed_faces(const std::vector<std::shared_ptr<const solid::Body<D>>>& bodies) {
  std::vector<BoxedFace<D>> faces;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const nurbs::Discretization& space = bodies[b]->space();
    const MatrixX all = space.points();
    for (const nurbs::Side side : nurbs::sides(D)) {
      const MatrixX points = all(Eigen::all, space.face_functions(side));
      faces.push_back({{static_cast<int>(b), side}, &space, points.rowwise().minCoeff(), points.rowwise().maxCoeff()});
    }
  }
  return faces;
}

template <int D> bool boxes_meet(const BoxedFace<D>& a, const BoxedFace<D>& b) {
  const double tolerance = nurbs::joinable * std::max((a.high - a.low).norm(), (b.high - b.low).norm());
  return ((a.low - b.high).array() <= tolerance).all() && ((b.low - a.high).array() <= tolerance).all();
}

template <int D> double longest_side(const contact::Surface<D>& face, const contact::FacePoint<D>& at_point) {
  double longest = 0;
  for (int d = 0; d < D - 1; ++d) {
    const auto [from, to] = face.interval(at_point.element, d);
    longest = std::max(longest, (to - from) * at_point.tangent[at(d)].norm());
  }
  return longest;
}

/// Whether a face lies on another one, as a whole or in part: of the probes of its elements those that are opposite the
/// other face, at least one, are on it, with opposite normals.
template <int D> bool lies_on(const BoxedFace<D>& first, const BoxedFace<D>& second) {
  const contact::Surface<D> face(*first.space, first.face.side), other(*second.space, second.face.side);
  contact::ElementBoxes<D> boxes;
  boxes.update(other);
  contact::FacePoint<D> probe, foot;
  contact::Projection<D> projection;
  constexpr std::size_t count = coincidence_probes.size();
  bool found = false;
  for (int e = 0; e < face.elements(); ++e)
    for (std::size_t k = 0; k < (D == 2 ? count : count * count); ++k) {
      contact::FaceCoordinates<D> xi;
      for (int d = 0; d < D - 1; ++d) {
        const auto [from, to] = face.interval(e, d);
        xi(d) = from + coincidence_probes[d == 0 ? k % count : k / count] * (to - from);
      }
      face.locate(e, xi, 1, probe);
      probe.element = e;
      projection = contact::project(other, boxes, probe.position, projection, foot);
      if (projection.foot == contact::Foot::none) continue;
      const double length = std::max(longest_side(face, probe), longest_side(other, foot));
      const double cosine = face.outward(probe.tangent).normalized().dot(other.outward(foot.tangent).normalized());
      if ((probe.position - foot.position).norm() > most_seam_distance * length || cosine > coincident_facing)
        return false;
      found = true;
    }
  return found;
}

/// Whether faces that do not match coincide nevertheless.
template <int D> bool coincide(const BoxedFace<D>& a, const BoxedFace<D>& b, nurbs::Mismatch mismatch) {
  if (a.space->crosses_layer(a.face.side) || b.space->crosses_layer(b.face.side))
    return mismatch > nurbs::Mismatch::corners; // an error of the model, which names the difference
  // Both ways: a small face can lie between the probes of a large one.
  return lies_on(a, b) || lies_on(b, a);
}

} // namespace

template <int D>
std::vector<FacePair> coincident_faces(const std::vector<std::shared_ptr<const solid::Body<D>>>& bodies) {
  const std::vector<BoxedFace<D>> faces = boxed_faces<D>(bodies);
  std::vector<FacePair> pairs;
  struct Candidate {
    std::size_t first, second;
    nurbs::Mismatch mismatch;
  };
  std::vector<Candidate> others;
  std::vector<bool> matched(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = i + 1; j < faces.size(); ++j) {
      const BoxedFace<D>&a = faces[i], &b = faces[j];
      if (a.face.body == b.face.body || !boxes_meet(a, b)) continue;
      const nurbs::Mismatch mismatch = nurbs::match_faces(*a.space, a.face.side, *b.space, b.face.side).mismatch;
      if (mismatch == nurbs::Mismatch::none) {
        pairs.push_back({a.face, b.face});
        matched[i] = matched[j] = true;
      } else {
        others.push_back({i, j, mismatch});
      }
    }
  for (const auto& [i, j, mismatch] : others)
    if (!matched[i] && !matched[j] && coincide(faces[i], faces[j], mismatch))
      pairs.push_back({faces[i].face, faces[j].face});
  return pairs;
}

template std::vector<FacePair> coincident_faces(const std::vector<std::shared_ptr<const solid::Body<2>>>&);
template std::vector<FacePair> coincident_faces(const std::vector<std::shared_ptr<const solid::Body<3>>>&);

} // namespace signorini::model
