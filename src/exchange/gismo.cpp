// G+Smo's XML: elements <Geometry> with a tensor basis of knot vectors, weights in the basis, and control points that
// are not multiplied by their weights, ξ¹ fastest.
#include "exchange/interfaces.hpp"
#include "exchange/text.hpp"

#include <algorithm>
#include <map>
#include <pugixml.hpp>
#include <sstream>

namespace signorini::exchange {

namespace {

/// Text of a file and the lines of its positions.
struct Document {
  const std::string& file;
  std::vector<std::ptrdiff_t> ends = {}; ///< of its lines

  Document(const std::string& name, const std::string& text) : file(name) {
    for (std::size_t i = text.find('\n'); i != std::string::npos; i = text.find('\n', i + 1))
      ends.push_back(static_cast<std::ptrdiff_t>(i));
  }
  int line(std::ptrdiff_t offset) const {
    return 1 + static_cast<int>(std::lower_bound(ends.begin(), ends.end(), offset) - ends.begin());
  }
  [[noreturn]] void wrong(const pugi::xml_node& node, const char* code, std::initializer_list<Datum> data) const {
    fail_at(file, line(node.offset_debug()), Message(code, data));
  }
  pugi::xml_node child(const pugi::xml_node& parent, const char* name) const {
    const pugi::xml_node result = parent.child(name);
    if (!result) wrong(parent, "exchange.gismo.no_child", {{"element", parent.name()}, {"child", name}});
    return result;
  }
  /// A reader of the content of an element.
  TextReader inside(const pugi::xml_node& node) const {
    const std::string_view form = node.attribute("format").as_string("ASCII");
    if (form != "ASCII" && form != "ascii")
      wrong(node, "exchange.gismo.not_ascii", {{"element", node.name()}, {"form", form}});
    const pugi::xml_node content = node.first_child();
    return {file, content.value(), line(content.offset_debug()), false};
  }
};

int whole_number(const Document& document, const pugi::xml_node& node, const char* attribute, int low, int high) {
  const std::string text = node.attribute(attribute).value();
  return TextReader(document.file, text, document.line(node.offset_debug()))
      .integer(low, high, "exchange.expected.attribute", {{"attribute", attribute}, {"element", node.name()}});
}

KnotVector read_direction(const Document& document, const pugi::xml_node& basis) {
  const std::string type = basis.attribute("type").value();
  if (type != "BSplineBasis")
    document.wrong(basis, "exchange.gismo.basis", {{"expected", "BSplineBasis"}, {"type", type}});
  const pugi::xml_node node = document.child(basis, "KnotVector");
  const int degree = whole_number(document, node, "degree", 1, nurbs::max_degree);
  TextReader from = document.inside(node);
  std::vector<double> knots;
  while (!from.at_end()) knots.push_back(from.number("exchange.expected.knot"));
  return placed(document.file, document.line(node.offset_debug()),
                [&] { return KnotVector(degree, std::move(knots)); });
}

/// Supported patches, by the types of their element and its basis.
struct Kind {
  const char *type, *basis;
  int directions;
  bool rational;
};
constexpr Kind kinds[] = {{"BSpline", "BSplineBasis", 1, false},
                          {"TensorBSpline2", "TensorBSplineBasis2", 2, false},
                          {"TensorBSpline3", "TensorBSplineBasis3", 3, false},
                          {"Nurbs", "NurbsBasis", 1, true},
                          {"TensorNurbs2", "TensorNurbsBasis2", 2, true},
                          {"TensorNurbs3", "TensorNurbsBasis3", 3, true}};

Patch read_patch(const Document& document, const pugi::xml_node& geometry) {
  const std::string type = geometry.attribute("type").value();
  const auto* kind =
      std::find_if(std::begin(kinds), std::end(kinds), [&](const Kind& one) { return one.type == type; });
  if (kind == std::end(kinds)) document.wrong(geometry, "exchange.gismo.geometry", {{"type", type}});
  pugi::xml_node basis = document.child(geometry, "Basis");
  pugi::xml_node weights;
  if (basis.attribute("type").value() != std::string(kind->basis))
    document.wrong(basis, "exchange.gismo.basis",
                   {{"expected", kind->basis}, {"type", basis.attribute("type").value()}});
  if (kind->rational) {
    weights = document.child(basis, "weights");
    basis = document.child(basis, "Basis");
  }
  std::vector<pugi::xml_node> nodes{basis};
  if (kind->directions > 1) nodes.assign(basis.children("Basis").begin(), basis.children("Basis").end());
  if (static_cast<int>(nodes.size()) != kind->directions)
    document.wrong(basis, "exchange.gismo.bases", {{"expected", kind->directions}, {"count", nodes.size()}});
  std::stable_sort(nodes.begin(), nodes.end(), [](const auto& a, const auto& b) {
    return a.attribute("index").as_int() < b.attribute("index").as_int();
  });
  std::vector<KnotVector> directions;
  for (const pugi::xml_node& node : nodes) directions.push_back(read_direction(document, node));

  int size = 1;
  for (const KnotVector& knots : directions) {
    if (knots.functions() > most_functions / size)
      document.wrong(geometry, "exchange.gismo.size", {{"most", most_functions}});
    size *= knots.functions();
  }
  const pugi::xml_node coefficients = document.child(geometry, "coefs");
  const int dimension = whole_number(document, coefficients, "geoDim", 2, 3);
  const auto read = [&](const pugi::xml_node& node, int rows, const char* expected) {
    TextReader from = document.inside(node);
    from.expect_numbers(static_cast<long>(rows) * size);
    MatrixX values(rows, size);
    for (int a = 0; a < size; ++a)
      for (int i = 0; i < rows; ++i) {
        if (from.at_end())
          from.wrong("exchange.gismo.too_few",
                     {{"element", node.name()}, {"count", a * rows + i}, {"expected", size * rows}});
        values(i, a) = from.number(expected);
      }
    if (!from.at_end()) from.wrong("exchange.gismo.too_many", {{"element", node.name()}, {"expected", size * rows}});
    return values;
  };
  const MatrixX points = read(coefficients, dimension, "exchange.expected.coordinate");
  const VectorX all = weights ? VectorX(read(weights, 1, "exchange.expected.weight").row(0).transpose()) : VectorX();
  return placed(document.file, document.line(geometry.offset_debug()),
                [&] { return make_patch(std::move(directions), points, all); });
}

std::string basis_of(const Patch& patch, const std::string& indent) {
  std::string out;
  const int directions = patch.parametric_dimension();
  for (int d = 0; d < directions; ++d) {
    const std::string own = directions > 1 ? indent + "  " : indent;
    out += text(own, "<Basis type=\"BSplineBasis\"", directions > 1 ? text(" index=\"", d, "\"") : "", ">\n", own,
                "  <KnotVector degree=\"", patch.direction(d).degree(), "\">");
    for (double knot : patch.direction(d).knots()) out += digits(knot) + " ";
    out += "</KnotVector>\n" + own + "</Basis>\n";
  }
  if (directions == 1) return out;
  return text(indent, "<Basis type=\"TensorBSplineBasis", directions, "\">\n", out, indent, "</Basis>\n");
}

/// Reads the faces of <interfaces> and <boundary>, which name patches by their ids.
struct TopologyReader {
  const Document& document;
  const std::map<int, int>& index; ///< of the patch with an id
  const std::vector<Patch>& patches;

