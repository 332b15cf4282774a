#include "base/match.hpp"
#include "nurbs/label.hpp"
#include "targets.hpp"
#include "terminal/answers.hpp"

namespace signorini::fuzz {

namespace {

/// The parts of a label are those of its text.
void label(const std::string& text) {
  passes([&] {
    const nurbs::Label label = nurbs::parse_label(text);
    const auto space = [](const nurbs::Space& one) {
      return "N" + std::to_string(one.degree) + (one.elevations > 0 ? "." + std::to_string(one.elevations) : "");
    };
    std::string again = label.lagrange ? "L" + std::to_string(label.bulk.degree) : space(label.bulk);
    if (label.layer) again += "-" + space(*label.layer) + (label.rows > 1 ? "x" + std::to_string(label.rows) : "");
    require_that(nurbs::parse_label(again).rows == label.rows, "a label has one meaning");
  });
}

/// Answers that arrive byte by byte are those that arrive as a whole.
void answers(const std::string& text) {
  terminal::Answers whole, parts;
  std::string at_once = text, so_far;
  terminal::take_answers(at_once, whole);
  terminal::take_answers(at_once, whole);
  if (text.size() > 64) return;
  for (const char byte : text) {
    so_far += byte;
    terminal::take_answers(so_far, parts);
  }
}

void expressions(const std::string& text) {
  for (const char* one : {"[[:space:]]*(exit|quit)[[:space:]]*(\\([[:space:]]*\\))?[[:space:]]*;?[[:space:]]*",
                          "local|slurm|ssh:[^ ,-][^ ,]*(,ssh:[^ ,-][^ ,]*)*", "([^%]*)%(0([1-9]))?d([^%]*)",
                          "(xterm-kitty|xterm-ghostty|[^|]*\\|kitty|[^|]*\\|ghostty).*"}) {
    const auto groups = match(text, one);
    require_that(groups.empty() || groups.front() == text, "an expression matches the whole text");
  }
}

} // namespace

void words(std::string_view input) {
  const std::string text(input);
  label(text);
  answers(text);
  expressions(text);
}

} // namespace signorini::fuzz
