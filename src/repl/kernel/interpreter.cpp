#include "repl/kernel/interpreter.hpp"

#include "base/base64.hpp"
#include "repl/kernel/thread.hpp"

#include <xeus/xhelper.hpp>
#include <xeus/xinput.hpp>

#include <algorithm>
#include <stdexcept>

namespace signorini::repl::kernel {

namespace {

nl::json data_of(const Display& display) {
  nl::json data = nl::json::object();
  for (const auto& [type, bytes] : display.formats) data[type] = type == "image/png" ? base64(bytes) : bytes;
  return data;
}

/// The size of images on the screen: they have more pixels, for screens with a high resolution. SVG files state theirs.
nl::json metadata_of(const Display& display) {
  nl::json metadata = nl::json::object();
  for (const auto& [type, bytes] : display.formats)
    if (display.width > 0 && type == "image/png")
      metadata[type] = {{"width", display.width}, {"height", display.height}};
  return metadata;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
    end = text.find('\n', begin);
    lines.push_back(text.substr(begin, end - begin));
  }
  return lines;
}

nl::json error_reply(const Failure& failure) {
  return {{"status", "error"},
          {"ename", failure.name},
          {"evalue", failure.message},
          {"traceback", lines_of(failure.traceback)}};
}

nl::json refusal(const std::string& message) {
  return error_reply({"error", message, message});
}

constexpr const char* needs_shell = "this request must be sent on the shell channel";

} // namespace

Interpreter::Interpreter(Output::Publish publish, History& history,
                         const std::function<std::unique_ptr<Evaluator>(FrontEnd&)>& make_evaluator)
    : output_(std::move(publish)), history_(history), evaluator_(make_evaluator(*this)) {
  xeus::register_interpreter(this);
}

nl::json Interpreter::execute_request_impl(int number, const std::string& code, bool silent, bool store_history,
                                           nl::json user_expressions, bool allow_stdin) {
  if (!on_shell()) return refusal(needs_shell);
  if (ending_) return {{"status", "aborted"}};
  number_ = number;
  silent_ = silent;
  has_input_ = allow_stdin;
  replaceable_.clear();
  if (store_history) history_.add(number, code);
  output_.begin(parent_header(), silent);
  const Outcome outcome = evaluator_->execute(code, number);
  if (outcome.failure) {
    output_.end();
    const auto& [name, message, traceback] = *outcome.failure;
    if (!silent) publish_execution_error(name, message, lines_of(traceback));
    return error_reply(*outcome.failure);
  }
  const nl::json values = values_of(user_expressions);
  output_.end();
  if (outcome.value && !silent) publish_execution_result(number, data_of(*outcome.value), metadata_of(*outcome.value));
  return xeus::create_successful_reply(nl::json::array(), values);
}

nl::json Interpreter::values_of(const nl::json& expressions) {
  nl::json values = nl::json::object();
  for (const auto& [name, expression] : expressions.items()) {
    const Outcome outcome = evaluator_->evaluate(expression.is_string() ? expression.get<std::string>() : "");
    const Display value = outcome.value.value_or(Display{});
    values[name] = outcome.failure
                       ? error_reply(*outcome.failure)
                       : nl::json{{"status", "ok"}, {"data", data_of(value)}, {"metadata", metadata_of(value)}};
  }
  return values;
}

nl::json Interpreter::complete_request_impl(const std::string& code, int cursor) {
  if (!on_shell()) return refusal(needs_shell);
  const Completions found = evaluator_->complete(code, cursor);
  return xeus::create_complete_reply(found.matches, found.begin, found.end);
}

nl::json Interpreter::inspect_request_impl(const std::string& code, int cursor, int) {
  if (!on_shell()) return refusal(needs_shell);
  const Display page = evaluator_->inspect(code, cursor);
  return xeus::create_inspect_reply(!page.formats.empty(), data_of(page));
}

nl::json Interpreter::is_complete_request_impl(const std::string& code) {
  if (!on_shell()) return refusal(needs_shell);
  const auto [completeness, indent] = evaluator_->test(code);
  constexpr const char* words[] = {"complete", "incomplete", "invalid"};
  return xeus::create_is_complete_reply(words[static_cast<int>(completeness)], indent);
}

nl::json Interpreter::kernel_info_request_impl() {
  const std::string version = evaluator_->version();
  nl::json reply = {{"status", "ok"},
                    {"implementation", "signorini"},
                    {"implementation_version", version},
                    {"banner", "signorini " + version + ": isogeometric contact mechanics; help() shows help"},
                    {"debugger", false},
                    {"language_info",
                     {{"name", "lua"},
                      {"version", evaluator_->language_version()},
                      {"mimetype", "text/x-lua"},
                      {"file_extension", ".lua"},
                      {"pygments_lexer", "lua"},
                      {"codemirror_mode", "lua"}}},
                    {"help_links",
                     {{{"text", "Lua manual"}, {"url", "https://www.lua.org/manual/5.4/"}},
                      {{"text", "The method in 2D (arXiv:1903.05859)"}, {"url", "https://arxiv.org/abs/1903.05859"}},
                      {{"text", "The method in 3D (arXiv:2409.15621)"}, {"url", "https://arxiv.org/abs/2409.15621"}}}}};
  return reply;
}

/// On the control thread. The running cell ends, those behind it are not executed.
void Interpreter::shutdown_request_impl() {
  ending_ = true;
  evaluator_->interrupt();
}

void Interpreter::check_process(const char* what) const {
  if (getpid() == process_) return;
  throw std::runtime_error(std::string(what) + " a case of a study, which runs in a process of its own");
}

void Interpreter::show(const Display& display) {
  check_process("a notebook shows no pictures of");
  output_.flush();
  if (!silent_) display_data(data_of(display), metadata_of(display), nl::json::object());
}

/// Cases of studies have no progress of their own.
void Interpreter::replace(const std::string& name, const std::string& text) {
  if (getpid() != process_ || silent_) return;
  output_.flush();
  nl::json data = {{"text/plain", text}};
  nl::json transient = {{"display_id", name + "." + std::to_string(number_)}};
  const bool is_new = std::find(replaceable_.begin(), replaceable_.end(), name) == replaceable_.end();
  if (is_new) replaceable_.push_back(name);
  if (is_new)
    display_data(std::move(data), nl::json::object(), std::move(transient));
  else
    update_display_data(std::move(data), nl::json::object(), std::move(transient));
}

std::string Interpreter::read_line() {
  check_process("there is no input for");
  if (!has_input_) throw std::runtime_error("this front end has no input. Hint: assign the value in the cell");
  output_.flush();
  // Xeus waits in a call that a signal ends only if it comes during the call, not just before it.
  const std::jthread again = thread_without_signals([this](const std::stop_token& end) {
    for (; !end.stop_requested(); std::this_thread::sleep_for(std::chrono::milliseconds(20)))
      if (evaluator_->interrupted()) evaluator_->interrupt();
  });
  return xeus::blocking_input_request("", false);
}

} // namespace signorini::repl::kernel
