#include "base/notice.hpp"
#include "base/text.hpp"
#include "bind/lua/threads.hpp"
#include "bind/lua/wording/wording.hpp"
#include "bind/program/doctor.hpp"
#include "bind/program/library.hpp"
#include "bind/program/ranks.hpp"
#include "os/interrupt.hpp"
#include "os/limits.hpp"
#include "repl/command_line.hpp"
#include "repl/interpreter.hpp"
#include "repl/interrupt.hpp"
#include "repl/kernel.hpp"
#include "repl/kernel_spec.hpp"
#include "repl/line_editor.hpp"
#include "repl/prompt.hpp"
#include "repl/sandbox.hpp"
#include "repl/standard_streams.hpp"

#include <iostream>
#include <malloc.h>
#include <unistd.h>

using namespace signorini;

namespace {

constexpr int kept_memory = 256 << 20, large_block = 32 << 20; // bytes

enum Status { success = 0, failure = 1, wrong_usage = 2, out_of_time_limit = 124, stopped_by_user = 130 };

[[noreturn]] void serve(const repl::CommandLine& line, const std::string& program) {
  repl::Interpreter interpreter({line.quiet, line.threads, line.jobs, line.on, {}, {}, {}});
  repl::catch_interrupts();
  interpreter.set_arguments(program, "", {});
  repl::serve_kernel(interpreter, line.connection, line.code);
}

bool run(const repl::CommandLine& line, const std::string& program) {
  repl::Interpreter interpreter(
      {line.quiet, line.threads, line.jobs, line.on, line.chunk, line.pictures, line.sandbox});
  repl::catch_interrupts();
  if (line.time) repl::limit_time(line.time->amount, line.time->written);
  if (isatty(STDERR_FILENO)) acknowledge_interrupts(STDERR_FILENO);
  if (line.interactive || line.prompt_only()) survive_interrupts(); // the prompt stays usable with its variables
  const std::string script = bind::find_script(line.script);
  if (script != line.script && !line.quiet) std::cerr << text("signorini: running ", script, "\n");
  interpreter.set_arguments(program, script, line.arguments);
  // A script in a file loads the library itself; typed code has it loaded already.
  const bool typed = line.interactive || line.script.empty() || line.script == "-" || !line.code.empty();
  if (typed && !interpreter.open_globals()) return false;
  start_time_limit();
  bool ok = true;
  for (const auto& code : line.code) ok = ok && interpreter.run_code(code, "=(command line)");
  ok = ok && (line.script.empty() || interpreter.run_file(script, line.arguments));
  if (ok && !line.chunk.empty()) { // study:execute ends the program when the chunk is solved
    std::cerr << text("signorini: the script ended without executing the study of ", line.chunk,
                      ". Hint: the script and its arguments must be those of the submission\n");
    return false;
  }
  if (!line.interactive && !line.prompt_only()) return ok && !interpreter.lost_cases();
  repl::forget_interrupt(interpreter.state()); // the variables may still be inspected
  repl::finish_statements();
  return repl::prompt(interpreter, line.quiet) && ok;
}

} // namespace

int main(int argc, char** argv) {
  repl::open_standard_streams();
  repl::report_lost_output();
  // Freed memory stays with the process: bodies and matrices are made again and again, and a fresh page costs a fault.
  mallopt(M_TRIM_THRESHOLD, kept_memory);
  mallopt(M_MMAP_THRESHOLD, large_block);
  try {
    if (!bind::leads_ranks()) return success;
    repl::CommandLine line = repl::parse({argv + 1, argv + argc});
    repl::apply_limits(line, argv);
    bind::set_threads(line.threads);
    if (!line.chunk.empty()) catch_notice();
    switch (line.action) {
    case repl::CommandLine::Action::version:
      std::cout << "signorini " << bind::release() << "\n";
      return success;
    case repl::CommandLine::Action::help:
      std::cout << repl::usage();
      return success;
    case repl::CommandLine::Action::doctor:
      return bind::doctor(std::cout, line.threads,
                          {{"readline", repl::readline_version}, {"Jupyter", repl::kernel_description}})
                 ? success
                 : failure;
    case repl::CommandLine::Action::new_study:
      bind::write_new_study(line.new_study);
      std::cout << "Written: " << line.new_study << "; run it with: " << argv[0] << " " << line.new_study << "\n";
      std::cout << bind::write_editor_settings(line.new_study) << "\n";
      return success;
    case repl::CommandLine::Action::install_kernel:
      std::cout << "Written: " << repl::install_kernel(repl::common_options(line)).string()
                << "; notebooks offer the kernel Signorini\n";
      return success;
    case repl::CommandLine::Action::kernel:
      serve(line, argv[0]);
    case repl::CommandLine::Action::run:
      break;
    }
    const bool ok = run(line, argv[0]);
    if (interrupted()) return out_of_time() ? out_of_time_limit : stopped_by_user;
    return ok ? success : failure;
  } catch (const repl::UsageError& error) {
    std::cerr << text("signorini: ", error.what(), "\n");
    return wrong_usage;
  } catch (const std::exception& error) {
    std::cerr << text("signorini: ", bind::worded(error), "\n");
    return failure;
  }
}
