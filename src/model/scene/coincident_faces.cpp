#include "model/scene/coincident_faces.hpp"

#include "contact/closest/projection.hpp"
#include "model/constants.hpp"
#include "nurbs/constants.hpp"
#include "nurbs/matching.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace signorini::model {

namespace {

/// Faces are compared at these fractions of their elements: an overlap of less than a tenth of an element of both is
/// not seen.
constexpr std::array<double, 3> coincidence_probes = {0.1, 0.5, 0.9};

/// A face with the bounding box of its control points, which contains it, and the distance within which it may be tied.
template <int D> struct BoxedFace {
  FaceReference face;
  const nurbs::Discretization* space;
  Vec<D> low, high;
  double reach;
};

/// Length of its longest element, bounded by the diagonal of its box.
template <int D> double reach_of(const nurbs::Discretization& space, nurbs::Side side, double diagonal) {
  if (crosses_layer(space, side)) return most_seam_distance * diagonal;
  const contact::Surface<D> face(space, side);
  double longest = 0;
  Vec<D> low, high;
  for (int e = 0; e < face.elements(); ++e) {
    bounds(face.bezier(e), low, high);
    longest = std::max(longest, (high - low).norm());
  }
  return most_seam_distance * longest;
}

template <int D>
std::vector<BoxedFace<D>> boxed_faces(const std::vector<std::shared_ptr<const solid::Body<D>>>& bodies) {
  std::vector<BoxedFace<D>> faces;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const nurbs::Discretization& space = bodies[b]->space();
    const MatrixX all = space.points();
    for (const nurbs::Side side : nurbs::sides(D)) {
      const MatrixX points = all(Eigen::all, space.face_functions(side));
      const Vec<D> low = points.rowwise().minCoeff(), high = points.rowwise().maxCoeff();
      faces.push_back({{static_cast<int>(b), side}, &space, low, high, reach_of<D>(space, side, (high - low).norm())});
    }
  }
  return faces;
}

/// True if two faces may be close enough for a tie.
template <int D> bool boxes_meet(const BoxedFace<D>& a, const BoxedFace<D>& b) {
  const double tolerance = std::max(a.reach, b.reach);
  return ((a.low - b.high).array() <= tolerance).all() && ((b.low - a.high).array() <= tolerance).all();
}

template <int D> double longest_side(const contact::Surface<D>& face, const contact::FacePoint<D>& at_point) {
  double longest = 0;
  for (int d = 0; d < D - 1; ++d) {
    const auto [from, to] = face.interval(at_point.element, d);
    longest = std::max(longest, (to - from) * at_point.tangent[d].norm());
  }
  return longest;
}

/// Calls visit(element, parameters) at fractions of each element of a face.
template <int D, std::size_t N, class Visit>
void at_fractions(const contact::Surface<D>& face, const std::array<double, N>& fractions, Visit visit) {
  for (int e = 0; e < face.elements(); ++e)
    for (std::size_t k = 0; k < (D == 2 ? N : N * N); ++k) {
      contact::FaceCoordinates<D> xi;
      for (int d = 0; d < D - 1; ++d) {
        const auto [from, to] = face.interval(e, d);
        xi(d) = from + fractions[d == 0 ? k % N : k / N] * (to - from);
      }
      visit(e, xi);
    }
}

/// Distances of a face's probes from a face on which they lie; infinite for those that have no point of it opposite.
using Distances = std::vector<double>;

bool any_finite(const Distances& distances) {
  return std::any_of(distances.begin(), distances.end(), [](double one) { return std::isfinite(one); });
}

/// Empty unless a face lies on another one, as a whole or in part: of its probes those that are opposite the other
/// face, at least one, are on it up to the tolerance of ties, with opposite normals.
template <int D> Distances distances_on(const BoxedFace<D>& first, const BoxedFace<D>& second) {
  const contact::Surface<D> face(*first.space, first.face.side), other(*second.space, second.face.side);
  contact::ElementBoxes<D> boxes;
  boxes.update(other);
  contact::FacePoint<D> probe, foot;
  contact::Projection<D> projection;
  Distances distances;
  bool apart = false;
  at_fractions(face, coincidence_probes, [&](int element, const contact::FaceCoordinates<D>& xi) {
    if (apart) return;
    face.locate(element, xi, 1, probe);
    probe.element = element;
    projection = contact::project(other, boxes, probe.position, projection, foot);
    distances.push_back(std::numeric_limits<double>::infinity());
    if (projection.foot == contact::Foot::none) return;
    const double length = std::max(longest_side(face, probe), longest_side(other, foot));
    const double cosine = outward(face, probe).normalized().dot(outward(other, foot).normalized());
    distances.back() = (probe.position - foot.position).norm();
    apart = distances.back() > most_seam_distance * length || cosine > coincident_facing;
  });
  return apart || !any_finite(distances) ? Distances() : distances;
}

/// Two faces that do not match but may coincide.
struct Candidate {
  std::size_t first, second;
  Distances from_first, from_second; ///< a small face can lie between the probes of a large one
  double distance = 0;               ///< the largest one
  bool coincides = false;
};

template <int D> bool crosses_layer(const BoxedFace<D>& face) {
  return crosses_layer(*face.space, face.face.side);
}

