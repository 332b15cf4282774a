// The text file of GeoPDEs and the NURBS toolbox (geo_specs_v07, geo_specs_v21 and their multipatch forms): a line of
// sizes, then for each patch degrees, numbers of control points, knots, weighted coordinates row by row, weights.
#include "exchange/text.hpp"

namespace signorini::exchange {

namespace {

/// Contents of the first line. Version 0.7: dimension, patches, interfaces, subdomains, the later ones optional; 1.0
/// and 2.1: parametric dimension, space dimension, patches, interfaces, subdomains.
struct Sizes {
  int parametric, dimension, patches;
};

Sizes read_sizes(TextReader& from, const std::string& file) {
  if (from.at_end()) fail("exchange.geopdes.comments", {{"file", file}});
  const int first = from.integer(1, 3, "exchange.expected.parameters"), line = from.line();
  std::vector<int> sizes = {first};
  TextReader rest(file, from.rest_of_line(), line);
  while (!rest.at_end()) sizes.push_back(rest.integer(0, most_functions, "exchange.expected.size"));
  if (sizes.size() > 5) rest.wrong("exchange.geopdes.sizes", {{"count", sizes.size()}});
  Sizes result = {first, first, sizes.size() > 1 ? sizes[1] : 1};
  if (sizes.size() == 5) result = {first, sizes[1], sizes[2]};
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
  MatrixX homogeneous(sizes.dimension + 1, size);
  for (int i = 0; i <= sizes.dimension; ++i)
    for (int a = 0; a < size; ++a)
      homogeneous(i, a) =
          from.number(i < sizes.dimension ? "exchange.expected.weighted_coordinate" : "exchange.expected.weight");
  return placed(from.file(), from.line(), [&] { return Patch(std::move(directions), std::move(homogeneous)); });
}

} // namespace

std::vector<Patch> read_geopdes(const std::string& file, const std::string& text) {
  TextReader from(file, text);
  const Sizes sizes = read_sizes(from, file);
  std::vector<Patch> patches;
  while (static_cast<int>(patches.size()) < sizes.patches) patches.push_back(read_patch(from, sizes));
  return patches; // interfaces, subdomains and boundaries follow
}

std::string geopdes(const std::vector<Patch>& patches) {
  const int parametric = patches.front().parametric_dimension(), dimension = patches.front().dimension();
  std::string out = text("# nurbs geometry v.2.1\n#\n", parametric, " ", dimension, " ", patches.size(), " 0 1\n");
  std::string numbers;
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
  return out + "SUBDOMAIN 1\n" + numbers + "\n";
}

} // namespace signorini::exchange
