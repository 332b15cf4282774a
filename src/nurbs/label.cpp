#include "nurbs/label.hpp"

#include "base/error.hpp"
#include "nurbs/knots.hpp"

#include <algorithm>
#include <regex>

namespace signorini::nurbs {

namespace {

int whole_number(const std::ssub_match& digits, int otherwise) {
  return digits.matched ? std::stoi(digits.str()) : otherwise;
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
  static const std::regex lagrange("L(0|[1-9]\\d?)");
  static const std::regex nurbs(
      "N(0|[1-9]\\d?)(?:\\.(0|[1-9]\\d?))?(?:-N(0|[1-9]\\d?)(?:\\.(0|[1-9]\\d?))?(?:x(0|[1-9]\\d{0,3}))?)?");
  std::smatch part;
  Label label;
  label.text = text;
  if (std::regex_match(text, part, lagrange)) {
    label.lagrange = true;
    label.bulk = {whole_number(part[1], 0)};
  } else {
    require(std::regex_match(text, part, nurbs), "order: unknown discretisation label '", text,
            "'; labels read Np (N2), Np.s (N2.1), Lp (L2), Nb-Nc (N2-N4), Nb-Nc.s (N2-N2.2), or Nb-Nc.sxr (N2-N2.2x2)");
    label.bulk = {whole_number(part[1], 0), whole_number(part[2], 0)};
    if (part[3].matched) {
      label.layer = Space{whole_number(part[3], 0), whole_number(part[4], 0)};
      label.rows = whole_number(part[5], 1);
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
