// MFEM NURBS mesh v1.0 with the section "patches": a topology of vertices, edges and elements, then per patch knots and
// control points, ξ¹ fastest.
#include "base/groups.hpp"
#include "exchange/interfaces.hpp"
#include "exchange/text.hpp"

#include <algorithm>
#include <map>

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
  from.expect_numbers(static_cast<long>(dimension + 1) * size);
  MatrixX homogeneous(dimension + 1, size);
  for (int a = 0; a < size; ++a) {
    for (int i = 0; i < dimension; ++i) homogeneous(i, a) = from.number("exchange.expected.coordinate");
    homogeneous(dimension, a) = from.number("exchange.expected.weight");
    if (cartesian) homogeneous.col(a).head(dimension) *= homogeneous(dimension, a);
  }
  return placed(from.file(), from.line(), [&] { return Patch(std::move(directions), std::move(homogeneous)); });
}

// ── Topology ─────────────────────────────────────────────────────────────────────────────────────────────────────────

/// A side of an element: its number (interfaces.hpp) and vertices, in MFEM's order.
struct ElementSide {
  int number;
  std::vector<int> vertices;
};

/// Segment, square or cube in MFEM's numbering. Edges: by direction, from the first to the second vertex.
struct Element {
  int type, side_type;
  std::vector<int> vertex_of_corner; ///< corners count in binary: ξ¹ at its end 1, ξ² 2, ξ³ 4
  std::vector<ElementSide> sides;
  std::vector<std::vector<std::array<int, 2>>> edges;
};

const Element& element_of(int parametric) {
  static const Element elements[] = {
      {1, 0, {0, 1}, {{1, {0}}, {2, {1}}}, {{{0, 1}}}},
      {3, 1, {0, 1, 3, 2}, {{3, {0, 1}}, {2, {1, 2}}, {4, {2, 3}}, {1, {3, 0}}}, {{{0, 1}, {3, 2}}, {{0, 3}, {1, 2}}}},
      {5,
       3,
       {0, 1, 3, 2, 4, 5, 7, 6},
       {{5, {3, 2, 1, 0}},
        {3, {0, 1, 5, 4}},
        {2, {1, 2, 6, 5}},
        {4, {2, 3, 7, 6}},
        {1, {3, 0, 4, 7}},
        {6, {4, 5, 6, 7}}},
       {{{0, 1}, {3, 2}, {4, 5}, {7, 6}}, {{0, 3}, {1, 2}, {4, 7}, {5, 6}}, {{0, 4}, {1, 5}, {2, 6}, {3, 7}}}}};
  return elements[parametric - 1];
}

std::vector<int> sorted(std::vector<int> values) {
  std::sort(values.begin(), values.end());
  return values;
}

/// The vertices of a side of an element with these vertices, sorted.
std::vector<int> vertices_on(const std::vector<int>& vertices, const ElementSide& side) {
  std::vector<int> own;
  for (const int v : side.vertices) own.push_back(vertices[v]);
  return sorted(own);
}

/// The vertices of all elements.
using Vertices = std::vector<std::vector<int>>;

/// Faces by their vertices (sorted): MFEM identifies sides by these.
using FacesOf = std::map<std::vector<int>, std::vector<PatchFace>>;

FacesOf faces_by_vertices(const Vertices& vertices) {
  FacesOf faces;
  for (std::size_t p = 0; p < vertices.size(); ++p) {
    const int parametric = vertices[p].size() == 2 ? 1 : vertices[p].size() == 4 ? 2 : 3;
    for (const ElementSide& side : element_of(parametric).sides)
      faces[vertices_on(vertices[p], side)].push_back({static_cast<int>(p), side_of_number(side.number)});
  }
  return faces;
}

std::vector<int> read_vertices(TextReader& from, std::size_t count) {
  std::vector<int> vertices;
  while (vertices.size() < count) vertices.push_back(from.integer(0, most_functions, "exchange.expected.vertex"));
  return vertices;
}

/// An attribute or a type of element, which precede the vertices.
int read_number(TextReader& from) {
  return from.integer(0, most_functions, "exchange.expected.attribute_or_type");
}

/// Elements: attribute, type, vertices.
Vertices read_elements(TextReader& from) {
  const int count = from.integer(1, most_functions, "exchange.expected.elements");
  Vertices vertices;
  for (int i = 0; i < count; ++i) {
    read_number(from);
    const int type = read_number(from);
    if (type != 1 && type != 3 && type != 5) from.wrong("exchange.mfem.element", {{"type", type}});
    vertices.push_back(read_vertices(from, type == 1 ? 2 : type == 3 ? 4 : 8));
  }
  return vertices;
}

