#pragma once
// Outline of a body in one of its positions: its faces as segments (2D) or triangles (3D), and what they enclose.

#include "base/eigen.hpp"
#include "nurbs/discretization.hpp"

#include <array>
#include <limits>
#include <vector>

namespace signorini::model {

/// A segment or triangle with corners on a face, counter-clockwise as seen from outside (2D: the outside is on the
/// right).
template <int D> struct Facet {
  std::array<Vec<D>, D> corners;
  Vec<D> middle, normal; ///< outward unit normal, zero where the face is collapsed
  double area;           ///< length (2D)
  double radius;         ///< largest distance of a corner from the middle
  double sagitta;        ///< estimated distance from the face
  nurbs::Side side;
};

/// Index of a side in lists of all sides.
inline std::size_t number_of(nurbs::Side side) {
  return 2 * side.direction + side.at_end;
}

/// A value for each side of a body.
template <int D> struct Sides : std::array<bool, static_cast<std::size_t>(2 * D)> {
  Sides(bool all = false) { this->fill(all); }
};

template <int D> double distance(const Facet<D>& facet, const Vec<D>& x);

template <int D> class Outline {
public:
  /// `points`: control points of the body, D × functions.
  Outline(const nurbs::Discretization& space, const MatrixX& points);

  const std::vector<Facet<D>>& facets() const { return facets_; }
  /// Facets are listed in groups of this number, one after another on the face; one of each is a sufficient sample.
  static constexpr std::size_t stride = D - 1;

  /// True if x lies in the bounding box.
  bool boxes(const Vec<D>& x) const { return (x.array() >= lower_.array() && x.array() <= upper_.array()).all(); }
  /// True if the bounding boxes meet.
  bool meets(const Outline& other) const {
    return (lower_.array() <= other.upper_.array() && other.lower_.array() <= upper_.array()).all();
  }
  /// Twice the enclosed volume over the area: of a thin body its thickness, of a disc its radius.
  double thickness() const { return thickness_; }

  /// Winding number (2D) or solid angle over 4π (3D) of the outline about x: the number of layers of the body that
  /// cover x, 0 outside.
  double winding(const Vec<D>& x) const;
  /// The winding number, as the sum of signs of the facets that a ray from x in a fixed direction leaves and enters.
  /// Takes less time, and is wrong where rounding errors decide whether the ray passes between two facets.
  int layers(const Vec<D>& x) const;

  struct Nearest {
    const Facet<D>* facet = nullptr; ///< null if no facet is accepted
    double distance = std::numeric_limits<double>::infinity();
  };
  /// The nearest of the facets that `accept` returns true for, without collapsed ones; or any that is not farther than
  /// `enough`.
  template <class Accept> Nearest nearest(const Vec<D>& x, const Accept& accept, double enough = 0) const {
    Nearest found;
    for (const Facet<D>& facet : facets_) {
      if (found.distance <= enough) break;
      const double reach = found.distance + facet.radius;
      if ((x - facet.middle).squaredNorm() >= reach * reach || facet.normal.isZero(0) || !accept(facet)) continue;
      if (const double length = distance(facet, x); length < found.distance) found = {&facet, length};
    }
    return found;
  }

private:
  void add_face(const nurbs::Discretization& space, const MatrixX& points, nurbs::Side side);
  void sort();
  int cell(double place, int direction) const;

  std::vector<Facet<D>> facets_;
  Vec<D> lower_, upper_;
  double thickness_ = 0;
  // A grid of cells across the ray: the facets that it may meet in cell c are listed_[first_[c]] … [first_[c + 1] − 1].
  std::vector<std::array<Vec<D>, D>> turned_; ///< corners in the frame of the ray, which runs along its first axis
  int cells_ = 1;                             ///< per direction
  Vec<D> start_, width_;                      ///< of the cells; the first component is unused
  std::vector<int> first_, listed_;
};

} // namespace signorini::model
