#include "contact/face/face_mesh.hpp"

#include "nurbs/tensor.hpp"

#include <algorithm>

namespace signorini::contact {

template <int D>
FaceMesh<D>::FaceMesh(std::vector<nurbs::Space1D> directions)
    : FaceMesh(std::vector<std::vector<nurbs::Space1D>>(1, std::move(directions))) {}

template <int D> FaceMesh<D>::FaceMesh(std::vector<std::vector<nurbs::Space1D>> sheets) {
  int first_node = 0;
  for (auto& directions : sheets) {
    const nurbs::Space1D &u = directions.front(), &v = directions.back();
    const int sheet = std::ssize(first_element_) - 1, count = D == 2 ? u.elements() : u.elements() * v.elements();
    for (int e = 0; e < count; ++e) {
      Element element{{}, sheet, 1, nodes_.size()};
      nurbs::ElementFunctions functions;
      int points = 1;
      for (std::size_t d = 0; d < D - 1; ++d) {
        element.index[d] = d == 0 ? e % u.elements() : e / u.elements();
        functions.along[d] = directions[d].functions_on(element.index[d]);
        functions.stride[d] = d == 0 ? 1 : u.functions();
        element.functions *= std::ssize(functions.along[d]);
        points *= directions[d].degree(element.index[d]) + 1;
      }
      functions.each([&](int node, const std::array<int, 3>&) { nodes_.push_back(first_node + node); });
      most_functions_ = std::max(most_functions_, element.functions);
      elements_.push_back(element);
      first_bezier_.push_back(first_bezier_.back() + points);
    }
    first_element_.push_back(elements());
    first_node += D == 2 ? u.functions() : u.functions() * v.functions();
    for (nurbs::Space1D& direction : directions) spaces_.push_back(std::move(direction));
  }
}

template <int D> int FaceMesh<D>::first_function(int sheet) const {
  int sum = 0;
  for (int s = 0; s < sheet; ++s)
    sum += D == 2 ? direction(0, s).functions() : direction(0, s).functions() * direction(D - 2, s).functions();
  return sum;
}

template <int D> int FaceMesh<D>::sheet_at(const FaceCoordinates<D>& xi) const {
  int sheet = sheets() - 1;
  while (sheet > 0 && xi(0) < direction(0, sheet).first()) --sheet;
  return sheet;
}

template <int D> int FaceMesh<D>::find_element(const FaceCoordinates<D>& xi) const {
  const int sheet = sheet_at(xi);
  int element = 0;
  for (int a = D - 2; a >= 0; --a)
    element = element * direction(a, sheet).elements() + direction(a, sheet).find_element(xi(a));
  return first_element(sheet) + element;
}

template <int D> int FaceMesh<D>::neighbor(int element, int alpha, bool at_end) const {
  const int next = index(element, alpha) + (at_end ? 1 : -1);
  if (next < 0 || next >= along(element, alpha).elements()) return -1;
  return element + (at_end ? 1 : -1) * (alpha == 0 ? 1 : along(element, 0).elements());
}

template class FaceMesh<2>;
template class FaceMesh<3>;

} // namespace signorini::contact
