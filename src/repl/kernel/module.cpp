// The Jupyter kernel on xeus (https://github.com/jupyter-xeus/xeus), which speaks the protocol over ZeroMQ.
#include "repl/kernel/gate.hpp"
#include "repl/kernel/interpreter.hpp"
#include "repl/kernel/server.hpp"

#include <xeus/xkernel.hpp>
#include <xeus/xkernel_configuration.hpp>
#include <zmq.hpp>

#include <iostream>

namespace signorini::repl::kernel {

namespace {

std::string description() {
  const auto [major, minor, patch] = zmq::version();
  return "xeus " + std::to_string(XEUS_VERSION_MAJOR) + "." + std::to_string(XEUS_VERSION_MINOR) + "." +
         std::to_string(XEUS_VERSION_PATCH) + ", ZeroMQ " + std::to_string(major) + "." + std::to_string(minor) + "." +
         std::to_string(patch);
}

xeus::xconfiguration configuration_of(const Connection& connection) {
  xeus::xconfiguration configuration;
  configuration.m_transport = connection.transport;
  configuration.m_ip = connection.ip;
  configuration.m_shell_port = connection.shell;
  configuration.m_control_port = connection.control;
  configuration.m_stdin_port = connection.input;
  configuration.m_iopub_port = connection.publisher;
  configuration.m_hb_port = connection.heartbeat;
  configuration.m_signature_scheme = connection.key.empty() ? "none" : connection.scheme;
  configuration.m_key = connection.key;
  return configuration;
}

/// The server that xkernel makes by a function without state.
Server* server = nullptr;
std::unique_ptr<xeus::xserver> make_server(xeus::xcontext& context, const xeus::xconfiguration& configuration,
                                           nl::json::error_handler_t handler) {
  auto made = std::make_unique<Server>(context.get_wrapped_context<zmq::context_t>(), configuration, handler);
  server = made.get();
  return made;
}

/// The kernel lives until the process ends, because threads of xeus use it.
std::string serve(const Connection& connection,
                  const std::function<std::unique_ptr<Evaluator>(FrontEnd& front_end)>& make_evaluator) {
  auto history = std::make_unique<History>();
  const auto publish = [](const char* stream, const std::string& text, const nl::json& parent) {
    server->publish_about(parent, "stream", {{"name", stream}, {"text", text}});
  };
  auto interpreter = std::make_unique<Interpreter>(publish, *history, make_evaluator);
  Interpreter& running = *interpreter;
  try {
    // Invalid UTF-8 in output is replaced.
    const xeus::xconfiguration configuration = configuration_of(connection);
    auto context = xeus::make_context<zmq::context_t>();
    static Gate gate(context->get_wrapped_context<zmq::context_t>(), configuration);
    auto& kernel = *new xeus::xkernel(behind_gate(configuration), xeus::get_user_name(), std::move(context),
                                      std::move(interpreter), make_server, std::move(history), nullptr,
                                      xeus::make_null_debugger, nl::json::object(), nl::json::error_handler_t::replace);
    server->on_interrupt = [&running] { running.interrupt(); };
    std::clog.setstate(std::ios::failbit); // xeus greets there
    kernel.start();                        // ends the process
    return "";
  } catch (const zmq::error_t& error) {
    return error.what();
  }
}

} // namespace
} // namespace signorini::repl::kernel

extern "C" const signorini::repl::KernelModule signorini_kernel = {signorini::repl::kernel::description,
                                                                   signorini::repl::kernel::serve};
