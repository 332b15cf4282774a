#pragma once
// The functions on one element of a tensor product.

#include <array>
#include <span>

namespace signorini::nurbs {

/// Their indices along every direction, and the stride of each direction. A missing direction has the single function
/// 0.
struct ElementFunctions {
  static constexpr int zero = 0;
  std::array<std::span<const int>, 3> along{std::span(&zero, 1), std::span(&zero, 1), std::span(&zero, 1)};
  std::array<int, 3> stride{};
  int first = 0; ///< index of the tensor product's first function

  int count(int d) const { return std::ssize(along[d]); }
  /// Calls visit(function, {i, j, k}), the first direction's i fastest.
  template <class Visit> void each(Visit visit) const {
    std::array<int, 3> i{};
    auto& [a, b, c] = i;
    for (c = 0; c < count(2); ++c)
      for (b = 0; b < count(1); ++b)
        for (a = 0; a < count(0); ++a) {
          int function = first;
          for (std::size_t d = 0; d < 3; ++d) function += along[d][i[d]] * stride[d];
          visit(function, i);
        }
  }
};

} // namespace signorini::nurbs
