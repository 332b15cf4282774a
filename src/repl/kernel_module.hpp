#pragma once
// The interface between the program, which evaluates cells, and the module of the Jupyter kernel (src/repl/kernel),
// which speaks the protocol: https://jupyter-client.readthedocs.io/en/stable/messaging.html.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace signorini::repl {

/// What a connection file states: where to listen, and the key of the signatures. Ports as text.
struct Connection {
  std::string transport, ip, shell, control, input, publisher, heartbeat, scheme, key;
};

/// A value in the formats from which a front end chooses: MIME types with texts or, for images, bytes.
struct Display {
  std::vector<std::pair<std::string, std::string>> formats;
  int width = 0, height = 0; ///< of images, in CSS pixels; 0: their own size
};

struct Failure {
  std::string name, message, traceback; ///< traceback: with the message, as it is shown
};

/// How an evaluation ended: a failure, a value to show, or neither.
struct Outcome {
  std::optional<Failure> failure;
  std::optional<Display> value;
};

/// Positions count characters (Unicode code points).
struct Completions {
  std::vector<std::string> matches;
  int begin = 0, end = 0;
};

enum class Completeness { complete, incomplete, invalid };

/// What a running cell asks of the front end. Errors are std::exception.
class FrontEnd {
public:
  virtual ~FrontEnd() = default;
  virtual void show(const Display& display) = 0;
  /// Shows a text, later calls with the same name replace it.
  virtual void replace(const std::string& name, const std::string& text) = 0;
  /// Asks the user for a line.
  virtual std::string read_line() = 0;
};

/// The program. All functions are called on the thread that called serve(), but interrupt() and interrupted(), which
/// other threads call.
class Evaluator {
public:
  virtual ~Evaluator() = default;
  /// Executes a cell; `number` counts cells from 1.
  virtual Outcome execute(const std::string& code, int number) = 0;
  /// The value of an expression, which does not become `_`.
  virtual Outcome evaluate(const std::string& expression) = 0;
  virtual Completions complete(const std::string& code, int cursor) = 0;
  /// The help page of the name at the cursor, no formats if there is none.
  virtual Display inspect(const std::string& code, int cursor) = 0;
  /// Tells if code could be executed, and the indentation of its next line.
  virtual std::pair<Completeness, std::string> test(const std::string& code) = 0;
  /// Interrupts the running cell.
  virtual void interrupt() = 0;
  /// True if the running cell was interrupted.
  virtual bool interrupted() const = 0;
  virtual std::string version() const = 0;
  virtual std::string language_version() const = 0;
};

/// What the module exports as signorini_kernel.
struct KernelModule {
  std::string (*description)();
  /// Serves front ends until one of them ends the process. Returns only if it cannot listen, with the reason. The
  /// thread that calls it must block SIGINT.
  std::string (*serve)(const Connection& connection,
                       const std::function<std::unique_ptr<Evaluator>(FrontEnd& front_end)>& make_evaluator);
};

} // namespace signorini::repl
