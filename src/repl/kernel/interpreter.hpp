#pragma once
// Answers the requests of front ends.

#include "repl/kernel/history.hpp"
#include "repl/kernel/output.hpp"
#include "repl/kernel_module.hpp"

#include <xeus/xinterpreter.hpp>

#include <atomic>
#include <thread>
#include <unistd.h>

namespace signorini::repl::kernel {

class Interpreter final : public xeus::xinterpreter, private FrontEnd {
public:
  Interpreter(Output::Publish publish, History& history,
              const std::function<std::unique_ptr<Evaluator>(FrontEnd&)>& make_evaluator);

  void interrupt() { evaluator_->interrupt(); }

private:
  void configure_impl() override { output_.start(); }
  nl::json execute_request_impl(int number, const std::string& code, bool silent, bool store_history,
                                nl::json user_expressions, bool allow_stdin) override;
  nl::json complete_request_impl(const std::string& code, int cursor) override;
  nl::json inspect_request_impl(const std::string& code, int cursor, int detail_level) override;
  nl::json is_complete_request_impl(const std::string& code) override;
  nl::json kernel_info_request_impl() override;
  void shutdown_request_impl() override;

  void show(const Display& display) override;
  void replace(const std::string& name, const std::string& text) override;
  std::string read_line() override;

  void check_process(const char* what) const;
  /// Only the shell's thread may call the evaluator.
  bool on_shell() const { return std::this_thread::get_id() == shell_; }
  nl::json values_of(const nl::json& expressions);

  const pid_t process_ = getpid(); ///< not one that was forked from it
  const std::thread::id shell_ = std::this_thread::get_id();
  Output output_;
  History& history_;
  std::unique_ptr<Evaluator> evaluator_;
  std::vector<std::string> replaceable_; ///< names of texts of this cell
  int number_ = 0;                       ///< of this cell
  bool silent_ = false, has_input_ = false;
  std::atomic<bool> ending_ = false;
};

} // namespace signorini::repl::kernel
