#include "repl/kernel/server.hpp"

#include <xeus/xguid.hpp>
#include <xeus/xkernel.hpp>
#include <xeus/xmessage.hpp>

namespace signorini::repl::kernel {

using xeus::channel;

Server::Server(zmq::context_t& context, const xeus::xconfiguration& configuration, nl::json::error_handler_t handler)
    : xserver_shell_main(context, configuration, handler), session_(xeus::new_xguid()) {}

void Server::publish_about(const nl::json& parent, const std::string& type, nl::json content) {
  publish(xeus::xpub_message(type, xeus::make_header(type, xeus::get_user_name(), session_), parent, nl::json::object(),
                             std::move(content), {}),
          channel::SHELL);
}

void Server::publish_impl(xeus::xpub_message message, channel where) {
  if (where == channel::CONTROL) return xserver_shell_main::publish_impl(std::move(message), where);
  const std::lock_guard lock(mutex_);
  xserver_shell_main::publish_impl(std::move(message), where);
}

/// Xeus answers interrupt requests without telling the interpreter, and some requests without a status.
void Server::send_control_impl(xeus::xmessage message) {
  if (message.header().value("msg_type", "") == "interrupt_reply") on_interrupt();
  nl::json content = message.content();
  if (!content.contains("status")) content["status"] = "ok";
  xserver_shell_main::send_control_impl(xeus::xmessage(message.identities(), message.header(), message.parent_header(),
                                                       message.metadata(), std::move(content),
                                                       xeus::buffer_sequence(message.buffers())));
}

/// After a cell that failed: the cells that wait are aborted, other requests are answered. Xeus' own function answers
/// without the states by which front ends recognize that a request has ended.
void Server::abort_queue_impl(const listener&, long) {
  const auto answer = [this](xeus::xmessage request) {
    if (request.header().value("msg_type", "") == "execute_request")
      abort(std::move(request));
    else
      notify_shell_listener(std::move(request));
  };
  xserver_shell_main::abort_queue_impl(answer, 0);
}

void Server::abort(xeus::xmessage request) {
  const nl::json& header = request.header();
  publish_about(header, "status", {{"execution_state", "busy"}});
  send_shell(xeus::xmessage(request.identities(), xeus::make_header("execute_reply", xeus::get_user_name(), session_),
                            header, nl::json::object(), {{"status", "aborted"}}, {}));
  publish_about(header, "status", {{"execution_state", "idle"}});
}

} // namespace signorini::repl::kernel
