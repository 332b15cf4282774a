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
  require(space.degree >= 1 && space.full_degree() <= max_degree, "nurbs.label.degree",
          {{"label", text}, {"degree", space.full_degree()}, {"most", max_degree}});
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
    require(!part.empty(), "nurbs.label.unknown", {{"label", text}});
    label.bulk = {whole_number(part[1], 0), whole_number(part[3], 0)};
    if (!part[4].empty()) {
      label.layer = Space{whole_number(part[5], 0), whole_number(part[7], 0)};
      label.rows = whole_number(part[9], 1);
      check_degree(text, *label.layer);
      require(label.bulk.elevations == 0, "nurbs.label.bulk",
              {{"label", text}, {"degree", label.bulk.degree}, {"layer", text.substr(text.find('-'))}});
      require(label.layer->degree >= label.bulk.degree, "nurbs.label.layer_degree",
              {{"label", text}, {"degree", label.layer->degree}, {"bulk", label.bulk.degree}});
      require(label.rows >= 1, "nurbs.label.layer_depth", {{"label", text}, {"rows", label.rows}});
    }
  }
  check_degree(text, label.bulk);
  return label;
}

} // namespace signorini::nurbs
