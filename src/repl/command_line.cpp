#include "repl/command_line.hpp"

#include "base/match.hpp"
#include "bind/lua/message.hpp"
#include "bind/lua/threads.hpp"

#include <algorithm>
#include <charconv>
#include <map>

namespace signorini::repl {

namespace {

constexpr int most_jobs = 1 << 16;
constexpr double largest_limit = 1e9; // of any unit; larger ones are typing errors
constexpr const char* place_form = "slurm, local or hosts such as ssh:host1,ssh:host2";
constexpr const char* memory_form = "a size such as 500M or 4G";
constexpr const char* time_form = "a duration such as 30s, 10m or 2h";

/// The number after an option such as --threads.
int parse_count(const char* option, const std::string& word, int most) {
  int count = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
  if (error != std::errc() || end != word.data() + word.size() || count < 1 || count > most)
    throw UsageError(text(option, " must be an integer from 1 to ", most, ", got '", word, "'"));
  return count;
}

/// The value of --on, checked.
std::string parse_place(const std::string& word) {
  if (match(word, "local|slurm|ssh:[^ ,-][^ ,]*(,ssh:[^ ,-][^ ,]*)*").empty())
    throw UsageError(text("--on must be ", place_form, ", got '", word, "'"));
  return word;
}

/// The value of --memory or --time: a number and one of the units, which are letters with their amounts.
Limit parse_limit(const char* option, const std::string& word, const std::map<char, double>& units,
                  const char* expected) {
  double number = 0;
  const char* end = word.data() + word.size();
  const auto [unit, error] = std::from_chars(word.data(), end, number, std::chars_format::fixed);
  const bool one_letter = error == std::errc() && end - unit == 1 && units.contains(*unit);
  if (!one_letter || !(number > 0) || number > largest_limit)
    throw UsageError(text(option, " must be ", expected, ", got '", word, "'"));
  return {number * units.at(*unit), word};
}

Limit parse_memory(const std::string& word) {
  return parse_limit("--memory", word, {{'K', 0x1p10}, {'M', 0x1p20}, {'G', 0x1p30}, {'T', 0x1p40}}, memory_form);
}

Limit parse_time(const std::string& word) {
  return parse_limit("--time", word, {{'s', 1}, {'m', 60}, {'h', 3600}}, time_form);
}

/// Throws UsageError for options that have no effect together, or none that would be safe.
void check_limits(const CommandLine& line) {
  const bool runs = line.action == CommandLine::Action::run;
  const char* limit = !line.sandbox.empty() ? "--sandbox" : line.memory ? "--memory" : line.time ? "--time" : nullptr;
  if (limit && !runs) throw UsageError(text(limit, " is for scripts and the prompt only"));
  if (line.sandbox.empty()) return;
  if (!line.on.empty() && line.on != "local")
    throw UsageError(text("--sandbox cannot be combined with --on ", line.on,
                          ": from inside no other machine is reached. Hint: leave out --on"));
  if (!line.chunk.empty()) throw UsageError("--sandbox cannot be combined with --chunk");
}

/// The value of --pictures, checked.
terminal::Protocol parse_protocol(const std::string& word) {
  const auto& names = terminal::protocol_names();
  const auto found = std::find(names.begin(), names.end(), word);
  if (found == names.end())
    throw UsageError(
        text("--pictures must be one of ", bind::listed(names), ", got '", word, "'", bind::did_you_mean(word, names)));
  return static_cast<terminal::Protocol>(found - names.begin());
}

using Action = CommandLine::Action;

/// An option: parsing, --help, the man page and the completion follow from it.
struct Option {
  std::string name;
  std::string metavar; ///< of its value; empty without
  std::string value;   ///< what must follow
  std::string text;    ///< of --help, with its line breaks
  std::string more;    ///< sentences that the man page adds
  void (*set)(CommandLine& line, const std::string& value);
  bool also_after_script = false;
};

const std::vector<Option>& options() {
  static const std::vector<Option> table = {
      {"-e", "'code'", "code, such as -e 'print(sg)'", "run code (may be repeated, before the script)", "",
       [](auto& line, auto& value) { line.code.push_back(value); }},
      {"-i", "", "", "continue at the prompt, also after an error", "There, _ is the value that the script returned.",
       [](auto& line, auto&) { line.interactive = true; }},
      {"-q", "", "", "no progress display, no banner", "", [](auto& line, auto&) { line.quiet = true; }},
      {"--threads", "N", "a number", "threads of assembly and contact search; BLAS uses one (default: 1)",
       "Results are bitwise identical for any number.",
       [](auto& line, auto& value) { line.threads = parse_count("--threads", value, bind::most_threads); }},
      {"--jobs", "N", "a number", "parallel cases of a study, also after the script (default: number of processors)",
       "", [](auto& line, auto& value) { line.jobs = parse_count("--jobs", value, most_jobs); }, true},
      {"--on", "WHERE", place_form,
       "where studies are solved, also after the script: slurm, local, or ssh:host1,ssh:host2",
       "--on slurm submits the cases to Slurm and waits for them, --on ssh:host1,ssh:host2 solves them on hosts "
       "that are reached by ssh, --on local on this machine. Takes precedence over the argument on of "
       "study:execute.",
       [](auto& line, auto& value) { line.on = parse_place(value); }, true},
      {"--chunk", "FILE:N", "the file of a job and the number of a chunk, jobs.json:3",
       "solve chunk N of a job's cases; tasks of Slurm and hosts run this", "",
       [](auto& line, auto& value) { line.chunk = value; }},
      {"--pictures", "HOW", "kitty, iterm, sixel, blocks or none",
       "pictures in the terminal: kitty, iterm, sixel, blocks or none (default: as it can)",
       "The form blocks consists of half blocks in color.",
       [](auto& line, auto& value) { line.pictures = parse_protocol(value); }},
      {"--sandbox", "FOLDER", "the folder that the script may use",
       "for a stranger's script: it reads the library and itself, reads and writes in the folder,\n"
       "starts no program and opens no socket",
       "The folder becomes the working directory. The kernel enforces the limits (Landlock and seccomp); where "
       "it cannot, the program ends with an error before the script starts. Studies solve --jobs cases at once, "
       "by default 1. Not available: --kernel, --on with other machines, --chunk.",
       [](auto& line, auto& value) { line.sandbox = value; }},
      {"--memory", "SIZE", memory_form,
       "most memory of each process, such as 500M or 4G (default in the sandbox: half of the\n"
       "machine's, divided by the processes)",
       "A size is a number with K, M, G or T (1024 bytes and its powers). What needs more fails with an error "
       "at its line. In the sandbox, the processes are those of --jobs and one.",
       [](auto& line, auto& value) { line.memory = parse_memory(value); }},
      {"--time", "LIMIT", time_form,
       "longest time of the run, or of a statement at the prompt, such as 30s, 10m or 2h (default\n"
       "in the sandbox: 1h)",
       "Then the run stops as by Ctrl-C. If it has not stopped a tenth of the limit later, at least 2 seconds, "
       "the program ends with status 124.",
       [](auto& line, auto& value) { line.time = parse_time(value); }},
      {"--new", "FILE", "the name of a file, such as study.lua",
       "write a commented starter study, such as study.lua, and settings for editors",
       "With the settings, .luarc.json next to the study, editors that have a Lua language server complete and check "
       "scripts. Existing files are not overwritten.",
       [](auto& line, auto& value) {
         line.action = Action::new_study;
         line.new_study = value;
       }},
      {"--install-kernel", "", "",
       "make this program a kernel of Jupyter notebooks, with the options -q, -e, --threads,\n"
       "--jobs and --on given with it",
       "Writes kernels/signorini in the user's folder of Jupyter.",
       [](auto& line, auto&) { line.action = Action::install_kernel; }},
      {"--kernel", "FILE", "a connection file, which Jupyter writes",
       "serve a notebook; Jupyter runs this with a connection file", "Needs the package signorini-jupyter.",
       [](auto& line, auto& value) {
         line.action = Action::kernel;
         line.connection = value;
       }},
      {"--version", "", "", "version, and a hash of the source",
       "The hash differs between programs whose results may differ.",
       [](auto& line, auto&) { line.action = Action::version; }},
      {"--help", "", "", "short help; also -h", "", [](auto& line, auto&) { line.action = Action::help; }},
      {"--doctor", "", "", "versions of all libraries, and a test picture", "",
       [](auto& line, auto&) { line.action = Action::doctor; }}};
  return table;
}

/// Null if there is no such option, or it must precede the script, which has been given.
const Option* find_option(const std::string& name, bool after_script) {
  for (const Option& option : options())
    if (option.name == name && (!after_script || option.also_after_script)) return &option;
  return nullptr;
}

} // namespace

CommandLine parse(const std::vector<std::string>& words) {
  CommandLine line;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const auto next = [&](const std::string& what) -> const std::string& {
      if (i + 1 == words.size()) throw UsageError(text(word, " must be followed by ", what));
      return words[++i];
    };
    // Words after the script are its arguments, except options that apply to every study.
    const bool after_script = !line.script.empty();
    const std::size_t equals = word.starts_with("--") ? word.find('=') : std::string::npos;
    const Option* option = find_option(word == "-h" ? "--help" : word.substr(0, equals), after_script);
    if (option && !option->value.empty()) {
      const std::string value = equals == std::string::npos ? next(option->value) : word.substr(equals + 1);
      // An empty variable of a shell, as in --sandbox=$FOLDER, must not turn the sandbox off.
      if (value.empty() && option->name != "-e")
        throw UsageError(text(option->name, " must be followed by ", option->value, ", got ''"));
      option->set(line, value);
    } else if (option && equals == std::string::npos)
      option->set(line, "");
    else if (after_script)
      line.arguments.push_back(word);
    else if (word == "--")
      line.script = next("a script");
    else if (word.empty())
      throw UsageError(
          "the script name must not be empty, got ''. Hint: omit it for the prompt, or give the name of a file");
    else if (word.starts_with("-") && word != "-") {
      std::vector<std::string> names;
      for (const Option& known : options()) names.push_back(known.name);
      const std::string meant = bind::did_you_mean(word, names);
      throw UsageError(text("unknown option '", word, "'", meant, meant.empty() ? "." : "",
                            " Hint: options precede the script, --help lists them"));
    } else
      line.script = word;
  }
  const bool serves = line.action == CommandLine::Action::kernel;
  if (serves || line.action == CommandLine::Action::install_kernel) {
    const std::string other = line.interactive       ? "-i"
                              : !line.script.empty() ? text("the script '", line.script, "'")
                              : !line.chunk.empty()  ? "--chunk"
                                                     : "";
    if (!other.empty())
      throw UsageError(text(serves ? "--kernel" : "--install-kernel", " cannot be combined with ", other,
                            serves ? ". Hint: dofile \"study.lua\" in a cell runs a script"
                                   : ". Hint: JUPYTER_DATA_DIR in the environment sets the folder of Jupyter"));
  }
  check_limits(line);
  return line;
}

