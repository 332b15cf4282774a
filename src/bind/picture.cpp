#include "view/picture.hpp"

#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "bind/scene.hpp"
#include "model/sample.hpp"

namespace signorini::bind {

namespace {

/// Pieces per element and direction: enough that a quadratic arc over an eighth of a circle looks round at any size.
constexpr int divisions = 12;

view::Body picture_body(model::Tessellation&& sampled, bool mesh, bool control_points) {
  view::Body body;
  body.points = std::move(sampled.points);
  body.triangles = std::move(sampled.triangles);
  body.values = std::move(sampled.values);
  if (mesh) body.mesh_lines.assign(sampled.mesh_lines.begin(), sampled.mesh_lines.end());
  if (control_points) {
    body.control_points = std::move(sampled.control_points);
    body.net_lines = std::move(sampled.net_lines);
  }
  return body;
}

int picture(lua_State* L) {
  const Options o(
      L, 1,
      {"model", "field", "file", "size", "range", "colormap", "deformed", "mesh", "control_points", "crop", "title"});
  const Model& model = o.object<Model>("model", "made by sg.model");
  const std::string file = o.string("file", "a name that ends with .png");
  view::PictureOptions options;
  const model::Field<2>* field = nullptr;
  if (o.has("field")) {
    field = &model::find_field<2>(o.string("field", "such as \"uy\" or \"von_mises\""));
    options.field_label = field->label;
  }
  options.title = o.string("title", "line above the picture", "");
  options.colormap = o.choice("colormap", "colours of the field", view::colormaps(), options.colormap);
  if (o.has("size")) {
    const Argument argument = o.argument("size", "width and height in pixels");
    const auto size = read_integers(L, o.push_value("size"), argument, 100, 10000);
    if (size.size() != 2) reject(L, -1, argument, "a list of 2 whole numbers");
    options.size = {size[0], size[1]};
  }
  if (o.has("range")) {
    const VectorX range = o.point("range", "lowest and highest value", 2, 2);
    options.range = {range[0], range[1]};
  }
  if (o.has("crop")) {
    const std::vector<double> crop = o.numbers("crop", "xmin, xmax, ymin, ymax");
    if (crop.size() != 4)
      reject(L, o.push_value("crop"), o.argument("crop", "xmin, xmax, ymin, ymax"), "a list of 4 numbers");
    options.crop = {crop[0], crop[1], crop[2], crop[3]};
  }
  const bool deformed = o.flag("deformed", "draw the present state, not the reference", true);
  const bool mesh = o.flag("mesh", "draw element borders", true);
  const bool control_points = o.flag("control_points", "draw control points and their rows", false);
  std::vector<view::Body> bodies;
  for (int b = 0; b < static_cast<int>(model->scene().bodies.size()); ++b)
    bodies.push_back(picture_body(model::tessellate(*model, b, field, divisions, deformed), mesh, control_points));
  view::draw_picture(bodies, options, file);
  return 0;
}

constexpr Function rows[] = {
    {"picture", wrap<picture>,
     "sg.picture{ model, file, field, title, range, colormap = \"viridis\", size = {1600, 1000}, deformed = true,\n"
     "            mesh = true, control_points = false, crop }\n"
     "Draws the model's present state to a .png file. field: ux uy u, Cauchy stresses sxx syy szz sxy, von_mises,\n"
     "pressure, I1 (tr sigma), F11 F12 F21 F22; grey without. Stresses are evaluated where they are drawn, not "
     "smoothed.\n"
     "range = {low, high} of the colours; crop = {xmin, xmax, ymin, ymax}.\n"
     "Example: sg.picture{ model = model, field = \"uy\", file = \"die.png\" }"},
};

} // namespace

void open_picture(lua_State* L) {
  register_functions(L, "sg", rows);
}

} // namespace signorini::bind
