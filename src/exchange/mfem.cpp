// MFEM NURBS mesh v1.0 with the section "patches": a topology of vertices, edges and elements, then per patch knots and
// control points, ξ¹ fastest.
#include "exchange/text.hpp"

namespace signorini::exchange {

namespace {

constexpr const char* title = "MFEM NURBS mesh v1.0";

Patch read_patch(TextReader& from) {
  from.keyword("knotvectors");
  const int parametric = from.integer(1, 3, "exchange.expected.knot_vectors");
  std::vector<KnotVector> directions;
  int size = 1;
  for (int d = 0; d < parametric; ++d) {
    const int degree = from.integer(1, nurbs::max_degree, "exchange.expected.degree");
    const int functions = from.integer(degree + 1, most_functions / size, "exchange.expected.functions");
    directions.push_back(read_knots(from, degree, functions));
    size *= functions;
  }
  from.keyword("dimension");
  const int dimension = from.integer(2, 3, "exchange.expected.dimension");
  const std::string_view kind = from.word("exchange.expected.points");
  const bool cartesian = kind == "controlpoints_cartesian";
  if (!cartesian && kind != "controlpoints" && kind != "controlpoints_homogeneous")
    from.wrong("exchange.mfem.points", {{"word", kind}});
  MatrixX homogeneous(dimension + 1, size);
  for (int a = 0; a < size; ++a) {
    for (int i = 0; i < dimension; ++i) homogeneous(i, a) = from.number("exchange.expected.coordinate");
    homogeneous(dimension, a) = from.number("exchange.expected.weight");
    if (cartesian) homogeneous.col(a).head(dimension) *= homogeneous(dimension, a);
  }
  return placed(from.file(), from.line(), [&] { return Patch(std::move(directions), std::move(homogeneous)); });
}

/// Vertices of the square and the cube in MFEM's numbering. An edge: its direction and its end points; a side: its
/// attribute (west 1, east 2, south 3, north 4, front 5, back 6) and vertices.
struct Topology {
  int vertices, element;
  const char *corners, *sides, *edges;
};

constexpr Topology topologies[] = {
    {2, 1, "0 1", "2\n1 0 0\n2 0 1\n", "1\n0 0 1\n"},
    {4, 3, "0 1 2 3", "4\n3 1 0 1\n2 1 1 2\n4 1 2 3\n1 1 3 0\n", "4\n0 0 1\n0 3 2\n1 0 3\n1 1 2\n"},
    {8, 5, "0 1 2 3 4 5 6 7", "6\n5 3 3 2 1 0\n3 3 0 1 5 4\n2 3 1 2 6 5\n4 3 2 3 7 6\n1 3 3 0 4 7\n6 3 4 5 6 7\n",
     "12\n0 0 1\n0 3 2\n0 4 5\n0 7 6\n1 0 3\n1 1 2\n1 4 7\n1 5 6\n2 0 4\n2 1 5\n2 2 6\n2 3 7\n"}};

} // namespace

std::vector<Patch> read_mfem(const std::string& file, const std::string& text) {
  const std::string_view first = std::string_view(text).substr(0, text.find('\n'));
  require(first.starts_with(title), "exchange.mfem.title", {{"file", file}, {"expected", title}, {"line", first}});
  TextReader from(file, text);
  from.rest_of_line();
  int elements = 0;
  while (from.peek() != "patches") {
    const std::string_view word = from.word("exchange.expected.patches");
    if (word == "weights") from.wrong("exchange.mfem.weights");
    if (word == "elements") elements = from.integer(1, most_functions, "exchange.expected.elements");
  }
  from.keyword("patches");
  std::vector<Patch> patches;
  while (from.peek() == "knotvectors") patches.push_back(read_patch(from));
  if (patches.empty()) from.keyword("knotvectors");
  if (static_cast<int>(patches.size()) != elements)
    from.wrong("exchange.mfem.patches", {{"expected", elements}, {"count", patches.size()}});
  return patches;
}

std::string mfem(const std::vector<Patch>& patches) {
  require(patches.size() == 1, "exchange.mfem.one_patch", {{"count", patches.size()}});
  const Patch& patch = patches.front();
  const int parametric = patch.parametric_dimension();
  const Topology& topology = topologies[parametric - 1];
  std::string out = text(title, "\n\ndimension\n", parametric, "\n\nelements\n1\n1 ", topology.element, " ",
                         topology.corners, "\n\nboundary\n", topology.sides, "\nedges\n", topology.edges,
                         "\nvertices\n", topology.vertices, "\n\npatches\n\nknotvectors\n", parametric, "\n");
  for (const KnotVector& knots : patch.directions())
    out += text(knots.degree(), " ", knots.functions(), " ", line_of(knots.knots()));
  out += text("\ndimension\n", patch.dimension(), "\n\ncontrolpoints\n");
  for (int a = 0; a < patch.functions(); ++a) out += line_of(patch.homogeneous().col(a));
  return out;
}

} // namespace signorini::exchange
