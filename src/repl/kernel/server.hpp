#pragma once
// The sockets: xeus' server with the requests of the shell on the main thread and those of the control channel on
// another, so that interrupts and shutdowns arrive while a cell runs.

#include <xeus/xserver_shell_main.hpp>

#include <functional>
#include <mutex>

namespace signorini::repl::kernel {

class Server final : public xeus::xserver_shell_main {
public:
  Server(zmq::context_t& context, const xeus::xconfiguration& configuration, nl::json::error_handler_t handler);

  /// Called on the control thread by interrupt requests.
  std::function<void()> on_interrupt = [] {};

  /// Publishes a message about the request with this header; from any thread.
  void publish_about(const nl::json& parent, const std::string& type, nl::json content);

private:
  void publish_impl(xeus::xpub_message message, xeus::channel channel) override;
  void send_control_impl(xeus::xmessage message) override;
  void abort_queue_impl(const listener&, long) override;
  void abort(xeus::xmessage request);

  const std::string session_;
  std::mutex mutex_; ///< of the shell's publishing socket
};

} // namespace signorini::repl::kernel
