#include "repl/history.hpp"

#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <unistd.h>

namespace signorini::repl {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view continuation = "..> ";

} // namespace

std::string find_history() {
  const char *state_home = std::getenv("XDG_STATE_HOME"), *home = std::getenv("HOME");
  fs::path folder;
  if (state_home && *state_home)
    folder = state_home;
  else if (home && *home)
    folder = fs::path(home) / ".local/state";
  else
    return "";
  std::error_code error;
  fs::create_directories(folder / "signorini", error);
  return error ? "" : (folder / "signorini/history").string();
}

std::vector<std::string> load_history(const std::string& file, std::size_t most) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return {}; // opening a pipe would wait for another program
  std::ifstream lines(file);
  std::vector<std::string> statements;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(continuation) && !statements.empty())
      statements.back() += "\n" + line.substr(continuation.size());
    else
      statements.push_back(line);
  }
  if (statements.size() > most) statements.erase(statements.begin(), statements.end() - static_cast<long>(most));
  return statements;
}

void save_statement(const std::string& file, const std::string& statement) {
  std::string entry;
  for (const char c : statement) {
    entry += c;
    if (c == '\n') entry += continuation;
  }
  entry += '\n';
  const int descriptor = open(file.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_NONBLOCK | O_CLOEXEC, 0600);
  if (descriptor < 0) return;
  [[maybe_unused]] const auto written = write(descriptor, entry.data(), entry.size());
  close(descriptor);
}

} // namespace signorini::repl
