#include "bind/lua/wording/wording.hpp"

#include "base/text.hpp"
#include "base/warning.hpp"
#include "base/words.hpp"
#include "bind/lua/message.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/args.h>
#include <fmt/format.h>
#include <iostream>
#include <set>
#include <span>
#include <sstream>
#include <utility>

namespace signorini::bind {

namespace {

/// A number with the given count of significant digits.
std::string rounded(double value, int digits) {
  std::ostringstream out;
  out.precision(digits);
  out << value;
  return out.str();
}

/// "0.25 … 2", four digits each; bounds that are zero up to rounding error are printed as 0.
std::string extent(double low, double high) {
  const double least = 1e-9 * (high - low);
  return rounded(std::abs(low) < least ? 0 : low, 4) + " … " + rounded(std::abs(high) < least ? 0 : high, 4);
}

/// A value as text, in the format of its placeholder.
struct Shown {
  const std::string& how;

  std::string operator()(long long value) const {
    if (how == "+1") return std::to_string(value + 1);
    return how.empty() ? std::to_string(value) : counted(static_cast<std::size_t>(value), how);
  }
  std::string operator()(double value) const {
    const bool digits = how.size() == 1 && std::isdigit(static_cast<unsigned char>(how[0]));
    return digits ? rounded(value, how[0] - '0') : text(value);
  }
  std::string operator()(const std::string& value) const { return value; }
  std::string operator()(const std::vector<double>& values) const {
    if (how == "list") return "{" + listed(values) + "}";
    if (how == "range") return extent(values[0], values[1]);
    return coordinates(Eigen::Map<const VectorX>(values.data(), std::ssize(values)));
  }
  std::string operator()(const std::vector<std::string>& values) const {
    if (how == "quoted") return joined_by(", ", values, [](const std::string& value) { return "'" + value + "'"; });
    if (how == "and" && values.size() > 1)
      return listed(std::span(values).first(values.size() - 1)) + " and " + values.back();
    return joined_by(how.empty() || how == "and" ? ", " : how, values, std::identity());
  }
  std::string operator()(const std::vector<Message>& messages) const { return worded_in_one(messages); }
};

} // namespace

} // namespace signorini::bind

/// Parses the part of a placeholder after the colon unchanged.
template <> struct fmt::formatter<signorini::Value> {
  std::string how;

  constexpr auto parse(format_parse_context& context) {
    const auto* end = std::find(context.begin(), context.end(), '}');
    how.assign(context.begin(), end);
    return end;
  }
  auto format(const signorini::Value& value, format_context& context) const {
    const std::string text = std::visit(signorini::bind::Shown{how}, value);
    return std::copy(text.begin(), text.end(), context.out());
  }
};

namespace signorini::bind {

namespace {

struct Wording {
  const char *code, *sentence;
};

constexpr Wording wordings[] = {
#include "bind/lua/wording/base.def"
#include "bind/lua/wording/exchange.def"
#include "bind/lua/wording/failure.def"
#include "bind/lua/wording/figure.def"
#include "bind/lua/wording/mechanics.def"
#include "bind/lua/wording/model.def"
#include "bind/lua/wording/nurbs.def"
#include "bind/lua/wording/os.def"
#include "bind/lua/wording/terminal.def"
#include "bind/lua/wording/view.def"
};

} // namespace

std::string worded(const Message& message) {
  const auto* row = std::ranges::find(wordings, message.code, &Wording::code);
  if (row == std::end(wordings)) return bare_text(message);
  fmt::dynamic_format_arg_store<fmt::format_context> values;
  for (const auto& [name, value] : message.data) values.push_back(fmt::arg(name.c_str(), std::cref(value)));
  return fmt::vformat(row->sentence, values);
}

std::vector<std::string> worded(const std::vector<Message>& messages) {
  std::vector<std::string> sentences;
  sentences.reserve(messages.size());
  for (const Message& message : messages) sentences.push_back(worded(message));
  return sentences;
}

std::string worded(const std::exception& error) {
  const auto* known = dynamic_cast<const Error*>(&error);
  return known ? worded(known->message()) : error.what();
}

std::string worded_in_one(const std::vector<Message>& messages) {
  return joined_by("; ", messages, [](const Message& message) { return worded(message); });
}

namespace {

bool muted = false;

} // namespace

bool mute_warnings(bool now) {
  return std::exchange(muted, now);
}

void warn(const std::string& sentence) {
  static std::set<std::string> printed;
  if (!muted && printed.insert(sentence).second) std::cerr << text("signorini: warning: ", sentence, "\n");
}

void word_warnings() {
  warning_sink = [](const Message& warning) { warn(worded(warning)); };
}

} // namespace signorini::bind
