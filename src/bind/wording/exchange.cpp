#include "bind/wording/wording.hpp"

namespace signorini::bind {

namespace {

constexpr Wording exchange_rows[] = {
    {"exchange.file.empty", "{file}: the file is empty"},
    {"exchange.file.form", "{file}:1: the file is not one of patches: G+Smo's XML begins with '<', GeoPDEs' text with "
                           "'#' or a number, MFEM's mesh with 'MFEM NURBS mesh v1.0'"},
    {"exchange.write.nothing", "patches must have at least one patch, got none"},
    {"exchange.write.form", "form must be one of {known}, got '{form}'"},
    {"exchange.file.at_line", "{file}:{line}: {problem}"},
    {"exchange.geopdes.comments", "{file}: the file holds comments only"},
    {"exchange.geopdes.sizes", "expected up to 5 sizes in this line, got {count}"},
    {"exchange.geopdes.dimension",
     "expected patches in space of dimension 2 or 3, got {parameters:parameter} in dimension {dimension}"},
    {"exchange.geopdes.no_patch", "expected at least one patch, got {count}"},
    {"exchange.geopdes.patches",
     "expected {expected:patch} as the first line says, but '{word}' comes before the last"},
    {"exchange.geopdes.mixed",
     "patches[{number:+1}] is of another dimension than the first; this form of file takes patches of one kind"},
    {"exchange.gismo.no_child", "<{element}> has no <{child}>"},
    {"exchange.gismo.not_ascii", "<{element}> is in the format '{form}'; only ASCII can be read"},
    {"exchange.gismo.basis", "expected a basis of the type {expected}, got '{type}'"},
    {"exchange.gismo.geometry", "a geometry of the type '{type}' cannot be read; expected BSpline, TensorBSpline2, "
                                "TensorBSpline3, Nurbs, TensorNurbs2 or TensorNurbs3"},
    {"exchange.gismo.bases", "expected {expected} bases, one per direction, got {count}"},
    {"exchange.gismo.size", "the knots ask for more than {most} control points"},
    {"exchange.gismo.too_few", "<{element}> ends after {count:number}, expected {expected}"},
    {"exchange.gismo.too_many", "<{element}> holds more than the {expected:number} expected"},
    {"exchange.gismo.xml", "{file}:{line}: the file is not valid XML: {reason}"},
    {"exchange.gismo.nothing", "{file}: expected at least one element <Geometry>, found none"},
    {"exchange.mfem.points", "expected 'controlpoints' or 'controlpoints_cartesian', got '{word}'"},
    {"exchange.mfem.title", "{file}:1: expected '{expected}', got '{line}'"},
    {"exchange.mfem.weights", "this mesh lists its control points by MFEM's numbers of unknowns; only meshes with a "
                              "section 'patches' can be read"},
    {"exchange.mfem.patches", "expected a patch for each of the {expected:element}, got {count}"},
    {"exchange.mfem.one_patch", "a mesh of MFEM holds one patch, because it must know how patches meet; got {count}. "
                                "Hint: write one file per patch, or an .xml or .txt file"},
    {"exchange.text.end", "expected {expected}, but the file ends"},
    {"exchange.text.keyword", "expected '{expected}', got '{word}'"},
    {"exchange.text.number", "expected {expected}, got '{word}'"},
    {"exchange.text.integer", "expected {expected} (a whole number from {low} to {high}), got '{word}'"},
    {"exchange.expected.word", "'{word}'"},
    {"exchange.expected.attribute", "the attribute {attribute} of <{element}>"},
    {"exchange.expected.knot", "a knot"},
    {"exchange.expected.knot_vectors", "the number of knot vectors"},
    {"exchange.expected.degree", "a degree"},
    {"exchange.expected.functions", "a number of control points"},
    {"exchange.expected.coordinate", "a coordinate"},
    {"exchange.expected.weighted_coordinate", "a weighted coordinate"},
    {"exchange.expected.weight", "a weight"},
    {"exchange.expected.size", "a size"},
    {"exchange.expected.parameters", "the dimension of the parameters"},
    {"exchange.expected.dimension", "the dimension of space"},
    {"exchange.expected.patch_name", "the name of a patch"},
    {"exchange.expected.points", "'controlpoints' or 'controlpoints_cartesian'"},
    {"exchange.expected.patches", "the section 'patches'"},
    {"exchange.expected.elements", "the number of elements"},
};

} // namespace

std::span<const Wording> exchange_wordings() {
  return exchange_rows;
}

} // namespace signorini::bind
