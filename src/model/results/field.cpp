#include "model/results/field.hpp"

#include "base/error.hpp"
#include "model/results/face_values.hpp"
#include "solid/projection.hpp"

#include <cmath>

namespace signorini::model {

namespace {

using solid::Material;

template <int D> Mat<3> cauchy_stress(const Material& material, const FieldPoint<D>& point) {
  const Mat<3> f = solid::in_space<D>(point.deformation, point.hoop);
  return material.cauchy_stress(solid::dilated(material.small_strains(), f, point.dilation), {point.internal, {}, 0});
}

template <int D, int I> double displacement(const Material&, const FieldPoint<D>& point) {
  return point.displacement(I);
}

template <int D> double displacement_norm(const Material&, const FieldPoint<D>& point) {
  return point.displacement.norm();
}

template <int D, int I, int J> double stress(const Material& material, const FieldPoint<D>& point) {
  return cauchy_stress<D>(material, point)(I, J);
}

template <int D> double trace(const Material& material, const FieldPoint<D>& point) {
  return cauchy_stress<D>(material, point).trace();
}

template <int D> double pressure(const Material& material, const FieldPoint<D>& point) {
  return -trace<D>(material, point) / 3;
}

template <int D> double von_mises(const Material& material, const FieldPoint<D>& point) {
  const Mat<3> sigma = cauchy_stress<D>(material, point);
  // √(3/2 s:s), s = σ − tr σ/3 I
  return std::sqrt(1.5 * (sigma - sigma.trace() / 3 * Mat<3>::Identity()).squaredNorm());
}

template <int D, int I, int J> double gradient(const Material&, const FieldPoint<D>& point) {
  return point.deformation(I, J);
}

template <int D> std::vector<Field<D>> common_fields() {
  return {
      {"ux", "displacement u_x", displacement<D, 0>},          {"uy", "displacement u_y", displacement<D, 1>},
      {"u", "displacement |u|", displacement_norm<D>},         {"sxx", "Cauchy stress σ_xx", stress<D, 0, 0>, true},
      {"syy", "Cauchy stress σ_yy", stress<D, 1, 1>, true},    {"szz", "Cauchy stress σ_zz", stress<D, 2, 2>, true},
      {"sxy", "Cauchy stress σ_xy", stress<D, 0, 1>, true},    {"von_mises", "von Mises stress", von_mises<D>, true},
      {"pressure", "pressure −tr σ/3", pressure<D>, true},     {"I1", "first stress invariant tr σ", trace<D>, true},
      {"F11", "deformation gradient F_11", gradient<D, 0, 0>}, {"F12", "deformation gradient F_12", gradient<D, 0, 1>},
      {"F21", "deformation gradient F_21", gradient<D, 1, 0>}, {"F22", "deformation gradient F_22", gradient<D, 1, 1>}};
}

} // namespace

template <> const std::vector<Field<2>>& fields<2>() {
  static const std::vector<Field<2>> all = [] {
    std::vector<Field<2>> list = common_fields<2>();
    list.push_back(
        {"F33", "deformation gradient F_33", [](const Material&, const FieldPoint<2>& point) { return point.hoop; }});
    return list;
  }();
  return all;
}

template <> const std::vector<Field<3>>& fields<3>() {
  static const std::vector<Field<3>> all = [] {
    std::vector<Field<3>> list = common_fields<3>();
    list.push_back({"uz", "displacement u_z", displacement<3, 2>});
    list.push_back({"sxz", "Cauchy stress σ_xz", stress<3, 0, 2>, true});
    list.push_back({"syz", "Cauchy stress σ_yz", stress<3, 1, 2>, true});
    list.push_back({"F13", "deformation gradient F_13", gradient<3, 0, 2>});
    list.push_back({"F23", "deformation gradient F_23", gradient<3, 1, 2>});
    list.push_back({"F31", "deformation gradient F_31", gradient<3, 2, 0>});
    list.push_back({"F32", "deformation gradient F_32", gradient<3, 2, 1>});
    list.push_back({"F33", "deformation gradient F_33", gradient<3, 2, 2>});
    return list;
  }();
  return all;
}

template <int D> const Field<D>& find_field(const std::string& name) {
  std::vector<std::string> known;
  for (const Field<D>& field : fields<D>()) {
    if (field.name == name) return field;
    known.push_back(field.name);
  }
  for (const FaceField field : face_fields) known.emplace_back(name_of(field));
  fail("model.field.unknown", {{"field", name}, {"known", known}});
}

template const Field<2>& find_field<2>(const std::string&);
template const Field<3>& find_field<3>(const std::string&);

} // namespace signorini::model