/// Sides of the boundary: those of one attribute are a boundary, whose name is this number.
std::vector<Boundary> read_boundary_section(TextReader& from, const FacesOf& faces) {
  const int count = from.integer(0, most_functions, "exchange.expected.sides");
  std::vector<Boundary> boundaries;
  std::map<int, std::size_t> of_attribute;
  for (int i = 0; i < count; ++i) {
    const int attribute = read_number(from);
    const int type = read_number(from);
    if (type != 0 && type != 1 && type != 3) from.wrong("exchange.mfem.element", {{"type", type}});
    const std::vector<int> own = read_vertices(from, type == 0 ? 1 : type == 1 ? 2 : 4);
    const auto [found, added] = of_attribute.emplace(attribute, boundaries.size());
    if (added) boundaries.push_back({text(attribute), {}});
    std::vector<PatchFace>& all = boundaries[found->second].faces;
    const auto named = faces.find(sorted(own));
    if (named == faces.end()) continue;
    if (named->second.size() > 2) from.wrong("exchange.mfem.shared", {{"count", named->second.size()}});
    all.insert(all.end(), named->second.begin(), named->second.end());
  }
  return boundaries;
}

/// Sides of two elements with the same vertices.
std::vector<Interface> common_sides(const Vertices& vertices, const FacesOf& faces, int parametric) {
  std::vector<Interface> interfaces;
  for (std::size_t p = 0; p < vertices.size(); ++p)
    for (const ElementSide& side : element_of(parametric).sides) {
      const std::vector<PatchFace>& own = faces.at(vertices_on(vertices[p], side));
      if (own.size() == 2 && own[0].patch == static_cast<int>(p) && own[1].patch > own[0].patch)
        interfaces.push_back({own[0], own[1]});
    }
  return interfaces;
}

/// Throws Error if MFEM would join sides that are no interface: those of two patches that share all their vertices.
void check_sides(const FacesOf& faces, const std::vector<OrientedInterface>& interfaces) {
  for (const auto& entry : faces) {
    const std::vector<PatchFace>& own = entry.second;
    if (own.size() == 1) continue;
    const bool listed = own.size() == 2 && std::any_of(interfaces.begin(), interfaces.end(), [&](const auto& one) {
                          return one.faces == Interface{own[0], own[1]} || one.faces == Interface{own[1], own[0]};
                        });
    require(listed, "exchange.mfem.same_vertices",
            {{"first", own[0].patch + 1},
             {"first_face", nurbs::name_of(own[0].side)},
             {"second", own[1].patch + 1},
             {"second_face", nurbs::name_of(own[1].side)}});
  }
}

/// Numbers of the vertices of all patches, common ones at interfaces.
Vertices number_vertices(const Geometry& geometry, const std::vector<OrientedInterface>& interfaces) {
  const int parametric = geometry.patches.front().parametric_dimension(), corners = 1 << parametric;
  Groups groups(static_cast<int>(geometry.patches.size()) * corners);
  // A corner of a face from the ends of the face's directions.
  const auto corner = [&](const PatchFace& face, const std::array<bool, 2>& ends) {
    int index = face.side.at_end ? 1 << face.side.direction : 0;
    for (int d = 0, k = 0; d < parametric; ++d)
      if (d != face.side.direction && ends[k++]) index += 1 << d;
    return face.patch * corners + index;
  };
  for (const auto& [faces, way] : interfaces)
    for (int i = 0; i < 1 << (parametric - 1); ++i) {
      const std::array<bool, 2> here{(i & 1) != 0, (i & 2) != 0};
      groups.unite(corner(faces[0], here),
                   corner(faces[1], way.turn(here, [](std::size_t, bool end) { return !end; })));
    }
  std::map<int, int> number;
  Vertices result;
  for (std::size_t p = 0; p < geometry.patches.size(); ++p) {
    const std::vector<int>& order = element_of(parametric).vertex_of_corner;
    std::vector<int> leaders(order.size());
    for (std::size_t c = 0; c < order.size(); ++c)
      leaders[order[c]] = groups.leader(static_cast<int>(p) * corners + static_cast<int>(c));
    result.emplace_back();
    for (const int leader : leaders)
      result.back().push_back(number.emplace(leader, static_cast<int>(number.size())).first->second);
  }
  return result;
}

/// The section `edges`: the knot vector of each edge, which runs from its first to its second vertex. Edges of several
/// patches must run the same way in all of them.
std::string edges_of(const Vertices& vertices, int parametric) {
  Groups knots(static_cast<int>(vertices.size()) * parametric);
  std::map<std::array<int, 2>, int> direction_of; // of one patch with the edge
  std::vector<std::array<int, 2>> order;
  for (std::size_t p = 0; p < vertices.size(); ++p)
    for (int d = 0; d < parametric; ++d)
      for (const auto& [a, b] : element_of(parametric).edges[d]) {
        const std::array<int, 2> edge{vertices[p][a], vertices[p][b]};
        require(!direction_of.contains({edge[1], edge[0]}), "exchange.mfem.opposite",
                {{"number", p + 1}, {"direction", d + 1}});
        const int own = static_cast<int>(p) * parametric + d;
        const auto [found, added] = direction_of.emplace(edge, own);
        if (added) order.push_back(edge);
        knots.unite(found->second, own);
      }
  std::map<int, int> number;
  std::string lines;
  for (const auto& edge : order) {
    const int leader = knots.leader(direction_of[edge]);
    const int own = number.emplace(leader, static_cast<int>(number.size())).first->second;
    lines += text(own, " ", edge[0], " ", edge[1], "\n");
  }
  return text(order.size(), "\n", lines);
}

