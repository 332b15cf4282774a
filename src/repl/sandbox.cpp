#include "repl/sandbox.hpp"

#include "base/error.hpp"
#include "bind/program/library.hpp"
#include "os/limits.hpp"
#include "os/machine.hpp"
#include "os/sandbox.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <unistd.h>

namespace signorini::repl {

namespace fs = std::filesystem;

namespace {

constexpr double default_seconds = 3600;

/// The library: what a script reads of the program.
std::vector<fs::path> library_places() {
  const fs::path home = bind::find_home();
  std::vector<fs::path> places;
  for (const char* part : {"lua", "scripts", "share", "doc", "reference", "library", "report"})
    if (fs::exists(home / part)) places.push_back(home / part);
  for (const char* file : {"starter.lua", "README.md", "CONTRIBUTING.md", "CHANGELOG.md", "LICENSE"})
    if (fs::exists(home / file)) places.push_back(home / file);
  return places;
}

/// Executes the program again unless the environment is the sandbox's already.
void clean_environment(const fs::path& folder, char** arguments) {
  std::vector<std::string> variables = sandbox_environment(folder), present;
  for (char** entry = environ; *entry; ++entry) present.emplace_back(*entry);
  std::sort(variables.begin(), variables.end());
  variables.erase(std::unique(variables.begin(), variables.end()), variables.end());
  std::sort(present.begin(), present.end());
  if (variables == present) return;
  std::vector<char*> words;
  for (std::string& variable : variables) words.push_back(variable.data());
  words.push_back(nullptr);
  ::execve(program_file().c_str(), arguments, words.data());
  fail("os.process.start", {{"program", arguments[0]}, {"reason", std::strerror(errno)}});
}

void enter(CommandLine& line, char** arguments) {
  Sandbox sandbox{line.sandbox, library_places(), std::max(1, line.jobs)};
  check_sandbox(sandbox);
  const fs::path folder = fs::canonical(line.sandbox);
  clean_environment(folder, arguments);
  if (!line.script.empty() && line.script != "-") {
    const fs::path found = bind::find_script(line.script);
    std::error_code error;
    fs::path script = fs::canonical(found, error);
    if (error) script = fs::absolute(found); // Lua reports that it does not exist
    sandbox.read.push_back(script);
    const fs::path inside = script.lexically_relative(folder);
    line.script = (*inside.begin() == ".." ? script : inside).string();
  }
  line.jobs = sandbox.processes;
  line.sandbox = folder.string();
  enter_sandbox(sandbox);
}

} // namespace

void apply_limits(CommandLine& line, char** arguments) {
  if (!line.sandbox.empty()) enter(line, arguments);
  if (!line.sandbox.empty() && !line.time) line.time = Limit{default_seconds, "1h"};
  if (!line.sandbox.empty() && !line.memory) {
    // Half of the machine's, shared by the processes of a study.
    const double megabytes = main_memory() / 2 / (line.jobs + 1) / (1 << 20);
    line.memory = Limit{megabytes * (1 << 20), text(static_cast<long>(megabytes), "M")};
  }
  if (line.memory) limit_memory(line.memory->amount, line.memory->written);
}

} // namespace signorini::repl