  PatchFace face(TextReader& from) const {
    const int id = from.integer(0, most_functions, "exchange.expected.patch_id");
    const auto found = index.find(id);
    if (found == index.end()) from.wrong("exchange.gismo.patch_id", {{"id", id}});
    const int sides = 2 * patches[found->second].parametric_dimension();
    return {found->second, side_of_number(from.integer(1, sides, "exchange.expected.side"))};
  }
  /// An interface continues with the second face's direction for each of the first, and whether it runs along it; the
  /// geometry says so, too.
  Interface interface(TextReader& from) const {
    const PatchFace first = face(from), second = face(from);
    const int directions = patches[first.patch].parametric_dimension();
    for (int d = 0; d < directions; ++d) from.integer(0, 2, "exchange.expected.direction");
    for (int d = 0; d < directions; ++d) from.integer(0, 1, "exchange.expected.orientation");
    return {first, second};
  }
  /// All that one of these functions reads from the content of an element.
  template <class Item>
  std::vector<Item> all(const pugi::xml_node& node, Item (TopologyReader::*read)(TextReader&) const) const {
    std::vector<Item> result;
    if (!node.first_child()) return result;
    for (TextReader from = document.inside(node); !from.at_end();) result.push_back((this->*read)(from));
    return result;
  }
};

/// The element <MultiPatch>, without which G+Smo reads the patches separately.
std::string topology_of(const Geometry& geometry) {
  const int parametric = geometry.patches.front().parametric_dimension();
  std::string out = text("  <MultiPatch parDim=\"", parametric, "\" id=\"", geometry.patches.size(),
                         "\">\n    <patches type=\"id_range\">0 ", geometry.patches.size() - 1, "</patches>\n");
  const auto face = [](const PatchFace& one) { return text(one.patch, " ", number_of(one.side)); };
  const std::vector<OrientedInterface> interfaces = interfaces_of(geometry);
  if (!interfaces.empty()) {
    out += "    <interfaces>";
    for (const auto& [faces, way] : interfaces) {
      std::vector<int> direction(parametric), same(direction);
      for (int d = 0, k = 0; d < parametric; ++d) {
        const std::size_t i = d, own = k;
        if (d == faces[0].side.direction) {
          direction[i] = faces[1].side.direction;
          same[i] = faces[0].side.at_end != faces[1].side.at_end;
          continue;
        }
        const int other = static_cast<int>(way.to[own]);
        direction[i] = other + (other >= faces[1].side.direction ? 1 : 0);
        same[i] = !way.flip[own];
        ++k;
      }
      out += text(face(faces[0]), " ", face(faces[1]));
      for (const int d : direction) out += text(" ", d);
      for (const int one : same) out += text(" ", one);
      out += "\n";
    }
    out += "</interfaces>\n";
  }
  std::vector<PatchFace> unnamed = outer_faces(geometry, interfaces);
  const auto add_boundary = [&](const char* name, const std::vector<PatchFace>& faces) {
    pugi::xml_document one;
    pugi::xml_node node = one.append_child("boundary");
    if (name) node.append_attribute("name").set_value(name);
    std::string lines;
    for (const PatchFace& own : faces) lines += face(own) + "\n";
    node.text().set(lines.c_str());
    std::ostringstream printed;
    node.print(printed, "", pugi::format_raw);
    out += "    " + printed.str() + "\n";
  };
  for (const auto& [name, faces] : geometry.boundaries) {
    for (const PatchFace& one : faces) std::erase(unnamed, one);
    add_boundary(name.c_str(), faces);
  }
  if (!unnamed.empty()) add_boundary(nullptr, unnamed);
  return out + "  </MultiPatch>\n";
}

} // namespace

Geometry read_gismo(const std::string& file, const std::string& text) {
  pugi::xml_document parsed;
  const Document document{file, text};
  const pugi::xml_parse_result parsing = parsed.load_buffer(text.data(), text.size());
  require(parsing, "exchange.gismo.xml",
          {{"file", file}, {"line", document.line(parsing.offset)}, {"reason", parsing.description()}});
  Geometry result;
  std::map<int, int> index;
  for (const pugi::xpath_node& geometry : parsed.select_nodes("//Geometry")) {
    index.emplace(geometry.node().attribute("id").as_int(-1), static_cast<int>(result.patches.size()));
    result.patches.push_back(read_patch(document, geometry.node()));
  }
  require(!result.patches.empty(), "exchange.gismo.nothing", {{"file", file}});
  const TopologyReader reader{document, index, result.patches};
  const pugi::xml_node whole = parsed.select_node("//MultiPatch").node();
  if (const pugi::xml_node interfaces = whole.child("interfaces"))
    result.interfaces = reader.all(interfaces, &TopologyReader::interface);
  for (const pugi::xml_node& boundary : whole.children("boundary"))
    if (const std::string name = boundary.attribute("name").value(); !name.empty())
      result.boundaries.push_back({name, reader.all(boundary, &TopologyReader::face)});
  return result;
}

std::string gismo(const Geometry& geometry) {
  const std::vector<Patch>& patches = geometry.patches;
  std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<xml>\n";
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const Patch& patch = patches[i];
    const int directions = patch.parametric_dimension();
    const VectorX weights = patch.weights();
    const bool rational = (weights.array() != 1).any();
    const std::string name = text(directions > 1 ? "Tensor" : "", rational ? "Nurbs" : "BSpline");
    const std::string number = directions > 1 ? text(directions) : "";
    out += text("  <Geometry type=\"", name, number, "\" id=\"", i, "\">\n");
    if (rational) {
      out += text("    <Basis type=\"", name, "Basis", number, "\">\n", basis_of(patch, "      "), "      <weights>\n");
      for (double weight : weights) out += digits(weight) + "\n";
      out += "      </weights>\n    </Basis>\n";
    } else {
      out += basis_of(patch, "    ");
    }
    out += text("    <coefs geoDim=\"", patch.dimension(), "\">\n");
    const MatrixX points = patch.points();
    for (int a = 0; a < patch.functions(); ++a) out += line_of(points.col(a));
    out += "    </coefs>\n  </Geometry>\n";
  }
  const int parametric = patches.front().parametric_dimension();
  const bool alike = std::all_of(patches.begin(), patches.end(),
                                 [&](const Patch& patch) { return patch.parametric_dimension() == parametric; });
  const bool named = geometry.interfaces || !geometry.boundaries.empty();
  if (alike && (patches.size() > 1 || named)) out += topology_of(geometry);
  return out + "</xml>\n";
}

} // namespace signorini::exchange
