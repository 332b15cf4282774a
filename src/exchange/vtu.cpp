#include "exchange/vtu.hpp"

#include "base/base64.hpp"
#include "base/error.hpp"
#include "exchange/sampled.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <numeric>

namespace signorini::exchange {

namespace {

static_assert(std::endian::native == std::endian::little, "the header says LittleEndian");

template <class T> constexpr const char* type_name() {
  return sizeof(T) == 1 ? "UInt8" : sizeof(T) == 4 ? "Int32" : std::is_integral_v<T> ? "Int64" : "Float64";
}

std::string xml_text(const std::string& text) {
  std::string result;
  for (char c : text) result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  return result;
}

/// An array in the file: its size in bytes, then the bytes.
template <class T>
std::string data_array(const std::string& name, const std::vector<T>& values, Eigen::Index components = 0,
                       const std::vector<std::string>& component_names = {}) {
  std::string attributes;
  if (components > 0) attributes = text(" NumberOfComponents=\"", components, "\"");
  for (std::size_t i = 0; i < component_names.size(); ++i)
    attributes += text(" ComponentName", i, "=\"", xml_text(component_names[i]), "\"");
  const std::uint64_t size = values.size() * sizeof(T);
  std::string bytes(sizeof size + size, '\0');
  std::memcpy(bytes.data(), &size, sizeof size);
  if (size > 0) std::memcpy(bytes.data() + sizeof size, values.data(), size);
  return text("        <DataArray type=\"", type_name<T>(), "\" Name=\"", xml_text(name), "\"", attributes,
              " format=\"binary\">\n          ", base64(bytes), "\n        </DataArray>\n");
}

/// Texts in VTK's representation: the codes of their bytes, each text terminated by 0.
std::string string_array(const NameList& list) {
  std::string codes;
  for (const std::string& entry : list.entries) {
    for (char c : entry) codes += text(static_cast<int>(static_cast<unsigned char>(c)), " ");
    codes += "0 ";
  }
  return text("      <Array type=\"String\" Name=\"", xml_text(list.name), "\" NumberOfTuples=\"", list.entries.size(),
              "\" format=\"ascii\">\n        ", codes, "\n      </Array>\n");
}

std::vector<double> columns(const MatrixX& values, const std::vector<Eigen::Index>& order) {
  std::vector<double> result;
  result.reserve(static_cast<std::size_t>(values.size()));
  for (Eigen::Index point : order)
    for (Eigen::Index i = 0; i < values.rows(); ++i) result.push_back(values(i, point));
  return result;
}

/// The cells of a file.
struct Cells {
  std::vector<Eigen::Index> points; ///< those of the grid, in the order of the file
  std::vector<std::int64_t> connectivity, offsets;
  std::vector<std::uint8_t> types;
  std::vector<int> copies; ///< by cell of the grid the number of its cells in the file

