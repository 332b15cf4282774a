#include "contact/face/face_mesh.hpp"

#include "nurbs/tensor.hpp"

#include <algorithm>

namespace signorini::contact {

template <int D> FaceMesh<D>::FaceMesh(std::vector<nurbs::Space1D> directions) : spaces_(std::move(directions)) {
  const nurbs::Space1D &u = spaces_.front(), &v = spaces_.back();
  for (int e = 0, count = D == 2 ? u.elements() : u.elements() * v.elements(); e < count; ++e) {
    Element element{{}, 1, nodes_.size()};
    nurbs::ElementFunctions functions;
    int points = 1;
    for (std::size_t d = 0; d < D - 1; ++d) {
      element.index[d] = d == 0 ? e % u.elements() : e / u.elements();
      functions.along[d] = spaces_[d].functions_on(element.index[d]);
      functions.stride[d] = d == 0 ? 1 : u.functions();
      element.functions *= std::ssize(functions.along[d]);
      points *= spaces_[d].degree(element.index[d]) + 1;
    }
    functions.each([&](int node, const std::array<int, 3>&) { nodes_.push_back(node); });
    most_functions_ = std::max(most_functions_, element.functions);
    elements_.push_back(element);
    first_bezier_.push_back(first_bezier_.back() + points);
  }
}

template <int D> int FaceMesh<D>::find_element(const FaceCoordinates<D>& xi) const {
  int element = 0;
  for (int a = D - 2; a >= 0; --a) element = element * direction(a).elements() + direction(a).find_element(xi(a));
  return element;
}

template <int D> int FaceMesh<D>::neighbor(int element, int alpha, bool at_end) const {
  const int next = index(element, alpha) + (at_end ? 1 : -1);
  if (next < 0 || next >= direction(alpha).elements()) return -1;
  return element + (at_end ? 1 : -1) * (alpha == 0 ? 1 : spaces_.front().elements());
}

template class FaceMesh<2>;
template class FaceMesh<3>;

} // namespace signorini::contact
