#pragma once
// The command line.

#include "terminal/choice.hpp"

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace signorini::repl {

/// An invalid command line.
class UsageError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// A limit: its amount in bytes or seconds, and as the user wrote it, "4G" or "10m".
struct Limit {
  double amount = 0;
  std::string written;
};

struct CommandLine {
  enum class Action { run, version, help, doctor, new_study, kernel, install_kernel };
  Action action = Action::run;
  std::vector<std::string> code;      ///< of each -e
  std::string script;                 ///< a file, "-" for standard input, or empty
  std::string new_study;              ///< the file of --new
  std::string connection;             ///< the file of --kernel
  std::vector<std::string> arguments; ///< of the script
  bool interactive = false;           ///< -i
  bool quiet = false;                 ///< -q
  int threads = 1;
  int jobs = 0;                               ///< parallel processes of studies; 0 without --jobs
  std::string on;                             ///< where studies are executed; empty without --on
  std::string chunk;                          ///< of --chunk; empty without
  std::optional<terminal::Protocol> pictures; ///< of --pictures
  std::string sandbox;                        ///< the folder of --sandbox; empty without
  std::optional<Limit> memory, time;          ///< of --memory and --time

  /// True if only the prompt is to run.
  bool prompt_only() const { return code.empty() && script.empty(); }
};

/// The options that apply to every script, as words of a command line.
std::vector<std::string> common_options(const CommandLine& line);

/// Throws UsageError with a hint.
CommandLine parse(const std::vector<std::string>& words);

/// The text of --help.
std::string usage();

/// For the man page and the completion: name, name of the value, text of --help and further text of each option.
std::vector<std::vector<std::string>> option_texts();

} // namespace signorini::repl
