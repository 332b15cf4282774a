#pragma once
// The elements of a face, their functions and their parametric intervals.

#include "base/eigen.hpp"
#include "nurbs/space1d.hpp"

#include <array>
#include <vector>

namespace signorini::contact {

/// Parametric coordinates on a face.
template <int D> using FaceCoordinates = Eigen::Matrix<double, D - 1, 1>;

/// Elements are numbered with the first direction fastest; face-local indices number the functions in the same way.
template <int D> class FaceMesh {
public:
  explicit FaceMesh(std::vector<nurbs::Space1D> directions);

  int elements() const { return std::ssize(elements_); }
  const nurbs::Space1D& direction(int alpha) const { return spaces_[alpha]; }
  /// Index of an element along the face's direction α.
  int index(int element, int alpha) const { return elements_[element].index[alpha]; }
  /// Degree of an element along direction α.
  int degree(int element, int alpha) const { return direction(alpha).degree(index(element, alpha)); }
  /// Parametric interval of an element in direction α.
  std::array<double, 2> interval(int element, int alpha) const {
    return direction(alpha).interval(index(element, alpha));
  }
  /// The element that contains xi.
  int find_element(const FaceCoordinates<D>& xi) const;
  /// The element that shares the border of `element` at the start or end of direction α; −1 at the face's end.
  int neighbor(int element, int alpha, bool at_end) const;

  /// Number of functions on an element, and the largest of all elements.
  int functions_on(int element) const { return elements_[element].functions; }
  int most_functions() const { return most_functions_; }
  /// Face-local indices of the functions of an element.
  const int* nodes(int element) const { return nodes_.data() + elements_[element].nodes; }
  /// Number of the first Bézier point of an element, of all elements in their order; at most elements().
  std::size_t first_bezier(int element) const { return first_bezier_[element]; }

private:
  /// Indices per direction, number of functions, and offset into nodes_.
  struct Element {
    std::array<int, D - 1> index;
    int functions;
    std::size_t nodes;
  };

  std::vector<nurbs::Space1D> spaces_; ///< one per direction
  std::vector<Element> elements_;
  std::vector<int> nodes_;
  std::vector<std::size_t> first_bezier_{0};
  int most_functions_ = 0;
};

} // namespace signorini::contact
