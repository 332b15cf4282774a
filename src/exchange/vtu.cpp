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

/// Corners, edges, faces and interior of a hexahedron in VTK's order: in each direction at its start, its end, or
/// between.
constexpr std::string_view parts_of_hexahedron[] = {"000", "100", "110", "010", "001", "101", "111", "011", "*00",
                                                    "1*0", "*10", "0*0", "*01", "1*1", "*11", "0*1", "00*", "10*",
                                                    "11*", "01*", "0**", "1**", "*0*", "*1*", "**0", "**1", "***"};

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
  std::vector<int> order;
  for (const std::string_view part : parts_of_hexahedron) {
    // In fewer directions those parts at whose start the others lie
    if (part.find_first_not_of('0', dimension) != part.npos) continue;
    int from[3] = {0, 0, 0}, to[3] = {0, 0, 0};
    for (std::size_t d = 0; d < dimension; ++d) {
      from[d] = part[d] == '0' ? 0 : part[d] == '1' ? degrees[d] : 1;
      to[d] = part[d] == '*' ? degrees[d] - 1 : from[d];
    }
    const int row = degrees[0] + 1, layer = dimension > 1 ? row * (degrees[1] + 1) : 0;
    for (int k = from[2]; k <= to[2]; ++k)
      for (int j = from[1]; j <= to[1]; ++j)
        for (int i = from[0]; i <= to[0]; ++i) order.push_back(i + row * j + layer * k);
  }
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
    const int rows = dimension > 1 ? n : 1, layers = dimension > 2 ? n : 1;
    for (int k = 0; k < layers; ++k)
      for (int j = 0; j < rows; ++j)
        for (int i = 0; i < n; ++i) {
          for (int c = 0; c < 1 << dimension; ++c)
            cells.connectivity.push_back(first + stride[0] * (i + corners[c][0]) + stride[1] * (j + corners[c][1]) +
                                         stride[2] * (k + corners[c][2]));
          cells.add(cell_types[dimension - 1], static_cast<std::int64_t>(cells.connectivity.size()));
        }
    first += (n + 1) * (dimension > 1 ? n + 1 : 1) * (dimension > 2 ? n + 1 : 1);
    cells.copies.push_back(n * rows * layers);
  }
  cells.points.resize(first);
  std::iota(cells.points.begin(), cells.points.end(), 0);
  return document(samples, cells, {}, {});
}

} // namespace signorini::exchange
