#include "contact/method/former_coordinates.hpp"

#include "contact/rigid/near_point.hpp"

#include <type_traits>

namespace signorini::contact {

namespace {

/// cos φ a + sin φ b
template <class Vector> Vector direction_at(double angle, const Vector& a, const Vector& b) {
  return std::cos(angle) * a + std::sin(angle) * b;
}

} // namespace

template <int D> Vec<D> former_place(const Plane<D>& plane, const FaceCoordinates<D>& xi) {
  const auto directions = across(plane.normal);
  Vec<D> place = plane.point;
  for (int a = 0; a < D - 1; ++a) place += xi(a) * directions[at(a)];
  return place;
}

Vec<2> former_place(const Ball<2>& ball, const FaceCoordinates<2>& xi) {
  const double angle = ball.hollow ? -xi(0) : xi(0);
  return ball.center + ball.radius * direction_at<Vec<2>>(angle, Vec<2>::UnitX(), Vec<2>::UnitY());
}

Vec<3> former_place(const Ball<3>& ball, const FaceCoordinates<3>& xi) {
  const auto aside = direction_at<Vec<3>>(xi(0), Vec<3>::UnitX(), Vec<3>::UnitY());
  return ball.center + ball.radius * direction_at<Vec<3>>(xi(1), Vec<3>::UnitZ(), aside);
}

Vec<3> former_place(const Cylinder& cylinder, const FaceCoordinates<3>& xi) {
  const auto [a, b] = across(cylinder.axis);
  return cylinder.point + cylinder.radius * direction_at(xi(0), a, b) + xi(1) * cylinder.axis;
}

Vec<3> former_place(const Torus& torus, const FaceCoordinates<3>& xi) {
  const auto [a, b] = across(torus.axis);
  const Vec<3> out = direction_at(xi(0), a, b);
  return torus.center + torus.ring * out + torus.radius * direction_at(xi(1), out, torus.axis);
}

template <int D> void update_coordinates(const Obstacle<D>& obstacle, History<D>& history) {
  std::visit(
      [&](const auto& shape) {
        using Shape = std::decay_t<decltype(shape)>;
        if constexpr (!std::is_same_v<Shape, nurbs::Patch> && !std::is_same_v<Shape, LevelSet<D>>)
          for (PointHistory<D>& point : history.points)
            for (FaceCoordinates<D>* xi : {&point.projection.xi, &point.slip.xi})
              *xi = closest(shape, former_place(shape, *xi));
      },
      obstacle);
}

#define SIGNORINI_INSTANTIATE(D)                                                                                       \
  template Vec<D> former_place(const Plane<D>&, const FaceCoordinates<D>&);                                            \
  template void update_coordinates(const Obstacle<D>&, History<D>&);
SIGNORINI_INSTANTIATE(2)
SIGNORINI_INSTANTIATE(3)
#undef SIGNORINI_INSTANTIATE

} // namespace signorini::contact