template <int D>
Candidate candidate(const std::vector<BoxedFace<D>>& faces, std::size_t i, std::size_t j,
                    const nurbs::FaceMatch& match) {
  Candidate result{i, j, {}, {}};
  const BoxedFace<D>&a = faces[i], &b = faces[j];
  if (crosses_layer(a) || crosses_layer(b)) {
    // An error of the model, which names the difference
    const int elements = std::max(a.space->elements_on(a.face.side), b.space->elements_on(b.face.side));
    result.coincides = match.mismatch > nurbs::Mismatch::corners ||
                       match.apart <= most_seam_distance * (a.high - a.low).norm() / std::sqrt(elements);
    return result;
  }
  result.from_first = distances_on(a, b);
  result.from_second = distances_on(b, a);
  for (const Distances* distances : {&result.from_first, &result.from_second})
    for (const double distance : *distances)
      if (std::isfinite(distance)) result.distance = std::max(result.distance, distance);
  result.coincides = !result.from_first.empty() || !result.from_second.empty();
  return result;
}

/// Among faces at a distance only those that are next to each other coincide: there are probes of one that lie on no
/// closer face. Others have a thin body between them.
template <int D> void leave_out_distant(const std::vector<BoxedFace<D>>& faces, std::vector<Candidate>& candidates) {
  std::vector<std::size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t k) { return candidates[i].distance < candidates[k].distance; });
  std::vector<Distances> nearest(faces.size());
  for (const std::size_t k : order) {
    Candidate& pair = candidates[k];
    const double touching = nurbs::joinable * (faces[pair.first].high - faces[pair.first].low).norm();
    bool next = pair.distance <= touching;
    for (const auto& [face, distances] :
         {std::pair(pair.first, &pair.from_first), std::pair(pair.second, &pair.from_second)}) {
      nearest[face].resize(std::max(nearest[face].size(), distances->size()), std::numeric_limits<double>::infinity());
      for (std::size_t i = 0; i < distances->size(); ++i)
        next = next || (std::isfinite((*distances)[i]) && !std::isfinite(nearest[face][i]));
    }
    pair.coincides = next;
    if (!next) continue;
    for (const auto& [face, distances] :
         {std::pair(pair.first, &pair.from_first), std::pair(pair.second, &pair.from_second)})
      for (std::size_t i = 0; i < distances->size(); ++i)
        nearest[face][i] = std::min(nearest[face][i], (*distances)[i]);
  }
}

} // namespace

template <int D>
std::vector<FacePair> coincident_faces(const std::vector<std::shared_ptr<const solid::Body<D>>>& bodies) {
  const std::vector<BoxedFace<D>> faces = boxed_faces<D>(bodies);
  std::vector<FacePair> pairs;
  struct Other {
    std::size_t first, second;
    nurbs::FaceMatch match;
  };
  std::vector<Other> others;
  std::vector<bool> matched(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = i + 1; j < faces.size(); ++j) {
      const BoxedFace<D>&a = faces[i], &b = faces[j];
      if (a.face.body == b.face.body || !boxes_meet(a, b)) continue;
      nurbs::FaceMatch match = nurbs::match_faces(*a.space, a.face.side, *b.space, b.face.side);
      if (match.mismatch == nurbs::Mismatch::none) {
        pairs.push_back({a.face, b.face});
        matched[i] = matched[j] = true;
      } else {
        others.push_back({i, j, std::move(match)});
      }
    }
  std::vector<Candidate> candidates;
  for (const auto& [i, j, match] : others)
    if (!matched[i] && !matched[j])
      if (Candidate found = candidate<D>(faces, i, j, match); found.coincides) candidates.push_back(std::move(found));
  leave_out_distant(faces, candidates);
  for (const Candidate& found : candidates)
    if (found.coincides) pairs.push_back({faces[found.first].face, faces[found.second].face});
  return pairs;
}

template <int D>
FaceGap<D> smallest_gap(const std::vector<std::shared_ptr<const solid::Body<D>>>& first,
                        const std::vector<std::shared_ptr<const solid::Body<D>>>& second) {
  FaceGap<D> smallest{{}, std::numeric_limits<double>::infinity()};
  const auto note = [&](const BoxedFace<D>& a, const BoxedFace<D>& b, double distance) {
    if (distance < smallest.distance) smallest = {{a.face, b.face}, distance};
  };
  // The least distance of points of `a`, at its corners, too, from `b`
  const auto distance_from = [&](const BoxedFace<D>& a, const BoxedFace<D>& b) {
    const contact::Surface<D> face(*a.space, a.face.side), other(*b.space, b.face.side);
    contact::ElementBoxes<D> boxes;
    boxes.update(other);
    contact::FacePoint<D> probe, foot;
    contact::Projection<D> projection;
    double least = std::numeric_limits<double>::infinity();
    at_fractions(face, std::array<double, 3>{0, 0.5, 1}, [&](int element, const contact::FaceCoordinates<D>& xi) {
      face.locate(element, xi, 1, probe);
      projection = contact::project(other, boxes, probe.position, projection, foot);
      least = std::min(least, (probe.position - foot.position).norm());
    });
    return least;
  };
  for (const BoxedFace<D>& a : boxed_faces<D>(first))
    for (const BoxedFace<D>& b : boxed_faces<D>(second)) {
      const Vec<D> between = (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(0.0);
      if (between.norm() >= smallest.distance) continue;
      if (crosses_layer(a) || crosses_layer(b)) {
        const MatrixX here = a.space->points()(Eigen::all, a.space->face_functions(a.face.side));
        const MatrixX there = b.space->points()(Eigen::all, b.space->face_functions(b.face.side));
        for (const auto point : here.colwise())
          note(a, b, std::sqrt((there.colwise() - VectorX(point)).colwise().squaredNorm().minCoeff()));
        continue;
      }
      note(a, b, std::min(distance_from(a, b), distance_from(b, a)));
    }
  return smallest;
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template std::vector<FacePair> coincident_faces(const std::vector<std::shared_ptr<const solid::Body<D>>>&);          \
  template FaceGap<D> smallest_gap(const std::vector<std::shared_ptr<const solid::Body<D>>>&,                          \
                                   const std::vector<std::shared_ptr<const solid::Body<D>>>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::model