  void add(std::uint8_t type, std::int64_t end) {
    types.push_back(type);
    offsets.push_back(end);
  }
};

/// Arrays of one kind of file: attributes of the section, and its text.
struct OwnArrays {
  std::string attributes, arrays;
};

std::string document(const BezierGrid& grid, const Cells& cells, const OwnArrays& at_points,
                     const OwnArrays& in_cells) {
  require(static_cast<Eigen::Index>(cells.points.size()) == grid.points.cols(), "exchange.vtu.points",
          {{"cell_points", cells.points.size()}, {"grid_points", grid.points.cols()}});
  std::string out = "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"2.2\" "
                    "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n  <UnstructuredGrid>\n    <FieldData>\n";
  for (const NameList& list : grid.names) out += string_array(list);
  out += text("    </FieldData>\n    <Piece NumberOfPoints=\"", cells.points.size(), "\" NumberOfCells=\"",
              cells.types.size(), "\">\n      <PointData", at_points.attributes, ">\n", at_points.arrays);
  for (const PointArray& array : grid.point_arrays)
    out += data_array(array.name, columns(array.values, cells.points), array.values.rows(), array.components);
  out += text("      </PointData>\n      <CellData", in_cells.attributes, ">\n", in_cells.arrays);
  for (const CellArray& array : grid.cell_arrays) {
    std::vector<int> values;
    for (std::size_t cell = 0; cell < array.values.size(); ++cell)
      values.insert(values.end(), static_cast<std::size_t>(cells.copies[cell]), array.values[cell]);
    out += data_array(array.name, values, 1);
  }
  out += "      </CellData>\n      <Points>\n" + data_array("Points", columns(grid.points, cells.points), 3);
  out += "      </Points>\n      <Cells>\n" + data_array("connectivity", cells.connectivity) +
         data_array("offsets", cells.offsets) + data_array("types", cells.types);
  return out + "      </Cells>\n    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n";
}

} // namespace

std::vector<int> vtk_order(const std::vector<int>& degrees) {
  const std::size_t dimension = degrees.size();
  require(dimension >= 1 && dimension <= 3, "exchange.vtu.directions", {{"count", dimension}});
  const int p = degrees[0], q = dimension > 1 ? degrees[1] : 0, r = dimension > 2 ? degrees[2] : 0;
  std::vector<int> order;
  const auto add = [&](int i, int j, int k) { order.push_back(i + (p + 1) * (j + (q + 1) * k)); };
  // Corners of the quadrilateral at k, then interior points of its edges, each by increasing index
  const auto corners = [&](int k) { add(0, 0, k), add(p, 0, k), add(p, q, k), add(0, q, k); };
  const auto edges = [&](int k) {
    for (int i = 1; i < p; ++i) add(i, 0, k);
    for (int j = 1; j < q; ++j) add(p, j, k);
    for (int i = 1; i < p; ++i) add(i, q, k);
    for (int j = 1; j < q; ++j) add(0, j, k);
  };
  const auto inside = [&](int k) {
    for (int j = 1; j < q; ++j)
      for (int i = 1; i < p; ++i) add(i, j, k);
  };
  if (dimension == 1) {
    add(0, 0, 0), add(p, 0, 0);
    for (int i = 1; i < p; ++i) add(i, 0, 0);
    return order;
  }
  if (dimension == 2) {
    corners(0), edges(0), inside(0);
    return order;
  }
  corners(0), corners(r), edges(0), edges(r);
  for (const auto [i, j] : {std::array{0, 0}, std::array{p, 0}, std::array{p, q}, std::array{0, q}})
    for (int k = 1; k < r; ++k) add(i, j, k);
  for (int i : {0, p})
    for (int k = 1; k < r; ++k)
      for (int j = 1; j < q; ++j) add(i, j, k);
  for (int j : {0, q})
    for (int k = 1; k < r; ++k)
      for (int i = 1; i < p; ++i) add(i, j, k);
  inside(0), inside(r);
  for (int k = 1; k < r; ++k) inside(k);
  return order;
}

std::string vtu(const BezierGrid& grid) {
  constexpr std::array<std::uint8_t, 3> cell_types = {75, 77, 79}; // VTK_BEZIER_CURVE, _QUADRILATERAL, _HEXAHEDRON
  Cells cells;
  std::vector<double> degrees; // VTK expects degrees as arrays with three components
  for (const std::vector<int>& cell : grid.degrees) {
    const auto first = static_cast<Eigen::Index>(cells.points.size());
    for (int point : vtk_order(cell)) cells.points.push_back(first + point);
    cells.add(cell_types[cell.size() - 1], static_cast<std::int64_t>(cells.points.size()));
    for (std::size_t d = 0; d < 3; ++d) degrees.push_back(d < cell.size() ? cell[d] : 0);
  }
  cells.connectivity.resize(cells.points.size());
  std::iota(cells.connectivity.begin(), cells.connectivity.end(), 0);
  cells.copies.assign(grid.degrees.size(), 1);
  const std::string weights = data_array("RationalWeights", columns(grid.weights.transpose(), cells.points), 1);
  return document(grid, cells, {" RationalWeights=\"RationalWeights\"", weights},
                  {" HigherOrderDegrees=\"HigherOrderDegrees\"", data_array("HigherOrderDegrees", degrees, 3)});
}

std::string linear_vtu(const BezierGrid& grid, int subdivisions) {
  constexpr std::array<std::uint8_t, 3> cell_types = {3, 9, 12}; // VTK_LINE, _QUAD, _HEXAHEDRON
  // Corners of a part in VTK's order, as steps along ξ¹, ξ², ξ³
  constexpr int corners[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                 {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const BezierGrid samples = sampled(grid, subdivisions);
  const int n = subdivisions, stride[3] = {1, n + 1, (n + 1) * (n + 1)};
  Cells cells;
  std::int64_t first = 0;
  for (const std::vector<int>& cell : samples.degrees) {
    const std::size_t dimension = cell.size();
    int parts = 1, points = 1;
    for (std::size_t d = 0; d < dimension; ++d) parts *= n, points *= n + 1;
    for (int part = 0; part < parts; ++part) {
      int corner = 0;
      for (std::size_t d = 0, rest = static_cast<std::size_t>(part); d < dimension;
           ++d, rest /= static_cast<std::size_t>(n))
        corner += stride[d] * static_cast<int>(rest % static_cast<std::size_t>(n));
      for (int k = 0; k < 1 << dimension; ++k) {
        int point = corner;
        for (std::size_t d = 0; d < dimension; ++d) point += stride[d] * corners[k][d];
        cells.connectivity.push_back(first + point);
      }
      cells.add(cell_types[dimension - 1], static_cast<std::int64_t>(cells.connectivity.size()));
    }
    first += points;
    cells.copies.push_back(parts);
  }
  cells.points.resize(first);
  std::iota(cells.points.begin(), cells.points.end(), 0);
  return document(samples, cells, {}, {});
}

} // namespace signorini::exchange
