#include "model/scene/face_projection.hpp"

#include "base/error.hpp"
#include "solid/face_points.hpp"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace signorini::model {

namespace {

/// Numbers control points by position.
template <int D> class Places {
public:
  explicit Places(double tolerance) : tolerance_(tolerance) {}

  int number(const FaceReference& face, int function, const Vec<D>& place) {
    const auto [entry, added] = numbers_.try_emplace({face.body, function}, static_cast<int>(places_.size()));
    if (!added) return entry->second;
    for (std::size_t i = 0; i < places_.size(); ++i)
      if ((places_[i] - place).norm() <= tolerance_) return entry->second = static_cast<int>(i);
    places_.push_back(place);
    return entry->second;
  }
  Eigen::Index count() const { return static_cast<Eigen::Index>(places_.size()); }

private:
  double tolerance_;
  std::map<std::pair<int, int>, int> numbers_; ///< by body and function
  std::vector<Vec<D>> places_;
};

} // namespace

template <int D>
Projection project(const Scene<D>& scene, const std::vector<FaceReference>& faces, const MatrixX& values) {
  constexpr double coincident = 1e-9; // relative to the coordinates: rounding error of positions
  double size = 0;
  for (const FaceReference& face : faces)
    size = std::max(size, scene.bodies[face.body].body->space().points().cwiseAbs().maxCoeff());
  Places<D> places(coincident * size);

  std::vector<Eigen::Triplet<double>> mass;
  std::vector<std::pair<int, VectorX>> load;
  double total = 0; // ∫|v|²
  Eigen::Index k = 0;
  for (const FaceReference& face : faces) {
    const solid::Body<D>& body = *scene.bodies[face.body].body;
    const MatrixX points = body.space().points();
    for (const solid::FacePoints<D>& part : solid::face_points(body, face.side)) {
      const MatrixX x = points(Eigen::all, part.functions);
      std::vector<int> own;
      for (std::size_t a = 0; a < part.functions.size(); ++a)
        own.push_back(places.number(face, part.functions[a], x.col(static_cast<Eigen::Index>(a))));
      for (int q = 0; q < part.weights.size(); ++q, ++k) {
        const double weight = part.weights(q) * part.area_vector(x, q).norm();
        total += weight * values.col(k).squaredNorm();
        for (std::size_t a = 0; a < own.size(); ++a) {
          const double share = weight * part.values(static_cast<Eigen::Index>(a), q);
          load.emplace_back(own[a], share * values.col(k));
          for (std::size_t b = 0; b < own.size(); ++b)
            mass.emplace_back(own[a], own[b], share * part.values(static_cast<Eigen::Index>(b), q));
        }
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(places.count(), places.count());
  matrix.setFromTriplets(mass.begin(), mass.end());
  MatrixX right = MatrixX::Zero(places.count(), D);
  for (const auto& [row, value] : load) right.row(row) += value.transpose();
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  require(solver.info() == Eigen::Success, "model.face.no_projection");
  const MatrixX solution = solver.solve(right);

  // The difference is orthogonal to the projection: ∫|v − Pv|² = ∫|v|² − ∫|Pv|².
  const double projected = right.cwiseProduct(solution).sum();
  Projection result{{}, total > 0 ? std::sqrt(std::max(0.0, 1 - projected / total)) : 0.0};
  for (const FaceReference& face : faces) {
    const nurbs::Discretization& space = scene.bodies[face.body].body->space();
    const std::vector<int> functions = space.face_functions(face.side);
    const MatrixX points = space.points();
    result.displacements.emplace_back(D, functions.size());
    for (std::size_t i = 0; i < functions.size(); ++i)
      result.displacements.back().col(static_cast<Eigen::Index>(i)) =
          solution.row(places.number(face, functions[i], points.col(functions[i]))).transpose();
  }
  return result;
}

template Projection project<2>(const Scene<2>&, const std::vector<FaceReference>&, const MatrixX&);
template Projection project<3>(const Scene<3>&, const std::vector<FaceReference>&, const MatrixX&);

} // namespace signorini::model
