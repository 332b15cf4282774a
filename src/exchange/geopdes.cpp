// The text file of GeoPDEs and the NURBS toolbox (geo_specs_v07, geo_specs_v21 and their multipatch forms): a line of
// sizes, then per patch degrees, numbers of control points, knots, weighted coordinates row by row, weights.
#include "exchange/text.hpp"

namespace signorini::exchange {

namespace {

/// What the first line says. Version 0.7: dimension, patches, interfaces, subdomains, the later ones optional; 1.0 and
/// 2.1: parametric dimension, dimension of space, patches, interfaces, subdomains.
struct Sizes {
  int parametric, dimension, patches;
};

Sizes read_sizes(TextReader& from, const std::string& file) {
  if (from.at_end()) fail(file, ": the file holds comments only");
  const int first = from.integer("the dimension of the parameters", 1, 3), line = from.line();
  std::vector<int> sizes = {first};
  TextReader rest(file, from.rest_of_line(), line);
  while (!rest.at_end()) sizes.push_back(rest.integer("a size", 0, most_functions));
  if (sizes.size() > 5) rest.wrong("expected up to 5 sizes in this line, got ", sizes.size());
  Sizes result = {first, first, sizes.size() > 1 ? sizes[1] : 1};
  if (sizes.size() == 5) result = {first, sizes[1], sizes[2]};
  if (result.dimension < 2 || result.dimension > 3 || result.dimension < result.parametric)
    rest.wrong("patches of ", result.parametric, " parameters in space of dimension ", result.dimension,
               " cannot be taken over: expected dimension 2 or 3");
  if (result.patches < 1) rest.wrong("expected at least one patch, got ", result.patches);
  return result;
}

Patch read_patch(TextReader& from, const Sizes& sizes) {
  const std::string_view next = from.peek();
  // The patch's name, a line of its own, may be missing.
  if (!next.empty() && std::string_view("+-.0123456789").find(next.front()) == std::string_view::npos) {
    const std::string_view name = from.word("the name of a patch");
    if (name == "INTERFACE" || name == "SUBDOMAIN" || name == "BOUNDARY")
      from.wrong("expected ", sizes.patches, " patches as the first line says, but '", name, "' comes before the last");
    from.rest_of_line();
  }
  std::vector<int> degrees, counts;
  for (int d = 0; d < sizes.parametric; ++d) degrees.push_back(from.integer("a degree", 1, nurbs::max_degree));
  int size = 1;
  for (int d = 0; d < sizes.parametric; ++d) {
    counts.push_back(from.integer("a number of control points", 2, most_functions / size));
    size *= counts.back();
  }
  std::vector<KnotVector> directions;
  for (std::size_t d = 0; d < degrees.size(); ++d) directions.push_back(read_knots(from, degrees[d], counts[d]));
  MatrixX homogeneous(sizes.dimension + 1, size);
  for (int i = 0; i <= sizes.dimension; ++i)
    for (int a = 0; a < size; ++a)
      homogeneous(i, a) = from.number(i < sizes.dimension ? "a weighted coordinate" : "a weight");
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
    require(patch.parametric_dimension() == parametric && patch.dimension() == dimension, "patches: number ", i + 1,
            " is of another dimension than the first; this form of file takes patches of one kind");
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
