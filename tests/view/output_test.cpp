#include "view/output.hpp"

#include "base/error.hpp"
#include "messages.hpp"
#include "scenes.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace signorini::view {
namespace {

namespace fs = std::filesystem;

TEST(WriteWhole, ReplacesAFileAndLeavesNothingElse) {
  const fs::path folder = scratch("whole");
  fs::create_directory(folder);
  write_whole((folder / "a.txt").string(), "first, longer");
  write_whole((folder / "a.txt").string(), "second");
  EXPECT_EQ(file_bytes((folder / "a.txt").string()), "second");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
}

TEST(WriteWhole, NamesFileAndCureWhenItCannotWrite) {
  const std::string nowhere = scratch("missing") + "/a.txt";
  const std::string message = message_of([&] { write_whole(nowhere, "x"); });
  EXPECT_TRUE(holds(message, {nowhere, "does not exist", "create it first"})) << message;

  fs::create_directory(scratch("folder"));
  EXPECT_TRUE(holds(message_of([] { write_whole(scratch("folder"), "x"); }), {"it is a folder"}));
  const std::string kernel = message_of([] { write_whole("/proc/signorini.txt", "x"); });
  EXPECT_TRUE(holds(kernel, {"/proc/signorini.txt", "choose a file"})) << kernel;
}

TEST(Svg, EscapesTextAndKeepsItAsText) {
  const Drawing drawing{{200, 150}, {Text{{10, 20}, "a < b & σ₁₁ [N/mm²]", 12}}};
  const std::string out = svg(drawing);
  EXPECT_TRUE(holds(out, {"a &lt; b &amp; σ<tspan", ">11</tspan>", "<text x=\"10\" y=\"130\""})) << out;
}

TEST(Pdf, HasExactOffsetsAndNoDate) {
  const Drawing drawing{{200, 150}, {Text{{10, 20}, "σ (x)", 12}, Stroke{{{0, 0}, {1, 1}}, black, 1, {2, 3}}}};
  const std::string out = pdf(drawing);
  std::size_t entry = out.find("65535 f \n") + 9;
  for (int object = 1; object <= 6; ++object, entry += 20)
    EXPECT_EQ(out.find(std::to_string(object) + " 0 obj"), std::stoul(out.substr(entry, 10)));
  EXPECT_EQ(out.find("xref\n"), std::stoul(out.substr(out.find("startxref\n") + 10)));
  EXPECT_EQ(out.find("Date"), std::string::npos);
}

TEST(Pdf, RefusesCharactersThatItsFontsLack) {
  const Drawing drawing{{200, 150}, {Text{{10, 20}, "接触", 12}}};
  EXPECT_TRUE(holds(message_of([&] { pdf(drawing); }), {"'接'", ".svg or .png"}));
}

} // namespace
} // namespace signorini::view
