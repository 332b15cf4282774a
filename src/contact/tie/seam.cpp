#include "contact/tie/seam.hpp"

#include "contact/closest/projection.hpp"
#include "contact/point/local.hpp"
#include "contact/tie/polygon.hpp"
#include "solid/quadrature.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::contact {

namespace {

/// Degrees of the faces' functions above the polynomial ones, for rational functions and curved faces.
constexpr int curved_degrees = 2;
/// Where cuts do not fill an element that lies opposite the master as a whole, such as at a closed surface's seam, it
/// is divided evenly into this number of boxes per direction.
constexpr int even_pieces = 4;
/// Overhang beyond an end of the master, relative to its element, that still lies opposite: ends of curved faces.
constexpr double end_overhang = 0.01;
/// Relative error of areas that counts as rounding error.
constexpr double area_rounding = 1e-9;
/// Elements beyond open ends of the slave face, over which larger masters are cut.
constexpr double cut_extension = 4;

/// A face with its search tree.
template <int D> struct SearchedFace {
  Surface<D> face;
  ElementBoxes<D> boxes = {};
  Projection<D> last = {};

  explicit SearchedFace(const Surface<D>& surface) : face(surface) { boxes.update(face); }
  const Projection<D>& project(const Vec<D>& x, FacePoint<D>& point) {
    return last = contact::project(face, boxes, x, last, point);
  }
};

/// Degree of products of both faces' functions and of a multiplier.
template <int D> int degree_of_products(const Surface<D>& slave, const Surface<D>& master) {
  int highest = 0;
  for (const Surface<D>* face : {&slave, &master})
    for (int d = 0; d < D - 1; ++d) highest = std::max(highest, face->direction(d).degree());
  return 2 * highest + curved_degrees;
}

template <int D> double longest_side(const Surface<D>& face, const FacePoint<D>& at) {
  double longest = 0;
  for (int d = 0; d < D - 1; ++d) {
    const auto [from, to] = face.interval(at.element, d);
    longest = std::max(longest, (to - from) * at.tangent[d].norm());
  }
  return longest;
}

template <int D> class SeamFinder {
public:
  SeamFinder(const Surface<D>& slave, const Surface<D>& master, bool revolved)
      : slave_(slave), master_(master), degree_(degree_of_products(slave, master)) {
    geometry_.revolved = revolved;
  }

  Seam<D> run() {
    const auto cuts = find_cuts();
    for (int e = 0; e < slave_.elements(); ++e) {
      const solid::ElementQuadrature all = box_rule(e, 1);
      std::vector<bool> tied;
      for (Eigen::Index q = 0; q < all.weights.size(); ++q) {
        tied.push_back(find(e, all.points.col(q)));
        seam_.whole += all.weights(q) * measure_;
      }
      if (std::find(tied.begin(), tied.end(), true) == tied.end() && !any_piece(e, cuts)) continue;
      const bool as_a_whole = std::find(tied.begin(), tied.end(), false) == tied.end();
      add_element(e, cuts, as_a_whole);
    }
    return std::move(seam_);
  }

private:
  /// 2D: parameters; 3D: polygons in the slave's parameters, one per master element.
  using Cuts = std::conditional_t<D == 2, std::vector<double>, std::vector<Polygon>>;

  Cuts find_cuts() {
    Surface<D> longer = slave_;
    if constexpr (D == 3) longer.extend(cut_extension);
    SearchedFace<D> target(longer);
    FacePoint<D> border, foot;
    Cuts cuts;
    const auto corner = [&](int e, const FaceCoordinates<D>& xi) {
      master_.face.locate(e, xi, 0, border);
      return target.project(border.position, foot).xi;
    };
    for (int e = 0; e < master_.face.elements(); ++e) {
      const auto [a, b] = master_.face.interval(e, 0);
      if constexpr (D == 2) {
        for (const double end : {a, b}) cuts.push_back(corner(e, FaceCoordinates<2>(end))(0));
      } else {
        const auto [c, d] = master_.face.interval(e, 1);
        cuts.push_back({corner(e, {a, c}), corner(e, {b, c}), corner(e, {b, d}), corner(e, {a, d})});
      }
    }
    if constexpr (D == 2) std::sort(cuts.begin(), cuts.end());
    return cuts;
  }

  /// True if a piece may lie on an element whose Gauss points are not opposite the master.
  bool any_piece(int element, const Cuts& cuts) const {
    if constexpr (D == 2) {
      const std::array<double, 2> ends = slave_.interval(element, 0);
      return std::any_of(cuts.begin(), cuts.end(), [&](double cut) { return cut > ends[0] && cut < ends[1]; });
    } else {
      return pieces_area(pieces(element, cuts)) > 0;
    }
  }

  void add_element(int element, const Cuts& cuts, bool as_a_whole) {
    if constexpr (D == 2) {
      const auto [from, to] = slave_.interval(element, 0);
      const double least = area_rounding * (to - from);
      double start = from;
      const auto add_up_to = [&](double end) {
        if (end - start <= least) return;
        add(element, solid::tensor_product({solid::gauss_legendre(degree_ / 2 + 1, start, end)}));
        start = end;
      };
      for (const double cut : cuts)
        if (cut > from && cut < to - least) add_up_to(cut);
      add_up_to(to);
    } else {
      const std::vector<Polygon> parts = pieces(element, cuts);
      const double sum = pieces_area(parts), own = (upper(element) - lower(element)).prod();
      const bool fits = as_a_whole ? std::abs(sum - own) <= area_rounding * own : sum > 0 && sum <= own;
      if (!fits) return add(element, box_rule(element, even_pieces));
      for (const Polygon& part : parts)
        if (area(part) > area_rounding * own) add(element, quadrature(part, degree_));
    }
  }

  Vec<D - 1> lower(int element) const {
    Vec<D - 1> corner;
    for (int d = 0; d < D - 1; ++d) corner(d) = slave_.interval(element, d)[0];
    return corner;
  }
  Vec<D - 1> upper(int element) const {
    Vec<D - 1> corner;
    for (int d = 0; d < D - 1; ++d) corner(d) = slave_.interval(element, d)[1];
    return corner;
  }

  std::vector<Polygon> pieces(int element, const std::vector<Polygon>& cuts) const requires(D == 3) {
    std::vector<Polygon> result;
    for (const Polygon& cut : cuts) {
      Polygon part = clip(cut, lower(element), upper(element));
      if (part.size() > 2) result.push_back(std::move(part));
    }
    return result;
  }
  static double pieces_area(const std::vector<Polygon>& parts) {
    double sum = 0;
    for (const Polygon& part : parts) sum += area(part);
    return sum;
  }

  /// Gauss points in an element divided evenly.
  solid::ElementQuadrature box_rule(int element, int divisions) const {
    std::vector<solid::QuadratureRule> rules;
    for (int d = 0; d < D - 1; ++d) {
      const auto [from, to] = slave_.interval(element, d);
      rules.emplace_back();
      for (int k = 0; k < divisions; ++k) {
        const double width = (to - from) / divisions;
        const auto part = solid::gauss_legendre(degree_ / 2 + 1, from + k * width, from + (k + 1) * width);
        rules.back().points.insert(rules.back().points.end(), part.points.begin(), part.points.end());
        rules.back().weights.insert(rules.back().weights.end(), part.weights.begin(), part.weights.end());
      }
    }
    return solid::tensor_product(rules);
  }

  /// Finds the closest point of a slave point; true if it lies opposite the master.
  bool find(int element, const FaceCoordinates<D>& xi) {
    slave_.locate(element, xi, 1, own_);
    own_.element = element;
    geometry_.slave = own_.position;
    geometry_.slave_tangent = own_.tangent;
    LocalRow<D> derivative;
    measure_ = slave_measure(geometry_, derivative);
    const Projection<D>& projection = master_.project(own_.position, foot_);
    if (projection.foot != Foot::none) return true;
    const Vec<D> away = own_.position - foot_.position, normal = outward(master_.face, foot_).normalized();
    return (away - away.dot(normal) * normal).norm() <= end_overhang * longest_side(master_.face, foot_);
  }

  void add(int element, const solid::ElementQuadrature& rule) {
    for (Eigen::Index q = 0; q < rule.weights.size(); ++q) {
      const FaceCoordinates<D> xi = rule.points.col(q);
      if (!find(element, xi)) continue;
      const double distance = (own_.position - foot_.position).norm();
      const double length = std::max(longest_side(slave_, own_), longest_side(master_.face, foot_));
      const double cosine = outward(slave_, own_).normalized().dot(outward(master_.face, foot_).normalized());
      if (distance * seam_.length >= seam_.distance.value * length) {
        seam_.distance = {distance, own_.position};
        seam_.length = length;
      }
      if (cosine > seam_.facing.value) seam_.facing = {cosine, own_.position};
      seam_.points.push_back({element, foot_.element, xi, foot_.xi, own_.position, rule.weights(q) * measure_});
      seam_.area += seam_.points.back().area;
    }
  }

  const Surface<D>& slave_;
  SearchedFace<D> master_;
  int degree_;
  Seam<D> seam_;
  LocalGeometry<D> geometry_;
  FacePoint<D> own_, foot_;
  double measure_ = 0;
};

} // namespace

template <int D> Seam<D> find_seam(const Surface<D>& slave, const Surface<D>& master, bool revolved) {
  return SeamFinder<D>(slave, master, revolved).run();
}

template Seam<2> find_seam(const Surface<2>&, const Surface<2>&, bool);
template Seam<3> find_seam(const Surface<3>&, const Surface<3>&, bool);

} // namespace signorini::contact
