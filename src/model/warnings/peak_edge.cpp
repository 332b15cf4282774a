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

/// True if a contact reaches an end of its slave face, at most one element away, which is an edge.
template <int D> bool ends_slave(const Model<D>& model, int contact, int element, int direction, bool at_end) {
  const contact::Formulation<D>& formulation = *model.system.contacts[contact];
  const contact::Surface<D>& slave = formulation.slave();
  const int away = elements_to_end(slave, element, direction, at_end);
  if (away > 1 || !contact::open_ends(slave, direction)[at_end] || is_held(model, slave, direction, at_end))
    return false;
  const int last = away == 1 ? slave.neighbor(element, direction, at_end) : element;
  const contact::ContactPoints<D>& points = formulation.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const contact::ContactPoint& point = points.list[i];
    const int per_direction = point.sparse ? points.sparse : points.full;
    const int row = direction == 0 ? point.number % per_direction : point.number / per_direction;
    if (point.element == last && row == (at_end ? per_direction - 1 : 0) &&
        contact::touches(model.accepted.contacts[contact].results[i].state))
      return true;
  }
  return false;
}

/// The same of the master: points touch opposite its extension.
template <int D> bool ends_master(const Model<D>& model, int contact, int element, int direction, bool at_end) {
  const contact::Formulation<D>& formulation = *model.system.contacts[contact];
  const contact::History<D>& history = model.accepted.contacts[contact];
  const contact::Surface<D>* master = formulation.master().surface();
  if (!master || !(master->sheet_data().extension.lengths[direction][at_end] > 0)) return false;
  if (elements_to_end(*master, element, direction, at_end) > 2) return false; // one of them is the extension
  if (!formulation.master().rigid() && is_held(model, *master, direction, at_end)) return false;
  for (std::size_t i = 0; i < history.results.size(); ++i)
    if (contact::touches(history.results[i].state) &&
        elements_to_end(*master, history.points[i].projection.element, direction, at_end) == 0)
      return true;
  return false;
}

} // namespace

template <int D> bool is_peak_at_edge(const Model<D>& model, int contact) {
  const contact::Formulation<D>& formulation = *model.system.contacts[contact];
  const contact::History<D>& history = model.accepted.contacts[contact];
  if (formulation.master().set()) return false; // its corners are in contact as well
  const auto pressure = [](const auto& point) { return contact::touches(point.state) ? point.pressure : 0; };
  const auto peak = std::ranges::max_element(history.results, {}, pressure);
  if (peak == history.results.end() || pressure(*peak) <= 0) return false;
  const auto place = peak - history.results.begin();
  const contact::Projection<D>& foot = history.points[place].projection;
  if (foot.foot == contact::Foot::edge || foot.foot == contact::Foot::corner) return true;

  for (int a = 0; a < D - 1; ++a)
    for (const bool at_end : {false, true}) {
      if (ends_slave(model, contact, formulation.points().list[place].element, a, at_end)) return true;
      if (ends_master(model, contact, foot.element, a, at_end)) return true;
    }
  return false;
}

template bool is_peak_at_edge(const Model<2>&, int);
template bool is_peak_at_edge(const Model<3>&, int);

} // namespace signorini::model
