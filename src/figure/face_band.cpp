#include "base/error.hpp"
#include "figure/frame.hpp"
#include "model/results/face_values.hpp"
#include "model/results/sample.hpp"

#include <algorithm>

namespace signorini::figure {

namespace {

/// A point of the face and the center of the element behind it in thickness direction.
struct BandPoint {
  Vec<2> face, inside;
};

BandPoint band_point(const model::Model<2>& model, const model::FaceReference& slave, double along, bool deformed) {
  const nurbs::Discretization& space = model.system.scene.bodies[slave.body].body->space();
  const int across = slave.side.direction;
  const auto [from, to] = space.interval(slave.side.at_end ? space.elements() - 1 : 0, across);
  const auto position = [&](double depth) {
    VectorX xi(2);
    xi(1 - across) = along;
    xi(across) = depth;
    const model::BodyPoint<2> point = model::regular_point(model, slave.body, space.find_element(xi), xi);
    return deformed ? Vec<2>(point.reference + point.state.displacement) : point.reference;
  };
  return {position(slave.side.at_end ? to : from), position(0.5 * (from + to))};
}

} // namespace

view::Body face_band(const model::Model<2>& model, model::FaceField field, const model::FaceReference& face,
                     const Showing& showing, double size) {
  const contact::Surface<2> slave(model.system.scene.bodies[face.body].body->space(), face.side);
  std::vector<model::FaceValues<2>> values; // of all contacts of the face
  for (std::size_t c = 0; c < model.system.scene.contacts.size(); ++c)
    for (std::size_t k = 0; k < model.system.scene.contacts[c].slave.size(); ++k)
      if (model.system.scene.contacts[c].slave[k] == face && has(model.system.scene.contacts[c], field))
        values.emplace_back(model, field, static_cast<int>(c), k);
  const int divisions = std::clamp(400 / slave.elements(), 8, 40), count = slave.elements() * (divisions + 1);
  std::vector<BandPoint> places;
  view::Body band;
  band.skin.values.resize(2 * count);
  for (int e = 0; e < slave.elements(); ++e)
    for (int k = 0; k <= divisions; ++k) {
      const auto [from, to] = slave.interval(e, 0);
      const double fraction = double(k) / divisions;
      const auto i = static_cast<Eigen::Index>(places.size());
      places.push_back(band_point(model, face, from + (to - from) * fraction, showing.deformed));
      double sum = 0;
      for (const auto& one : values) sum += one.at_place(e, contact::FaceCoordinates<2>(fraction));
      band.skin.values(i) = band.skin.values(count + i) = showing.factor * sum;
    }
  // Half of the thickness of the elements at the face, within visible limits.
  double depth = 0;
  for (const BandPoint& place : places) depth += (place.inside - place.face).norm() / count;
  const double width = std::clamp(depth, 0.014 * size, 0.03 * size);
  band.skin.points.setZero(3, 2 * count);
  view::Points edge = view::Points::Zero(3, count);
  for (int i = 0; i < count; ++i) {
    const auto at = [&](int j) { return places[j]; };
    // Two points further, because points at element borders are doubled
    const Vec<2> along = (at(std::min(i + 2, count - 1)).face - at(std::max(i - 2, 0)).face).stableNormalized();
    Vec<2> inwards(-along(1), along(0));
    if (inwards.dot(at(i).inside - at(i).face) < 0) inwards = -inwards;
    band.skin.points.col(i).head<2>() = at(i).face;
    band.skin.points.col(count + i).head<2>() = at(i).face + width * inwards;
    edge.col(i) = band.skin.points.col(count + i);
  }
  band.skin.triangles.resize(3, 2 * (count - 1));
  for (int i = 0; i + 1 < count; ++i) {
    band.skin.triangles.col(2 * i) << i, i + 1, count + i + 1;
    band.skin.triangles.col(2 * i + 1) << i, count + i + 1, count + i;
  }
  band.rim = {{std::move(edge)}};
  return band;
}

template <int D>
std::vector<view::PointVector> tractions(const model::Model<D>& model, const std::vector<int>& bodies) {
  const auto& contacts = model.system.scene.contacts;
  require(!contacts.empty(), "figure.vectors.contact");
  std::vector<view::PointVector> vectors;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const model::Faces& slave = contacts[c].slave;
    if (std::none_of(bodies.begin(), bodies.end(), [&](int body) { return slave.on(body); })) continue;
    for (const auto& point : model.present.contacts[c].results) {
      if (!(point.force.norm() > 0 && point.area > 0)) continue;
      view::PointVector& one = vectors.emplace_back(view::PointVector{Vec<3>::Zero(), Vec<3>::Zero()});
      one.at.template head<D>() = point.position;
      one.vector.template head<D>() = point.force / point.area;
    }
  }
  return vectors;
}
template std::vector<view::PointVector> tractions<2>(const model::Model<2>&, const std::vector<int>&);
template std::vector<view::PointVector> tractions<3>(const model::Model<3>&, const std::vector<int>&);

} // namespace signorini::figure
