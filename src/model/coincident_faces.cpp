#include "model/coincident_faces.hpp"

#include "base/index.hpp"
#include "contact/seam.hpp"
#include "model/constants.hpp"
#include "nurbs/constants.hpp"
#include "nurbs/matching.hpp"

#include <algorithm>

namespace signorini::model {

namespace {

/// A face with the bounding box of its control points, which contains it.
template <int D> struct BoxedFace {
  FaceReference face;
  const nurbs::Discretization* space;
  Vec<D> low, high;
};

template <int D>
std::vector<BoxedFace<D>> boxed_faces(const std::vector<std::shared_ptr<const solid::Body<D>>>& bodies) {
  std::vector<BoxedFace<D>> faces;
  for (std::size_t b = 0; b < bodies.size(); ++b)
    for (int d = 0; d < D; ++d)
      for (const bool at_end : {false, true}) {
        const nurbs::Discretization& space = bodies[b]->space();
        const nurbs::Side side{d, at_end};
        const MatrixX points = space.points()(Eigen::all, space.face_functions(side));
        faces.push_back(
            {{static_cast<int>(b), side}, &space, points.rowwise().minCoeff(), points.rowwise().maxCoeff()});
      }
  return faces;
}

template <int D> bool boxes_meet(const BoxedFace<D>& a, const BoxedFace<D>& b) {
  const double tolerance = nurbs::joinable * std::max((a.high - a.low).norm(), (b.high - b.low).norm());
  return ((a.low - b.high).array() <= tolerance).all() && ((b.low - a.high).array() <= tolerance).all();
}

/// Whether a part of the slave face lies on the master, with opposite normals.
template <int D> bool lies_on(const BoxedFace<D>& slave, const BoxedFace<D>& master) {
  const auto surface = [](const BoxedFace<D>& one) { return contact::Surface<D>(*one.space, one.face.side); };
  const contact::Seam<D> seam = contact::find_seam(surface(slave), surface(master), false);
  return seam.area > least_coincidence * seam.whole && seam.facing.value < coincident_facing &&
         seam.distance.value <= most_seam_distance * seam.length;
}

template <int D> bool coincide(const BoxedFace<D>& a, const BoxedFace<D>& b) {
  const nurbs::Mismatch mismatch = nurbs::match_faces(*a.space, a.face.side, *b.space, b.face.side).mismatch;
  if (mismatch == nurbs::Mismatch::none) return true;
  if (crosses_layer(*a.space, a.face.side) || crosses_layer(*b.space, b.face.side))
    return mismatch > nurbs::Mismatch::corners; // an error of the model, which names the difference
  const bool finer = b.space->elements_on(b.face.side) > a.space->elements_on(a.face.side);
  return finer ? lies_on(b, a) : lies_on(a, b);
}

} // namespace

bool crosses_layer(const nurbs::Discretization& space, nurbs::Side side) {
  const auto& rows = space.rows();
  if (space.parametric_dimension() == 2 || side.direction == space.through()) return false;
  const int along = 1 - space.in_row(side.direction); // of a row, on the side
  return std::any_of(rows.begin(), rows.end(),
                     [&](const nurbs::Row& row) { return row.direction(along) != rows.front().direction(along); });
}

template <int D>
std::vector<FacePair> coincident_faces(const std::vector<std::shared_ptr<const solid::Body<D>>>& bodies) {
  const std::vector<BoxedFace<D>> faces = boxed_faces<D>(bodies);
  std::vector<FacePair> pairs;
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = i + 1; j < faces.size(); ++j)
      if (faces[i].face.body != faces[j].face.body && boxes_meet(faces[i], faces[j]) && coincide(faces[i], faces[j]))
        pairs.push_back({faces[i].face, faces[j].face});
  return pairs;
}

template std::vector<FacePair> coincident_faces(const std::vector<std::shared_ptr<const solid::Body<2>>>&);
template std::vector<FacePair> coincident_faces(const std::vector<std::shared_ptr<const solid::Body<3>>>&);

} // namespace signorini::model
