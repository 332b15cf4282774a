// sg.vtu: the present state of a model for ParaView, as exact rational Bézier cells, or as linear ones.

#include "exchange/vtu.hpp"
#include "bind/geometry/patch.hpp"
#include "bind/lua/arguments.hpp"
#include "bind/lua/functions.hpp"
#include "bind/lua/open.hpp"
#include "bind/model/model.hpp"
#include "model/results/face_values.hpp"
#include "os/whole_file.hpp"
#include "tessellation/bezier_cells.hpp"
#include "view/figure.hpp"

#include <algorithm>
#include <limits>

namespace signorini::bind {

namespace {

const std::vector<std::string>& component_names(const std::string& field) {
  static const std::vector<std::string> none, stress = {"XX", "YY", "ZZ", "XY", "YZ", "XZ"},
                                              gradient = {"11", "12", "13", "21", "22", "23", "31", "32", "33"};
  return field == "stress" ? stress : field == "F" ? gradient : none;
}

/// Appends cells to a grid, with a number for each of its cell arrays; fields missing in the cells become NaN.
void append(exchange::BezierGrid& grid, const tessellation::BezierCells& cells, const std::vector<int>& numbers) {
  const Eigen::Index before = grid.points.cols(), added = cells.points.cols(), all = before + added;
  grid.degrees.insert(grid.degrees.end(), cells.degrees.begin(), cells.degrees.end());
  grid.points.conservativeResize(3, all);
  grid.points.rightCols(added) = cells.points;
  grid.weights.conservativeResize(all);
  grid.weights.tail(added) = cells.weights;
  for (exchange::PointArray& array : grid.point_arrays) {
    const Eigen::Index rows = array.values.rows();
    array.values.conservativeResize(rows, all);
    array.values.rightCols(added).setConstant(std::numeric_limits<double>::quiet_NaN());
    for (const tessellation::CellField& field : cells.fields)
      if (field.name == array.name) array.values.rightCols(added) = field.values;
  }
  for (std::size_t i = 0; i < numbers.size(); ++i)
    grid.cell_arrays[i].values.insert(grid.cell_arrays[i].values.end(), cells.degrees.size(), numbers[i]);
}

/// All bodies, then the slave faces of all contacts.
template <int D> exchange::BezierGrid grid_of(const model::Model<D>& model, bool deformed) {
  const model::Scene<D>& scene = model.system.scene;
  std::vector<tessellation::BezierCells> bodies;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    bodies.push_back(tessellation::bezier_cells(model, static_cast<int>(b), deformed));
  exchange::BezierGrid grid;
  grid.points.resize(3, 0);
  for (const tessellation::CellField& field : bodies.front().fields)
    grid.point_arrays.push_back({field.name, MatrixX(field.values.rows(), 0), component_names(field.name)});
  for (const model::FaceField field : model::face_fields)
    if (std::ranges::any_of(scene.contacts, [&](const auto& contact) { return has(contact, field); }))
      grid.point_arrays.push_back({name_of(field), MatrixX(1, 0)});
  grid.cell_arrays = {{"body", {}}, {"contact", {}}};
  grid.names = {{"body_names", names_of(scene.bodies)}, {"contact_names", names_of(scene.contacts)}};
  for (std::size_t b = 0; b < bodies.size(); ++b) append(grid, bodies[b], {static_cast<int>(b) + 1, 0});
  for (std::size_t c = 0; c < scene.contacts.size(); ++c) {
    const int contact = static_cast<int>(c);
    for (std::size_t k = 0; k < scene.contacts[c].slave.size(); ++k) {
      const int body = scene.contacts[c].slave[k].body;
      append(grid, tessellation::contact_cells(model, contact, k, bodies[body]), {body + 1, contact + 1});
    }
  }
  return grid;
}

/// The elements of a patch as cells: after repeating all knots up to the degree (Bézier extraction), its control points
/// are those of its elements.
tessellation::BezierCells cells_of(nurbs::Patch patch) {
  std::vector<int> degrees, chosen;
  int elements = 1, size = 1;
  for (int d = 0; d < patch.parametric_dimension(); ++d) {
    std::vector<double> missing;
    const nurbs::KnotVector knots = patch.direction(d);
    for (int e = 1; e < knots.elements(); ++e) {
      const double knot = knots.breaks()[e];
      missing.insert(missing.end(), knots.degree() - knots.multiplicity(knot), knot);
    }
    patch = nurbs::insert_knots(patch, d, missing);
    degrees.push_back(knots.degree());
    elements *= knots.elements();
    size *= knots.degree() + 1;
  }
  for (int e = 0; e < elements; ++e)
    for (int k = 0; k < size; ++k) {
      int point = 0, stride = 1, element = e, local = k;
      for (const nurbs::KnotVector& knots : patch.directions()) {
        const int p = knots.degree();
        point += stride * (p * (element % knots.elements()) + local % (p + 1));
        stride *= knots.functions(), element /= knots.elements(), local /= p + 1;
      }
      chosen.push_back(point);
    }
  tessellation::BezierCells cells{std::vector(elements, degrees), MatrixX::Zero(3, std::ssize(chosen)), {}, {}};
  cells.points.topRows(patch.dimension()) = patch.points()(Eigen::all, chosen);
  cells.weights = patch.weights()(chosen);
  return cells;
}

exchange::BezierGrid grid_of(const std::vector<nurbs::Patch>& patches) {
  exchange::BezierGrid grid;
  grid.points.resize(3, 0);
  grid.cell_arrays = {{"patch", {}}};
  for (std::size_t p = 0; p < patches.size(); ++p) append(grid, cells_of(patches[p]), {static_cast<int>(p) + 1});
  return grid;
}

exchange::BezierGrid read_grid(const Arguments& a) {
  if (a.has("patch")) return grid_of(patches_of(a, "patch"));
  if (!a.has("model")) a.refuse("model", "a model");
  const bool deformed = a.get("deformed", true);
  if (const Model<3>* solid = test_object<Model<3>>(a.state(), a.push("model"))) return grid_of(**solid, deformed);
  return grid_of(*a.object<Model<2>>("model"), deformed);
}

/// The highest degree of all cells, at least 2.
int default_subdivisions(const exchange::BezierGrid& grid) {
  int most = 2;
  for (const std::vector<int>& degrees : grid.degrees)
    for (int degree : degrees) most = std::max(most, degree);
  return most;
}

void vtu(const Arguments& a) {
  const auto file = a.get<std::string>("file");
  if (view::file_ending(file) != ".vtu") a.refuse("file", "a name that ends with .vtu");
  const exchange::BezierGrid grid = read_grid(a);
  if (a.get<std::string>("cells") == "bezier") return write_output(file, exchange::vtu(grid), FileKind::vtk);
  write_output(file, exchange::linear_vtu(grid, a.get("subdivisions", default_subdivisions(grid))), FileKind::vtk);
}

} // namespace

void open_vtu(lua_State* L) {
  register_functions(L, "sg", {{"vtu", call<vtu>}});
}

} // namespace signorini::bind