std::vector<std::string> common_options(const CommandLine& line) {
  std::vector<std::string> words;
  const auto add = [&](const std::string& option, const std::string& value) {
    words.push_back(option);
    words.push_back(value);
  };
  if (line.quiet) words.push_back("-q");
  if (line.threads != 1) add("--threads", std::to_string(line.threads));
  if (line.jobs > 0) add("--jobs", std::to_string(line.jobs));
  if (!line.on.empty()) add("--on", line.on);
  for (const std::string& code : line.code) add("-e", code);
  return words;
}

std::string usage() {
  constexpr std::size_t width = 14; // of most names
  const std::string margin = "\n" + std::string(width + 4, ' ');
  std::string lines;
  for (const Option& option : options()) {
    const std::string name = option.name + (option.metavar.empty() ? "" : " ") + option.metavar;
    lines += "  " + name + (name.size() > width ? margin : std::string(width + 2 - name.size(), ' '));
    for (const char letter : option.text) lines += letter == '\n' ? margin : std::string(1, letter);
    lines += '\n';
  }
  return text("signorini: isogeometric contact mechanics from Lua\n"
              "\n"
              "  signorini                       prompt with history, completion and help()\n"
              "  signorini study.lua [args…]     run a script; its arguments are in `arg`\n"
              "  signorini hertz2d.lua [args…]   run a supplied script; help \"gallery\" at the prompt lists them\n"
              "  echo 'code' | signorini -       run standard input\n"
              "\n",
              lines,
              "\n"
              "The value of a long option may also follow `=`: --threads=4.\n"
              "Exit status: 0 on success, 1 after an error, also in a case of a study, 2 for an invalid command line, "
              "124 after the time of --time, 130 after Ctrl-C.\n"
              "SIGNORINI_HOME: the folder that contains lua/, if it differs from that of the installation.\n"
              "SIGNORINI_KERNEL: sse2, avx2 or avx512, the widest vector instructions of the element kernels "
              "(default: those of the processor; plain on processors other than x86-64).\n");
}

std::vector<std::vector<std::string>> option_texts() {
  std::vector<std::vector<std::string>> rows;
  for (const Option& option : options()) rows.push_back({option.name, option.metavar, option.text, option.more});
  return rows;
}

} // namespace signorini::repl
