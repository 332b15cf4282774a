#pragma once
// Quadrature points on a face that is tied to another one, cut at the borders of the elements of both.

#include "contact/face/surface.hpp"

#include <vector>

namespace signorini::contact {

/// A quadrature point of the slave face and the closest point on the master, in the reference configuration.
template <int D> struct SeamPoint {
  int slave_element, master_element;
  FaceCoordinates<D> slave_xi, master_xi;
  Vec<D> place;
  double area; ///< reference area, with the quadrature weight
};

/// The points that lie opposite the master, and how well the two faces coincide.
template <int D> struct Seam {
  /// The largest value at the points, and where it occurs.
  struct Extreme {
    double value;
    Vec<D> place;
  };

  std::vector<SeamPoint<D>> points;    ///< slave element by slave element
  double area = 0, whole = 0;          ///< sum over the points; reference area of the slave face
  double length = 0;                   ///< of the longest element at `distance`, along the faces
  Extreme distance{0, Vec<D>::Zero()}; ///< between the faces, largest relative to the longer one of the two elements
  Extreme facing{-1, Vec<D>::Zero()};  ///< cosine between the outward normals: −1 where the faces face each other
};

/// The shape functions of both faces are smooth between the cuts, so that Gauss quadrature is accurate to rounding
/// error on flat faces. In 3D the cuts are straight in the slave's parameters, which is exact for affine meshes and
/// otherwise a curve's chord per element border. `revolved`: the scene is axisymmetric about the second axis. Both
/// faces must be in the reference configuration.
template <int D> Seam<D> find_seam(const Surface<D>& slave, const Surface<D>& master, bool revolved);

} // namespace signorini::contact
