#pragma once
// The output of cells: what this process and its children write to stdout and stderr, sent to the front end as it
// comes.

#include <nlohmann/json.hpp>

#include <array>
#include <functional>
#include <mutex>
#include <string>

namespace signorini::repl::kernel {

class Output {
public:
  /// publish(stream, text, parent): sends "stdout" or "stderr" for the request with this header; from any thread.
  using Publish = std::function<void(const char* stream, const std::string& text, const nlohmann::json& parent)>;
  explicit Output(Publish publish);
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  /// Starts the thread that follows the output; this object must then live as long as the process.
  void start();
  /// Begins a cell, the request with this header: redirects stdout and stderr. `silent`: what is written is discarded.
  void begin(nlohmann::json parent, bool silent);
  /// Sends what has been written until now, so that what is sent next follows it.
  void flush();
  /// Ends the cell: restores stdout and stderr, sends the rest.
  void end();

private:
  struct Stream {
    const char* name;
    int descriptor, original, read_end, write_end;
    std::string left = {}; ///< the beginning of a character whose end has not come yet
  };
  void send_available(bool all);
  void follow();

  Publish publish_;
  std::array<Stream, 2> streams_;
  nlohmann::json parent_ = nlohmann::json::object();
  bool silent_ = false;
  std::mutex mutex_; ///< of all above
};

} // namespace signorini::repl::kernel
