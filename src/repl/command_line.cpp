#include "repl/command_line.hpp"

#include "bind/message.hpp"
#include "bind/threads.hpp"

#include <charconv>

namespace signorini::repl {

namespace {

int parse_threads(const std::string& word) {
  int threads = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), threads);
  if (error != std::errc() || end != word.data() + word.size() || threads < 1 || threads > bind::most_threads)
    throw UsageError(text("--threads takes a whole number from 1 to ", bind::most_threads, ", got '", word, "'"));
  return threads;
}

} // namespace

CommandLine parse(const std::vector<std::string>& words) {
  const std::vector<std::string> known = {"-e", "-i", "-q", "--threads", "--version", "--help", "--doctor"};
  CommandLine line;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const auto value = [&](const char* what) -> const std::string& {
      if (i + 1 == words.size()) throw UsageError(text(word, " needs ", what, " behind it"));
      return words[++i];
    };
    if (word == "-e")
      line.code.push_back(value("code, such as -e 'print(sg)'"));
    else if (word == "-i")
      line.interactive = true;
    else if (word == "-q")
      line.quiet = true;
    else if (word == "--threads")
      line.threads = parse_threads(value("a number"));
    else if (word.starts_with("--threads="))
      line.threads = parse_threads(word.substr(10));
    else if (word == "--version")
      line.wish = CommandLine::Wish::version;
    else if (word == "--help" || word == "-h")
      line.wish = CommandLine::Wish::help;
    else if (word == "--doctor")
      line.wish = CommandLine::Wish::doctor;
    else if (word.starts_with("-") && word != "-")
      throw UsageError(text("unknown option '", word, "'", bind::did_you_mean(word, known),
                            "; options stand before the script, --help lists them"));
    else {
      line.script = word;
      line.arguments.assign(words.begin() + static_cast<std::ptrdiff_t>(i) + 1, words.end());
      break;
    }
  }
  return line;
}

const char* usage() {
  return "signorini: isogeometric contact mechanics from Lua\n"
         "\n"
         "  signorini                       prompt with history, completion and help()\n"
         "  signorini study.lua [args…]     run a script; its arguments are in `arg`\n"
         "  echo 'code' | signorini -       run what standard input says\n"
         "\n"
         "  -e 'code'       run code (may be repeated, before the script)\n"
         "  -i              go to the prompt afterwards\n"
         "  -q              no progress, no greeting\n"
         "  --threads N     threads of assembly and linear algebra (1)\n"
         "  --version       version\n"
         "  --help          this text\n"
         "  --doctor        versions of all libraries, and a test picture\n"
         "\n"
         "Exit status: 0 when all went well, 1 after an error, 2 for a wrong command line, 130 after Ctrl-C.\n"
         "SIGNORINI_HOME: the folder that holds lua/, if it is not where the program was installed.\n";
}

} // namespace signorini::repl
