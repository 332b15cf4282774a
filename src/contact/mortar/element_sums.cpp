#include "contact/mortar/element_sums.hpp"

#include <algorithm>
#include <limits>

namespace signorini::contact {

template <int D>
ElementSums<D>::ElementSums(const MultiplierFunctions<D>& functions, int elements)
    : functions_(functions), skipped_(elements, false), cleared_(elements, 0.0) {
  std::size_t count = 0;
  for (int e = 0; e < elements; ++e) {
    first_.push_back(count);
    count += functions_.on(e).size();
  }
  sums_.resize(count);
}

template <int D> void ElementSums<D>::start(int element, bool skipped) {
  std::fill_n(sums_.begin() + static_cast<std::ptrdiff_t>(first_[element]), functions_.on(element).size(),
              MultiplierSums<D>{});
  skipped_[element] = skipped;
  cleared_[element] = std::numeric_limits<double>::infinity();
}

template <int D> void ElementSums<D>::add(int element, std::size_t i, const MultiplierSums<D>& point) {
  const double* values = functions_.at_point(i);
  for (std::size_t a = 0; a < functions_.on(element).size(); ++a) sums_[first_[element] + a].add(values[a], point);
}

template <int D> double ElementSums<D>::cleared(int multiplier) const {
  double least = std::numeric_limits<double>::infinity();
  for (const int element : functions_.support(multiplier)) least = std::min(least, cleared_[element]);
  return least;
}

template <int D> MultiplierSums<D> ElementSums<D>::sum(int multiplier) const {
  MultiplierSums<D> sum;
  for (const int element : functions_.support(multiplier))
    sum.add(1, sums_[first_[element] + functions_.index_on(element, multiplier)]);
  return sum;
}

template <int D> double ElementSums<D>::memory() const {
  return static_cast<double>(sums_.capacity() * sizeof(sums_[0]));
}

template class ElementSums<2>;
template class ElementSums<3>;

} // namespace signorini::contact
