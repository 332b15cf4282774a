#include "nurbs/label.hpp"

#include "nurbs/random_patch.hpp"

#include <gtest/gtest.h>

namespace signorini::nurbs {
namespace label_test {

struct Form {
  const char* text;
  bool lagrange;
  Space bulk;
  std::optional<Space> layer;
  int rows;
};

TEST(Label, EveryForm) {
  const Form forms[] = {
      {"N1", false, {1, 0}, {}, 1},
      {"N2", false, {2, 0}, {}, 1},
      {"N15", false, {15, 0}, {}, 1},
      {"N2.1", false, {2, 1}, {}, 1},
      {"N3.12", false, {3, 12}, {}, 1},
      {"L1", true, {1, 0}, {}, 1},
      {"L4", true, {4, 0}, {}, 1},
      {"N2-N4", false, {2, 0}, {{4, 0}}, 1},
      {"N2-N2.2", false, {2, 0}, {{2, 2}}, 1},
      {"N2-N2.2x2", false, {2, 0}, {{2, 2}}, 2},
      {"N2-N4x12", false, {2, 0}, {{4, 0}}, 12},
      {"N2-N2.1x1", false, {2, 0}, {{2, 1}}, 1},
      {"N3-N3", false, {3, 0}, {{3, 0}}, 1},
  };
  for (const Form& form : forms) {
    const Label label = parse_label(form.text);
    EXPECT_EQ(label.text, form.text);
    EXPECT_EQ(label.lagrange, form.lagrange) << form.text;
    EXPECT_EQ(label.bulk, form.bulk) << form.text;
    EXPECT_EQ(label.layer, form.layer) << form.text;
    EXPECT_EQ(label.rows, form.rows) << form.text;
  }
  EXPECT_EQ((Space{2, 3}).full_degree(), 5);
}

TEST(Label, ErrorsForUnknownFormsShowTheGrammar) {
  for (const char* text : {"",       "N",       "2",        "n2",    "M2",     "N2 ",  " N2",         "N2.",  "N-2",
                           "N2-",    "N2-4",    "N2-N",     "N2-L2", "L2-N4",  "L2.1", "L",           "N2x2", "N2.1x2",
                           "N2-N4x", "N2-N4y2", "N2-N4-N6", "N2,1",  "N2.1.1", "N100", "N2-N4x12345", "Q2"})
    EXPECT_ERROR(parse_label(text), "nurbs.label.unknown") << text;
}

TEST(Label, ErrorsNameInvalidNumbers) {
  EXPECT_ERROR(parse_label("N0"), "nurbs.label.degree: label = N0, degree = 0, most = 15");
  EXPECT_ERROR(parse_label("L0"), "nurbs.label.degree: label = L0, degree = 0, most = 15");
  EXPECT_ERROR(parse_label("N16"), "nurbs.label.degree: label = N16, degree = 16, most = 15");
  EXPECT_ERROR(parse_label("N0.2"), "nurbs.label.degree: label = N0.2, degree = 2, most = 15");
  EXPECT_ERROR(parse_label("N9.7"), "nurbs.label.degree: label = N9.7, degree = 16, most = 15");
  EXPECT_ERROR(parse_label("N2-N2.14"), "nurbs.label.degree: label = N2-N2.14, degree = 16, most = 15");
  EXPECT_ERROR(parse_label("N4-N2"), "nurbs.label.layer_degree: label = N4-N2, degree = 2, bulk = 4");
  EXPECT_ERROR(parse_label("N2.1-N4"), "nurbs.label.bulk: label = N2.1-N4, degree = 2, layer = -N4");
  EXPECT_ERROR(parse_label("N2-N4x0"), "nurbs.label.layer_depth: label = N2-N4x0, rows = 0");
}

} // namespace label_test
} // namespace signorini::nurbs
