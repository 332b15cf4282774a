// The text file of GeoPDEs and the NURBS toolbox (geo_specs_v07, geo_specs_v21 and their multipatch forms): a line of
// sizes, then for each patch degrees, numbers of control points, knots, weighted coordinates row by row, weights.
#include "exchange/interfaces.hpp"
#include "exchange/text.hpp"

#include <algorithm>
#include <cctype>

namespace signorini::exchange {

namespace {

/// Contents of the first line. Version 0.7: dimension, patches, interfaces, subdomains, the later ones optional; 1.0
/// and 2.1: parametric dimension, space dimension, patches, interfaces, subdomains.
struct Sizes {
  int parametric, dimension, patches, interfaces;
};

Sizes read_sizes(TextReader& from, const std::string& file) {
  if (from.at_end()) fail("exchange.geopdes.comments", {{"file", file}});
  const int first = from.integer(1, 3, "exchange.expected.parameters"), line = from.line();
  std::vector<int> sizes = {first};
  TextReader rest(file, from.rest_of_line(), line);
  while (!rest.at_end()) sizes.push_back(rest.integer(0, most_functions, "exchange.expected.size"));
  if (sizes.size() > 5) rest.wrong("exchange.geopdes.sizes", {{"count", sizes.size()}});
  Sizes result = {first, first, sizes.size() > 1 ? sizes[1] : 1, sizes.size() > 2 ? sizes[2] : 0};
  if (sizes.size() == 5) result = {first, sizes[1], sizes[2], sizes[3]};
  if (result.dimension < 2 || result.dimension > 3 || result.dimension < result.parametric)
    rest.wrong("exchange.geopdes.dimension", {{"parameters", result.parametric}, {"dimension", result.dimension}});
  if (result.patches < 1) rest.wrong("exchange.geopdes.no_patch", {{"count", result.patches}});
  return result;
}

Patch read_patch(TextReader& from, const Sizes& sizes) {
  const std::string_view next = from.peek();
  // The line with the patch's name is optional.
  if (!next.empty() && std::string_view("+-.0123456789").find(next.front()) == std::string_view::npos) {
    const std::string_view name = from.word("exchange.expected.patch_name");
    if (name == "INTERFACE" || name == "SUBDOMAIN" || name == "BOUNDARY")
      from.wrong("exchange.geopdes.patches", {{"expected", sizes.patches}, {"word", name}});
    from.rest_of_line();
  }
  std::vector<int> degrees, counts;
  for (int d = 0; d < sizes.parametric; ++d)
    degrees.push_back(from.integer(1, nurbs::max_degree, "exchange.expected.degree"));
  int size = 1;
  for (int d = 0; d < sizes.parametric; ++d) {
    counts.push_back(from.integer(2, most_functions / size, "exchange.expected.functions"));
    size *= counts.back();
  }
  std::vector<KnotVector> directions;
  for (std::size_t d = 0; d < degrees.size(); ++d) directions.push_back(read_knots(from, degrees[d], counts[d]));
  from.expect_numbers(static_cast<long>(sizes.dimension + 1) * size);
  MatrixX homogeneous(sizes.dimension + 1, size);
  for (int i = 0; i <= sizes.dimension; ++i)
    for (int a = 0; a < size; ++a)
      homogeneous(i, a) =
          from.number(i < sizes.dimension ? "exchange.expected.weighted_coordinate" : "exchange.expected.weight");
  return placed(from.file(), from.line(), [&] { return Patch(std::move(directions), std::move(homogeneous)); });
}

bool number_follows(TextReader& from) {
  const std::string_view next = from.peek();
  return !next.empty() && std::string_view("+-0123456789").find(next.front()) != std::string_view::npos;
}

PatchFace read_face(TextReader& from, const Sizes& sizes) {
  const int patch = from.integer(1, sizes.patches, "exchange.expected.patch_number") - 1;
  return {patch, side_of_number(from.integer(1, 2 * sizes.parametric, "exchange.expected.side"))};
}

Interface read_interface(TextReader& from, const Sizes& sizes) {
  if (from.peek().starts_with("INTERFACE")) {
    from.word("exchange.expected.interface");
    from.rest_of_line();
  }
  const PatchFace first = read_face(from, sizes), second = read_face(from, sizes);
  for (int i = 0; i < (sizes.parametric == 3 ? 3 : 1); ++i) from.integer(-1, 1, "exchange.expected.orientation");
  return {first, second};
}

/// The name of a boundary: what follows its number, otherwise the number.
std::string boundary_name(std::string_view line) {
  const auto trimmed = [](std::string_view words) {
    while (!words.empty() && std::isspace(static_cast<unsigned char>(words.front()))) words.remove_prefix(1);
    while (!words.empty() && std::isspace(static_cast<unsigned char>(words.back()))) words.remove_suffix(1);
    return words;
  };
  const std::string_view all = trimmed(line);
  const auto digits =
      std::find_if_not(all.begin(), all.end(), [](unsigned char c) { return std::isdigit(c) != 0; }) - all.begin();
  const std::string_view name = trimmed(all.substr(static_cast<std::size_t>(digits)));
  return std::string(name.empty() ? all : name);
}

/// Subdomains, which are skipped, and boundaries.
std::vector<Boundary> read_boundaries(TextReader& from, const Sizes& sizes) {
  std::vector<Boundary> boundaries;
  while (!from.at_end()) {
    const bool boundary = from.word("exchange.expected.boundary") == "BOUNDARY";
    const std::string name = boundary_name(from.rest_of_line());
    if (!boundary) {
      while (number_follows(from)) from.integer(0, most_functions, "exchange.expected.patch_number");
      continue;
    }
    boundaries.push_back({name, {}});
    const int count = from.integer(0, 6 * sizes.patches, "exchange.expected.sides");
    for (int i = 0; i < count; ++i) boundaries.back().faces.push_back(read_face(from, sizes));
  }
  return boundaries;
}

} // namespace

Geometry read_geopdes(const std::string& file, const std::string& text) {
  TextReader from(file, text);
  const Sizes sizes = read_sizes(from, file);
  Geometry geometry;
  while (static_cast<int>(geometry.patches.size()) < sizes.patches) geometry.patches.push_back(read_patch(from, sizes));
  if (sizes.interfaces > 0) geometry.interfaces.emplace();
  for (int i = 0; i < sizes.interfaces; ++i) geometry.interfaces->push_back(read_interface(from, sizes));
  geometry.boundaries = read_boundaries(from, sizes);
  return geometry;
}

std::string geopdes(const Geometry& geometry) {
  const std::vector<Patch>& patches = geometry.patches;
  const int parametric = patches.front().parametric_dimension(), dimension = patches.front().dimension();
  std::string out, numbers;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    const Patch& patch = patches[i];
    require(patch.parametric_dimension() == parametric && patch.dimension() == dimension, "exchange.geopdes.mixed",
            {{"number", i}});
    numbers += text(i == 0 ? "" : " ", i + 1);
    out += text("PATCH ", i + 1, "\n");
    std::vector<int> degrees, counts;
    for (const KnotVector& knots : patch.directions()) {
      degrees.push_back(knots.degree());
      counts.push_back(knots.functions());
    }
    out += line_of(degrees) + line_of(counts);
    for (const KnotVector& knots : patch.directions()) out += line_of(knots.knots());
    for (int row = 0; row <= dimension; ++row) out += line_of(patch.homogeneous().row(row));
  }
  const std::vector<OrientedInterface> interfaces = interfaces_of(geometry);
  const auto face = [](const PatchFace& one) { return text(one.patch + 1, " ", number_of(one.side), "\n"); };
  for (std::size_t i = 0; i < interfaces.size(); ++i) {
    const auto& [faces, way] = interfaces[i];
    const auto sign = [](bool reversed) { return reversed ? "-1" : "1"; };
    out += text("INTERFACE ", i + 1, "\n", face(faces[0]), face(faces[1]));
    // In space first whether the two directions correspond in their order.
    out += parametric == 3 ? text(sign(way.to[0] == 1), " ", sign(way.flip[0]), " ", sign(way.flip[1]), "\n")
                           : text(sign(way.flip[0]), "\n");
  }
  out += text("SUBDOMAIN 1\n", numbers, "\n");
  for (std::size_t i = 0; i < geometry.boundaries.size(); ++i) {
    const auto& [name, faces] = geometry.boundaries[i];
    out += text("BOUNDARY ", i + 1, " ", name, "\n", faces.size(), "\n");
    for (const PatchFace& one : faces) out += face(one);
  }
  return text("# nurbs geometry v.2.1\n#\n", parametric, " ", dimension, " ", patches.size(), " ", interfaces.size(),
              " 1\n") +
         out;
}

} // namespace signorini::exchange
