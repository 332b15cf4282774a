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
    throw UsageError(text("--on must be slurm, local or hosts such as ssh:host1,ssh:host2, got '", word, "'"));
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

} // namespace

CommandLine parse(const std::vector<std::string>& words) {
  const std::vector<std::string> known = {"-e",        "-i",      "-q",       "--threads",  "--jobs",
                                          "--on",      "--chunk", "--new",    "--kernel",   "--install-kernel",
                                          "--version", "--help",  "--doctor", "--pictures", "--sandbox",
                                          "--memory",  "--time"};
  CommandLine line;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const auto value = [&](const char* what) -> const std::string& {
      if (i + 1 == words.size()) throw UsageError(text(word, " must be followed by ", what));
      return words[++i];
    };
    // Words after the script are its arguments, except these options, which apply to every study.
    if (word == "--jobs")
      line.jobs = parse_count("--jobs", value("a number"), most_jobs);
    else if (word.starts_with("--jobs="))
      line.jobs = parse_count("--jobs", word.substr(7), most_jobs);
    else if (word == "--on")
      line.on = parse_place(value("slurm, local or hosts such as ssh:host1,ssh:host2"));
    else if (word.starts_with("--on="))
      line.on = parse_place(word.substr(5));
    else if (!line.script.empty())
      line.arguments.push_back(word);
    else if (word == "-e")
      line.code.push_back(value("code, such as -e 'print(sg)'"));
    else if (word == "-i")
      line.interactive = true;
    else if (word == "-q")
      line.quiet = true;
    else if (word == "--threads")
      line.threads = parse_count("--threads", value("a number"), bind::most_threads);
    else if (word.starts_with("--threads="))
      line.threads = parse_count("--threads", word.substr(10), bind::most_threads);
    else if (word == "--pictures")
      line.pictures = parse_protocol(value("kitty, iterm, sixel, blocks or none"));
    else if (word.starts_with("--pictures="))
      line.pictures = parse_protocol(word.substr(11));
    else if (word == "--sandbox")
      line.sandbox = value("the folder that the script may use");
    else if (word.starts_with("--sandbox="))
      line.sandbox = word.substr(10);
    else if (word == "--memory")
      line.memory = parse_memory(value(memory_form));
    else if (word.starts_with("--memory="))
      line.memory = parse_memory(word.substr(9));
    else if (word == "--time")
      line.time = parse_time(value(time_form));
    else if (word.starts_with("--time="))
      line.time = parse_time(word.substr(7));
    else if (word == "--chunk")
      line.chunk = value("the file of a job and the number of a chunk, jobs.json:3");
    else if (word == "--new") {
      line.action = CommandLine::Action::new_study;
      line.new_study = value("the name of a file, such as study.lua");
    } else if (word == "--kernel") {
      line.action = CommandLine::Action::kernel;
      line.connection = value("a connection file, which Jupyter writes");
    } else if (word == "--install-kernel")
      line.action = CommandLine::Action::install_kernel;
    else if (word == "--version")
      line.action = CommandLine::Action::version;
    else if (word == "--help" || word == "-h")
      line.action = CommandLine::Action::help;
    else if (word == "--doctor")
      line.action = CommandLine::Action::doctor;
    else if (word == "--")
      line.script = value("a script");
    else if (word.empty())
      throw UsageError(
          "the script name must not be empty, got ''. Hint: omit it for the prompt, or give the name of a file");
    else if (word.starts_with("-") && word != "-") {
      const std::string meant = bind::did_you_mean(word, known);
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

const char* usage() {
  return "signorini: isogeometric contact mechanics from Lua\n"
         "\n"
         "  signorini                       prompt with history, completion and help()\n"
         "  signorini study.lua [args…]     run a script; its arguments are in `arg`\n"
         "  signorini hertz2d.lua [args…]   run a supplied script; help \"gallery\" at the prompt lists them\n"
         "  echo 'code' | signorini -       run standard input\n"
         "\n"
         "  -e 'code'       run code (may be repeated, before the script)\n"
         "  -i              continue at the prompt, also after an error\n"
         "  -q              no progress display, no banner\n"
         "  --threads N     threads of assembly and contact search; BLAS uses one (default: 1)\n"
         "  --jobs N        parallel cases of a study, also after the script (default: number of processors)\n"
         "  --on WHERE      where studies are solved, also after the script: slurm, local, or ssh:host1,ssh:host2\n"
         "  --chunk FILE:N  solve chunk N of a job's cases; tasks of Slurm and hosts run this\n"
         "  --pictures HOW  pictures in the terminal: kitty, iterm, sixel, blocks or none (default: as it can)\n"
         "  --sandbox FOLDER\n"
         "                  for a stranger's script: it reads the library and itself, reads and writes in the folder,\n"
         "                  starts no program and opens no socket\n"
         "  --memory SIZE   most memory of each process, such as 500M or 4G (default in the sandbox: half of the\n"
         "                  machine's, divided by the processes)\n"
         "  --time LIMIT    longest time of the run, or of a statement at the prompt, such as 30s, 10m or 2h (default\n"
         "                  in the sandbox: 1h)\n"
         "  --new FILE      write a commented starter study, such as study.lua, and settings for editors\n"
         "  --install-kernel\n"
         "                  make this program a kernel of Jupyter notebooks, with the options -q, -e, --threads,\n"
         "                  --jobs and --on given with it\n"
         "  --kernel FILE   serve a notebook; Jupyter runs this with a connection file\n"
         "  --version       version, and a hash of the source\n"
         "  --help          this text\n"
         "  --doctor        versions of all libraries, and a test picture\n"
         "\n"
         "Exit status: 0 on success, 1 after an error, also in a case of a study, 2 for an invalid command line, "
         "124 after the time of --time, 130 after Ctrl-C.\n"
         "SIGNORINI_HOME: the folder that contains lua/, if it differs from that of the installation.\n"
         "SIGNORINI_KERNEL: sse2, avx2 or avx512, the widest vector instructions of the element kernels "
         "(default: those of the processor; plain on processors other than x86-64).\n";
}

} // namespace signorini::repl
