#include "bind/picture/state_picture.hpp"

#include "bind/geometry/patch.hpp"
#include "bind/lua/number_text.hpp"
#include "bind/model/model.hpp"
#include "figure/frame.hpp"
#include "model/system/free_angles.hpp"

#include <numeric>

namespace signorini::bind {

namespace {

using figure::Cut;
using figure::Showing;

// ── Camera and part ──────────────────────────────────────────────────────────────────────────────────────────────────

Vec<3> read_direction(const Arguments& a, const char* key) {
  const Vec<3> direction = a.get<VectorX>(key);
  if (direction.norm() == 0) a.refuse(key, "a vector that is not zero");
  return direction;
}

Vec<3> axis_of(const std::string& name) {
  return (name[0] == '-' ? -1.0 : 1.0) * Vec<3>::Unit(name.back() - 'x');
}

/// "y", or { normal = …, point = … }, or { normal = "y", at = … }.
std::optional<Cut> read_cut(const Arguments& a) {
  if (!a.has("cut")) return std::nullopt;
  if (a.is("cut", LUA_TSTRING)) return Cut{axis_of(a.get<std::string>("cut"))};
  const Arguments c = a.table("cut");
  const bool along_axis = c.is("normal", LUA_TSTRING);
  Cut cut{along_axis ? axis_of(c.get<std::string>("normal")) : read_direction(c, "normal")};
  if (c.has("at")) {
    if (!along_axis) c.fail("at needs an axis as normal, such as \"y\"; with a vector use point");
    if (c.has("point")) c.fail("has both at and point: remove one of the two");
    cut.point = c.get<double>("at") * cut.normal.cwiseAbs();
  }
  if (c.has("point")) cut.point = c.get<VectorX>("point");
  return cut;
}

/// By default the camera faces the cut.
view::Camera read_camera(const Arguments& a, const std::optional<Cut>& cut) {
  const view::Camera standard = view::camera("iso");
  if (!a.has("camera")) return cut ? view::turned_to(standard, cut->normal) : standard;
  if (a.is("camera", LUA_TSTRING)) return view::camera(a.get<std::string>("camera"));
  const Arguments c = a.table("camera");
  const Vec<3> from = read_direction(c, "from");
  const bool steep = from.head<2>().norm() < 1e-6 * from.norm();
  return {from, c.has("up") ? Vec<3>(c.get<VectorX>("up")) : steep ? Vec<3>::UnitY() : Vec<3>::UnitZ()};
}

/// The box in argument `key`; z = 0 in the plane.
std::optional<view::Bounds> read_box(const Arguments& a, const char* key, bool solid) {
  if (!a.has(key)) return std::nullopt;
  const auto box = a.get<std::vector<double>>(key);
  const std::string names = text("{xmin, xmax, ymin, ymax", solid ? ", zmin, zmax}" : "}");
  if (box.size() != (solid ? 6 : 4)) a.refuse(key, text("a list of ", solid ? 6 : 4, " numbers ", names));
  view::Bounds bounds{Vec<3>::Zero(), Vec<3>::Zero()};
  std::string numbers;
  bool rises = true;
  for (std::size_t i = 0; i < box.size(); ++i) {
    (i % 2 == 0 ? bounds.low : bounds.high)[static_cast<Eigen::Index>(i / 2)] = box[i];
    rises = rises && (i % 2 == 0 || box[i - 1] < box[i]);
    numbers += text(i == 0 ? "" : ", ", box[i]);
  }
  if (!rises) a.fail(key, " is {", numbers, "}; expected ", names, " with min below max");
  return bounds;
}

/// The parts shown alone or magnified; adds their windows to `showing`.
void read_parts(const Arguments& a, StatePicture& picture, Showing& showing, const std::array<int, 2>& size) {
  const auto& camera = picture.options.camera;
  const Mat<3> axes = camera ? view::picture_axes(*camera) : Mat<3>(Mat<3>::Identity());
  const auto crop = read_box(a, "crop", camera.has_value()), inset = read_box(a, "inset", camera.has_value());
  for (const auto& box : {crop, inset})
    if (box) showing.windows.push_back(box_window(axes.topRows<2>(), box->low, box->high, size));
  if (inset) {
    picture.inset = picture.options;
    picture.inset->crop = inset;
    picture.inset->bar = picture.inset->axis_names = picture.inset->ruler = false;
    picture.inset->trim = true;
    picture.inset->vectors.clear(); // one key for both, because their arrows have the same scale
  }
  picture.options.crop = crop;
}

// ── Contents ─────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Entries may have all fields of the places of a failed run.
std::vector<view::PointMark> read_marks(const Arguments& a, int dimension) {
  std::vector<view::PointMark> marks;
  if (!a.has("marks")) return marks;
  a.list("marks", [&](int, int index, const std::string& path) {
    const Arguments mark(a.state(), index, path);
    const auto place = mark.get<VectorX>("x");
    if (place.size() != dimension)
      mark.refuse("x", dimension == 2 ? "a list of 2 numbers {x, y}" : "a list of 3 numbers {x, y, z}");
    view::PointMark& one = marks.emplace_back(view::PointMark{Vec<3>::Zero(), mark.get<std::string>("text")});
    one.at.head(dimension) = place;
  });
  return marks;
}

Showing read_showing(const Arguments& a, const std::string& field) {
  Showing showing;
  showing.field = field;
  a.read("factor", showing.factor, "deformed", showing.deformed, "undeformed", showing.undeformed, "mesh", showing.mesh,
         "control_points", showing.control_points, "obstacles", showing.obstacles, "names", showing.names, "mirror",
         showing.mirror, "vectors", showing.vectors);
  return showing;
}

/// true, a number of lines, or a list of values.
view::Contours read_contours(const Arguments& a) {
  if (a.is("contours", LUA_TBOOLEAN)) return {};
  if (a.is("contours", LUA_TNUMBER)) return {a.get<int>("contours")};
  return {0, a.get<std::vector<double>>("contours")};
}

/// The lines, arrows and names drawn in addition to the colors.
void read_lines(const Arguments& a, view::PictureOptions& options, const Showing& showing, bool solid) {
  if (a.has("contours")) options.contours = read_contours(a);
  options.vectors = showing.vectors;
  if (showing.vectors == "displacement") options.vector_unit = options.unit;
  options.axes = a.get<std::vector<std::string>>("axes");
  if (const std::size_t count = solid ? 3 : 2; a.has("axes") && options.axes.size() != count)
    a.refuse("axes", text("a list of ", count, " names"));
}

/// Options common to models and patches; completes `showing`.
StatePicture read_view(const Arguments& a, Showing& showing, bool solid, const std::optional<Cut>& cut,
                       const std::array<int, 2>& size) {
  for (const char* key : {"cut", "camera", "ruler"})
    if (!solid && a.has(key)) a.fail(key, " is for models of solids, but this model is plane: omit it");
  if (!solid && showing.mirror.find('z') != std::string::npos) a.refuse("mirror", "'x', 'y' or 'xy' of plane models");
  if (!showing.deformed && a.has("marks"))
    a.fail("marks are in the present state, which deformed = false hides: remove one of the two");
  if (!showing.deformed && showing.vectors == "traction")
    a.fail("tractions act in the present state, which deformed = false hides: remove one of the two");
  StatePicture picture;
  view::PictureOptions& options = picture.options;
  a.read("colormap", options.colormap, "bar", options.bar, "unit", options.unit, "ruler", options.ruler, "range",
         options.range);
  read_lines(a, options, showing, solid);
  if (solid) options.camera = read_camera(a, cut);
  read_parts(a, picture, showing, size);
  for (char letter : showing.mirror)
    for (std::size_t i = 0, count = showing.windows.size(); i < count; ++i)
      showing.windows.push_back(mirrored(showing.windows[i], letter - 'x'));
  return picture;
}

Picture finished(const Arguments& a, StatePicture picture, const std::string& title, std::size_t count, const char* one,
                 const char* several) {
  picture.panel.marks = read_marks(a, picture.options.camera ? 3 : 2);
  picture.options.title = title;
  const std::string& label = picture.options.field_label;
  const std::string description = text("picture", title.empty() ? "" : " '" + title + "'", " of ", count, " ",
                                       count == 1 ? one : several, label.empty() ? "" : ", colored by " + label);
  return figure::make_picture(std::move(picture), description);
}

// ── Models and patches ───────────────────────────────────────────────────────────────────────────────────────────────

template <int D> std::string read_label(const Arguments& a, const Showing& showing) {
  if (showing.field.empty()) return "";
  const auto on_faces = model::face_field(showing.field);
  const std::string name = on_faces ? label_of(*on_faces) : model::find_field<D>(showing.field).label;
  if (a.has("label")) return a.get<std::string>("label");
  return showing.factor == 1 ? name : number_text(showing.factor) + " × " + name;
}

/// Displaces a model's present state by a mode, if there is one, until destroyed.
template <int D> class Displaced {
public:
  Displaced(const Arguments& a, Model<D> model) : model_(std::move(model)), before_(model_->present.displacement) {
    if (!a.has("mode")) return;
    if (!a.get<bool>("deformed"))
      a.fail("mode displaces the present state, which deformed = false hides: remove one of the two");
    const auto& system = model_->system;
    const auto shape = a.table("mode").get<VectorX>("mode");
    if (shape.size() != system.unknowns.free_displacements()) a.refuse("mode", "a mode of this model");
    VectorX mode = VectorX::Zero(system.unknowns.size());
    mode.head(shape.size()) = a.get("amplitude", default_amplitude * system.extent) * shape;
    model_->present.displacement += system.unknowns.spread(mode);
    model::follow_angles(system.unknowns, model_->present.displacement);
  }
  ~Displaced() { model_->present.displacement = before_; }
  Displaced(const Displaced&) = delete;
  Displaced& operator=(const Displaced&) = delete;

private:
  static constexpr double default_amplitude = 0.1; ///< relative to the bodies
  Model<D> model_;
  VectorX before_;
};

template <int D>
Picture read_model(const Arguments& a, const Model<D>& model, const std::string& field, const std::string& title,
                   const std::array<int, 2>& size) {
  Showing showing = read_showing(a, field);
  if (a.has("bodies")) {
    for (const auto& name : a.get<std::vector<std::string>>("bodies"))
      for (const int body : find_bodies(*model, name)) showing.bodies.push_back(body);
  } else {
    showing.bodies.resize(model->system.scene.bodies.size());
    std::iota(showing.bodies.begin(), showing.bodies.end(), 0);
  }
  for (const auto& name : a.get<std::vector<std::string>>("gray"))
    for (const int body : find_bodies(*model, name)) showing.gray.push_back(body);
  const std::optional<Cut> cut = D == 3 ? read_cut(a) : std::nullopt;
  StatePicture picture = read_view(a, showing, D == 3, cut, size);
  picture.options.field_label = read_label<D>(a, showing);
  if (picture.inset) picture.inset->field_label = picture.options.field_label;
  const Displaced<D> displaced(a, model);
  picture.panel = figure::show(*model, showing, cut);
  return finished(a, std::move(picture), title, showing.bodies.size(), "body", "bodies");
}

Picture read_patch(const Arguments& a, const std::string& title, const std::array<int, 2>& size) {
  const std::vector<nurbs::Patch> patches = patches_of(a, "patch");
  Showing showing = read_showing(a, "");
  StatePicture picture = read_view(a, showing, patches.front().dimension() == 3, {}, size);
  picture.panel = figure::show(patches, showing);
  return finished(a, std::move(picture), title, patches.size(), "patch", "patches");
}

/// Restores the state of a model when destroyed.
template <int D> class Return {
public:
  explicit Return(Model<D> model) : model_(std::move(model)), state_(model::snapshot(*model_)) {}
  ~Return() { model::restore(*model_, state_); }
  Return(const Return&) = delete;
  Return& operator=(const Return&) = delete;

private:
  Model<D> model_;
  model::Snapshot<D> state_;
};

template <int D>
Picture read_snapshot(const Arguments& a, const Snapshot<D>& snapshot, const std::string& field,
                      const std::string& title, const std::array<int, 2>& size) {
  if (a.has("model")) {
    const auto* named = test_object<Model<D>>(a.state(), a.push("model"));
    if (!named || *named != snapshot.model) a.fail("model is not the model of the stored state: omit it");
  }
  const Return<D> back(snapshot.model);
  model::restore(*snapshot.model, snapshot.state);
  return read_model<D>(a, snapshot.model, field, title, size);
}

} // namespace

Picture read_state_picture(const Arguments& a, const std::string& field, int state, const std::string& title,
                           const std::array<int, 2>& size) {
  lua_State* L = a.state();
  if (state != 0) {
    lua_getfield(L, state, "snapshot");
    const int snapshot = lua_gettop(L);
    if (const auto* solid = test_object<Snapshot<3>>(L, snapshot))
      return read_snapshot<3>(a, *solid, field, title, size);
    return read_snapshot<2>(a, read_object<Snapshot<2>>(L, snapshot, {"state"}), field, title, size);
  }
  if (a.has("patch")) return read_patch(a, title, size);
  const int model = a.push("model");
  if (const auto* solid = test_object<Model<3>>(L, model)) return read_model<3>(a, *solid, field, title, size);
  if (const auto* plane = test_object<Model<2>>(L, model)) return read_model<2>(a, *plane, field, title, size);
  a.refuse("model", "a model");
}

} // namespace signorini::bind
