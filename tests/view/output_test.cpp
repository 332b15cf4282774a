#include "view/output.hpp"

#include "base/error.hpp"
#include "messages.hpp"

#include <gtest/gtest.h>

namespace signorini::view {
namespace output_test {

TEST(Svg, EscapesTextAndKeepsItAsText) {
  const Drawing drawing{{200, 150}, {Text{{10, 20}, "a < b & σ₁₁ [N/mm²]", 12}}};
  const std::string out = svg(drawing);
  EXPECT_TRUE(holds(out, {"a &lt; b &amp; σ<tspan", ">11</tspan>", "<text x=\"10\" y=\"130\""})) << out;
}

TEST(Pdf, HasExactOffsetsAndNoDate) {
  const Drawing drawing{{200, 150}, {Text{{10, 20}, "σ (x)", 12}, Stroke{{{0, 0}, {1, 1}}, black, 1, {2, 3}}}};
  const std::string out = pdf(drawing);
  std::size_t entry = out.find("65535 f \n") + 9;
  for (int object = 1; object <= 7; ++object, entry += 20)
    EXPECT_EQ(out.find(std::to_string(object) + " 0 obj"), std::stoul(out.substr(entry, 10)));
  EXPECT_EQ(out.find("xref\n"), std::stoul(out.substr(out.find("startxref\n") + 10)));
  EXPECT_EQ(out.find("Date"), std::string::npos);
}

TEST(Pdf, ShowsBoxesForCharactersThatItsFontsLack) {
  const Drawing drawing{{200, 150}, {Text{{10, 20}, "x 接触", 12}}};
  testing::internal::CaptureStderr();
  EXPECT_TRUE(holds(pdf(drawing), {"/F1 12.00 Tf <7820> Tj", "/F3 12.00 Tf <6f6f> Tj", "/BaseFont /ZapfDingbats"}));
  EXPECT_TRUE(holds(testing::internal::GetCapturedStderr(), {"'接', '触' of the text 'x 接触'", ".svg or .png"}));
}

} // namespace output_test
} // namespace signorini::view
