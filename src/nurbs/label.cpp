#include "nurbs/label.hpp"

#include "base/error.hpp"
#include "base/match.hpp"
#include "nurbs/knots.hpp"

#include <algorithm>

namespace signorini::nurbs {

namespace {

int whole_number(const std::string& digits, int otherwise) {
  return digits.empty() ? otherwise : std::stoi(digits);
}

void check_degree(const std::string& text, const Space& space) {
  require(space.degree >= 1 && space.full_degree() <= max_degree, "order: label '", text, "': degree ",
          space.full_degree(), " is outside 1 … ", max_degree);
}

} // namespace

Space bulk_space(const std::vector<Label>& labels) {
  return std::max_element(labels.begin(), labels.end(),
                          [](const Label& a, const Label& b) { return a.bulk.full_degree() < b.bulk.full_degree(); })
      ->bulk;
}

Label parse_label(const std::string& text) {
  Label label;
  label.text = text;
  if (const auto lagrange = match(text, "L(0|[1-9][0-9]?)"); !lagrange.empty()) {
    label.lagrange = true;
    label.bulk = {whole_number(lagrange[1], 0)};
  } else {
    const auto part = match(text, "N(0|[1-9][0-9]?)(\\.(0|[1-9][0-9]?))?"
                                  "(-N(0|[1-9][0-9]?)(\\.(0|[1-9][0-9]?))?(x(0|[1-9][0-9]{0,3}))?)?");
    require(!part.empty(), "order: unknown discretisation label '", text,
            "'; labels read Np (N2), Np.s (N2.1), Lp (L2), Nb-Nc (N2-N4), Nb-Nc.s (N2-N2.2), or Nb-Nc.sxr (N2-N2.2x2)");
    label.bulk = {whole_number(part[1], 0), whole_number(part[3], 0)};
    if (!part[4].empty()) {
      label.layer = Space{whole_number(part[5], 0), whole_number(part[7], 0)};
      label.rows = whole_number(part[9], 1);
      check_degree(text, *label.layer);
      require(label.bulk.elevations == 0, "order: label '", text, "': the bulk of a layered label is plain Np; write N",
              label.bulk.degree, text.substr(text.find('-')));
      require(label.layer->degree >= label.bulk.degree, "order: label '", text, "': the layer's degree ",
              label.layer->degree, " is below the bulk's ", label.bulk.degree,
              "; a layer is of the bulk's degree or higher");
      require(label.rows >= 1, "order: label '", text, "': the layer is ", label.rows, " rows deep; x1 is the least");
    }
  }
  check_degree(text, label.bulk);
  return label;
}

} // namespace signorini::nurbs