/// The section `boundary`. Attributes: of one patch the numbers of its sides; of several the numbers of the named
/// boundaries, and the next number for all other faces.
std::string boundary_of(const Geometry& geometry, const Vertices& vertices,
                        const std::vector<OrientedInterface>& interfaces) {
  const Element& element = element_of(geometry.patches.front().parametric_dimension());
  const std::vector<PatchFace> outer = outer_faces(geometry, interfaces);
  const auto attribute = [&](const PatchFace& face) {
    if (geometry.boundaries.empty() && geometry.patches.size() == 1) return number_of(face.side);
    const auto named = std::find_if(geometry.boundaries.begin(), geometry.boundaries.end(), [&](const Boundary& one) {
      return std::find(one.faces.begin(), one.faces.end(), face) != one.faces.end();
    });
    return 1 + static_cast<int>(named - geometry.boundaries.begin());
  };
  std::string lines;
  for (std::size_t p = 0; p < vertices.size(); ++p)
    for (const ElementSide& side : element.sides) {
      const PatchFace face{static_cast<int>(p), side_of_number(side.number)};
      if (std::find(outer.begin(), outer.end(), face) == outer.end()) continue;
      lines += text(attribute(face), " ", element.side_type);
      for (const int v : side.vertices) lines += text(" ", vertices[p][v]);
      lines += "\n";
    }
  return text(outer.size(), "\n", lines);
}

} // namespace

Geometry read_mfem(const std::string& file, const std::string& text) {
  const std::string_view first = std::string_view(text).substr(0, text.find('\n'));
  require(first.starts_with(title), "exchange.mfem.title", {{"file", file}, {"expected", title}, {"line", first}});
  TextReader from(file, text);
  from.rest_of_line();
  Vertices vertices;
  FacesOf faces;
  Geometry geometry;
  while (from.peek() != "patches") {
    const std::string_view word = from.word("exchange.expected.patches");
    if (word == "weights") from.wrong("exchange.mfem.weights");
    if (word == "elements") {
      vertices = read_elements(from);
      faces = faces_by_vertices(vertices);
    }
    if (word == "boundary") geometry.boundaries = read_boundary_section(from, faces);
  }
  from.keyword("patches");
  while (from.peek() == "knotvectors") geometry.patches.push_back(read_patch(from));
  if (geometry.patches.empty()) from.keyword("knotvectors");
  if (geometry.patches.size() != vertices.size())
    from.wrong("exchange.mfem.patches", {{"expected", vertices.size()}, {"count", geometry.patches.size()}});
  const int parametric = geometry.patches.front().parametric_dimension();
  for (std::size_t p = 0; p < vertices.size(); ++p)
    if (vertices[p].size() != std::size_t{1} << geometry.patches[p].parametric_dimension() ||
        geometry.patches[p].parametric_dimension() != parametric)
      from.wrong("exchange.mfem.mixed", {{"number", p + 1}});
  geometry.interfaces = common_sides(vertices, faces, parametric);
  return geometry;
}

std::string mfem(const Geometry& geometry) {
  const int parametric = geometry.patches.front().parametric_dimension();
  for (std::size_t p = 0; p < geometry.patches.size(); ++p)
    require(geometry.patches[p].parametric_dimension() == parametric, "exchange.mfem.mixed", {{"number", p + 1}});
  const std::vector<OrientedInterface> interfaces = interfaces_of(geometry);
  const Vertices vertices = number_vertices(geometry, interfaces);
  check_sides(faces_by_vertices(vertices), interfaces);
  const Element& element = element_of(parametric);
  std::string out = text(title, "\n\ndimension\n", parametric, "\n\nelements\n", vertices.size(), "\n");
  int last = 0;
  for (const std::vector<int>& own : vertices) {
    out += text("1 ", element.type);
    for (const int v : own) {
      out += text(" ", v);
      last = std::max(last, v);
    }
    out += "\n";
  }
  out += text("\nboundary\n", boundary_of(geometry, vertices, interfaces), "\nedges\n", edges_of(vertices, parametric),
              "\nvertices\n", last + 1, "\n\npatches\n");
  for (const Patch& patch : geometry.patches) {
    out += text("\nknotvectors\n", parametric, "\n");
    for (const KnotVector& knots : patch.directions())
      out += text(knots.degree(), " ", knots.functions(), " ", line_of(knots.knots()));
    out += text("\ndimension\n", patch.dimension(), "\n\ncontrolpoints\n");
    for (int a = 0; a < patch.functions(); ++a) out += line_of(patch.homogeneous().col(a));
  }
  return out;
}

} // namespace signorini::exchange
