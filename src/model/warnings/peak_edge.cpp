#include "model/warnings/peak_edge.hpp"

#include <algorithm>

namespace signorini::model {

namespace {

/// Elements from one to the end of a face, 0 for the last one; closed faces have no end.
template <int D> int elements_to_end(const contact::Surface<D>& face, int element, int direction, bool at_end) {
  int count = 0;
  for (int e = face.neighbor(element, direction, at_end); e >= 0 && count < 3; ++count)
    e = face.neighbor(e, direction, at_end);
  return count;
}

/// True if the control points at an end of a body's face cannot move along the face, or lie on the axis of revolution.
template <int D> bool is_held(const Model<D>& model, const contact::Surface<D>& face, int direction, bool at_end) {
  const int nu = face.direction(0).functions(), nv = D == 2 ? 1 : face.direction(D - 2).functions();
  const int across = direction == 0 ? nv : nu, step = direction == 0 ? nu : 1, inward = direction == 0 ? 1 : nu;
  const int end = !at_end ? 0 : direction == 0 ? nu - 1 : nu * (nv - 1);
  const auto& points = face.reference();
  const double size = (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
  bool held = true, on_axis = model.system.scene.kind == solid::Kind::axisymmetric;
  for (int k = 0; k < across; ++k) {
    const int i = end + k * step;
    Eigen::Index axis;
    (points.col(i) - points.col(at_end ? i - inward : i + inward)).cwiseAbs().maxCoeff(&axis);
    held = held && model.system.unknowns.unknown(D * face.body_function(i) + static_cast<int>(axis)) < 0;
    on_axis = on_axis && std::abs(points(0, i)) <= contact::same_place * size;
  }
  return held || on_axis;
}

} // namespace

template <int D> bool is_peak_at_edge(const Model<D>& model, int contact) {
  const contact::Formulation<D>& formulation = *model.system.contacts[contact];
  const contact::History<D>& history = model.accepted.contacts[contact];
  const auto pressure = [](const auto& point) { return contact::touches(point.state) ? point.pressure : 0; };
  const auto peak = std::ranges::max_element(history.results, {}, pressure);
  if (peak == history.results.end() || pressure(*peak) <= 0) return false;
  const auto place = peak - history.results.begin();
  const contact::Projection<D>& foot = history.points[place].projection;
  if (foot.foot == contact::Foot::edge || foot.foot == contact::Foot::corner) return true;

  const contact::Surface<D>& slave = formulation.slave();
  const auto& points = formulation.points().list;
  const auto touches = [&](int element) {
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points[i].element == element && contact::touches(history.results[i].state)) return true;
    return false;
  };
  const contact::Surface<D>* master = formulation.master().surface();
  for (int a = 0; a < D - 1; ++a)
    for (const bool at_end : {false, true}) {
      const int element = points[place].element;
      const int away = elements_to_end(slave, element, a, at_end);
      const int last = away == 1 ? slave.neighbor(element, a, at_end) : element;
      if (away <= 1 && contact::open_ends(slave, a)[at_end] && touches(last) && !is_held(model, slave, a, at_end))
        return true;
      // One more element: the extension of the master.
      if (!master || !(master->extension().lengths[a][at_end] > 0)) continue;
      if (elements_to_end(*master, foot.element, a, at_end) > 2) continue;
      if (formulation.master().rigid() || !is_held(model, *master, a, at_end)) return true;
    }
  return false;
}

template bool is_peak_at_edge(const Model<2>&, int);
template bool is_peak_at_edge(const Model<3>&, int);

} // namespace signorini::model
