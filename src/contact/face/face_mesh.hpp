#pragma once
// The elements of a face, their functions and their parametric intervals.

#include "base/eigen.hpp"
#include "nurbs/space1d.hpp"

#include <array>
#include <vector>

namespace signorini::contact {

/// Parametric coordinates on a face.
template <int D> using FaceCoordinates = Eigen::Matrix<double, D - 1, 1>;

/// One or several sheets, tensor products each. Elements are numbered sheet by sheet with the first direction fastest;
/// face-local indices number the functions in the same way. The intervals of ξ¹ of the sheets are apart and increase,
/// so that xi tells the sheet.
template <int D> class FaceMesh {
public:
  /// One sheet, from its directions.
  explicit FaceMesh(std::vector<nurbs::Space1D> directions);
  explicit FaceMesh(std::vector<std::vector<nurbs::Space1D>> sheets);

  int elements() const { return std::ssize(elements_); }
  int sheets() const { return std::ssize(first_element_) - 1; }
  int sheet(int element) const { return elements_[element].sheet; }
  int sheet_at(const FaceCoordinates<D>& xi) const;
  int first_element(int sheet) const { return first_element_[sheet]; }
  int first_function(int sheet) const;
  const nurbs::Space1D& direction(int alpha, int sheet = 0) const { return spaces_[sheet * (D - 1) + alpha]; }
  /// Direction α of the sheet of an element.
  const nurbs::Space1D& along(int element, int alpha) const { return direction(alpha, sheet(element)); }
  /// Index of an element along its sheet's direction α.
  int index(int element, int alpha) const { return elements_[element].index[alpha]; }
  /// Degree of an element along direction α.
  int degree(int element, int alpha) const { return along(element, alpha).degree(index(element, alpha)); }
  /// Parametric interval of an element in direction α.
  std::array<double, 2> interval(int element, int alpha) const {
    return along(element, alpha).interval(index(element, alpha));
  }
  /// The element that contains xi.
  int find_element(const FaceCoordinates<D>& xi) const;
  /// The element that shares the border of `element` at the start or end of direction α; −1 at the sheet's end.
  int neighbor(int element, int alpha, bool at_end) const;

  /// Number of functions on an element, and the largest of all elements.
  int functions_on(int element) const { return elements_[element].functions; }
  int most_functions() const { return most_functions_; }
  /// Face-local indices of the functions of an element.
  const int* nodes(int element) const { return nodes_.data() + elements_[element].nodes; }
  /// Number of the first Bézier point of an element, of all elements in their order; at most elements().
  std::size_t first_bezier(int element) const { return first_bezier_[element]; }

private:
  /// Indices per direction, sheet, number of functions, and offset into nodes_.
  struct Element {
    std::array<int, D - 1> index;
    int sheet, functions;
    std::size_t nodes;
  };

  std::vector<nurbs::Space1D> spaces_; ///< per sheet one per direction
  std::vector<int> first_element_{0};  ///< by sheet
  std::vector<Element> elements_;
  std::vector<int> nodes_;
  std::vector<std::size_t> first_bezier_{0};
  int most_functions_ = 0;
};

} // namespace signorini::contact
