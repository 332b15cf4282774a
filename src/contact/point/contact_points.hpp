#pragma once
// Constant data of the Gauss points of a slave face.

#include "contact/face/surface.hpp"

#include <functional>
#include <vector>

namespace signorini::contact {

/// True where the contact acts, by position in the reference configuration; empty: everywhere.
template <int D> using Region = std::function<bool(const Vec<D>&)>;

struct ContactPoint {
  int element;           ///< of the slave face
  int number;            ///< index in the element, ξ¹ fastest, points outside the region included
  double weight;         ///< parametric
  double reference_area; ///< per parametric area
  std::size_t values;    ///< offset into ContactPoints::values
  bool sparse = false;   ///< of the element's sparse rule
};
/// The area of a point's Gauss weight in the reference configuration.
inline double reference_area(const ContactPoint& point) {
  return point.weight * point.reference_area;
}

template <int D> struct ContactPoints {
  /// `per_direction` Gauss points per slave element and direction, element by element, without those outside `where`.
  /// `revolved`: the scene is axisymmetric about the second axis. `sparse`: points per direction of each element's
  /// sparse rule, which follow those of its full rule; 0: none. Throws Error if no point is left.
  ContactPoints(const Surface<D>& slave, int per_direction, bool revolved, const Region<D>& where, int sparse = 0);

  std::size_t size() const { return list.size(); }
  /// R_A of the slave element's functions at point i, then R_A,1 …
  const double* functions(std::size_t i) const { return values.data() + list[i].values; }
  /// Components a^α of the direction a^α xˢ_,α at point i, along which e₁ of a frame lies.
  FaceCoordinates<D> axis(std::size_t i) const { return axes.empty() ? FaceCoordinates<D>::Unit(0) : axes[i]; }

  bool revolved;
  int full, sparse;  ///< points per direction of the rules
  bool whole = true; ///< none is outside the region
  std::vector<ContactPoint> list;
  std::vector<std::size_t> starts; ///< first point of each slave element, and behind the last one
  std::vector<double> values;
  std::vector<Vec<D>> reference;             ///< positions in the reference configuration
  std::vector<FaceCoordinates<D>> axes = {}; ///< of a law with an axis
  std::vector<Vec<D>> outward = {};          ///< of a set of faces: unit normals in the reference configuration
};

/// Current outward unit normal of the slave face there.
template <int D> Vec<D> normal_at(const ContactPoints<D>& points, const Surface<D>& slave, std::size_t i);

/// Makes points those of a set of faces, which is in the reference configuration. `share`: of each, one half where two
/// points act on both faces.
template <int D> void make_set(ContactPoints<D>& points, const Surface<D>& faces, double share);

/// Sets the axes to the projection of a direction onto the slave face, which is in the reference configuration. Throws
/// Error where it is normal to the face.
template <int D> void set_axes(ContactPoints<D>& points, const Surface<D>& slave, const Vec<D>& along);

/// Current position of point i.
template <int D> Vec<D> position(const ContactPoints<D>& points, const Surface<D>& slave, std::size_t i);
/// Current tangents of the slave face there.
template <int D>
std::array<Vec<D>, D - 1> tangents(const ContactPoints<D>& points, const Surface<D>& slave, std::size_t i);

} // namespace signorini::contact
