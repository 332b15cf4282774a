// sg.vtu: a model's present state for ParaView, as exact rational Bézier cells.

#include "exchange/vtu.hpp"
#include "base/whole_file.hpp"
#include "bind/arguments.hpp"
#include "bind/functions.hpp"
#include "bind/model.hpp"
#include "bind/open.hpp"
#include "bind/patch.hpp"
#include "tessellation/bezier_cells.hpp"
#include "view/figure.hpp"

#include <limits>

namespace signorini::bind {

namespace {

const std::vector<std::string>& component_names(const std::string& field) {
  static const std::vector<std::string> none, stress = {"XX", "YY", "ZZ", "XY", "YZ", "XZ"},
                                              gradient = {"11", "12", "13", "21", "22", "23", "31", "32", "33"};
  return field == "stress" ? stress : field == "F" ? gradient : none;
}

/// Puts cells at the end of a grid; where they lack one of its fields it is not a number.
void append(exchange::BezierGrid& grid, const tessellation::BezierCells& cells, int body, int contact) {
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
  const std::vector<int> values = {body, contact};
  for (std::size_t i = 0; i < values.size(); ++i)
    grid.cell_arrays[i].values.insert(grid.cell_arrays[i].values.end(), cells.degrees.size(), values[i]);
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
  if (!scene.contacts.empty()) grid.point_arrays.push_back({"contact_pressure", MatrixX(1, 0)});
  grid.cell_arrays = {{"body", {}}, {"contact", {}}};
  grid.names = {{"body_names", names_of(scene.bodies)}, {"contact_names", names_of(scene.contacts)}};
  for (std::size_t b = 0; b < bodies.size(); ++b) append(grid, bodies[b], static_cast<int>(b) + 1, 0);
  for (std::size_t c = 0; c < scene.contacts.size(); ++c) {
    const int contact = static_cast<int>(c), body = scene.contacts[c].slave.body;
    append(grid, tessellation::contact_cells(model, contact, bodies[static_cast<std::size_t>(body)]), body + 1,
           contact + 1);
  }
  return grid;
}

/// A patch's elements as cells: with knots repeated up to the degree its control points are those of its elements.
void append(exchange::BezierGrid& grid, nurbs::Patch patch, int number) {
  const int n = patch.parametric_dimension();
  for (int d = 0; d < n; ++d) {
    std::vector<double> missing;
    const nurbs::KnotVector knots = patch.direction(d);
    for (int e = 1; e < knots.elements(); ++e) {
      const double knot = knots.breaks()[static_cast<std::size_t>(e)];
      missing.insert(missing.end(), static_cast<std::size_t>(knots.degree() - knots.multiplicity(knot)), knot);
    }
    patch = nurbs::insert_knots(patch, d, missing);
  }
  std::vector<int> degrees, chosen;
  int elements = 1, size = 1;
  for (const nurbs::KnotVector& knots : patch.directions()) {
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
  const MatrixX points = patch.points();
  const VectorX weights = patch.weights();
  const auto added = static_cast<Eigen::Index>(chosen.size()), all = grid.points.cols() + added;
  grid.points.conservativeResize(3, all);
  grid.points.rightCols(added).setZero();
  grid.points.block(0, all - added, patch.dimension(), added) = points(Eigen::all, chosen);
  grid.weights.conservativeResize(all);
  grid.weights.tail(added) = weights(chosen);
  grid.degrees.insert(grid.degrees.end(), static_cast<std::size_t>(elements), degrees);
  grid.cell_arrays[0].values.insert(grid.cell_arrays[0].values.end(), static_cast<std::size_t>(elements), number);
}

exchange::BezierGrid grid_of(const std::vector<nurbs::Patch>& patches) {
  exchange::BezierGrid grid;
  grid.points.resize(3, 0);
  grid.cell_arrays = {{"patch", {}}};
  for (std::size_t p = 0; p < patches.size(); ++p) append(grid, patches[p], static_cast<int>(p) + 1);
  return grid;
}

exchange::BezierGrid read_grid(lua_State* L, const Arguments& a) {
  if (a.has("patch")) {
    for (const char* key : {"model", "deformed"})
      if (a.has(key)) a.fail(key, " is for models, and patch is not part of one: leave one of them out");
    return grid_of(patches_of(a, "patch"));
  }
  if (!a.has("model")) a.refuse("model", "a model");
  const bool deformed = a.get("deformed", true);
  if (const Model<3>* solid = test_object<Model<3>>(L, a.push("model"))) return grid_of(**solid, deformed);
  return grid_of(*a.object<Model<2>>("model"), deformed);
}

int vtu(lua_State* L) {
  const Arguments a(L);
  const auto file = a.get<std::string>("file");
  if (view::file_ending(file) != ".vtu") a.refuse("file", "a name that ends with .vtu");
  write_whole(file, exchange::vtu(read_grid(L, a)));
  return 0;
}

constexpr Function vtu_entries[] = {{"vtu", vtu}};

} // namespace

void open_vtu(lua_State* L) {
  register_functions(L, "sg", vtu_entries);
}

} // namespace signorini::bind
