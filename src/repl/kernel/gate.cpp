#include "repl/kernel/gate.hpp"

#include "repl/kernel/thread.hpp"

#include <nlohmann/json.hpp>
#include <zmq_addon.hpp>

#include <algorithm>
#include <initializer_list>

namespace signorini::repl::kernel {

namespace {

constexpr const char* inside_ip = "signorini";

std::string place_of(const xeus::xconfiguration& configuration, const std::string& port) {
  const char* separator = configuration.m_transport == "tcp" ? ":" : "-"; // as xeus writes it
  return configuration.m_transport + "://" + configuration.m_ip + separator + port;
}

xeus::xraw_buffer buffer_of(const zmq::message_t& frame) {
  return {frame.data<const unsigned char>(), frame.size()};
}

/// True if a frame is an object of JSON whose named entries, if they are there, are texts.
bool is_object(const zmq::message_t& frame, std::initializer_list<const char*> texts = {}) {
  const auto json = nlohmann::json::parse(frame.to_string_view(), nullptr, false);
  return json.is_object() && std::all_of(texts.begin(), texts.end(), [&](const char* name) {
           return !json.contains(name) || json[name].is_string();
         });
}

/// Identities, a delimiter, signature, header, parent's header, metadata, content, buffers:
/// https://jupyter-client.readthedocs.io/en/stable/messaging.html#the-wire-protocol
bool is_valid(const zmq::multipart_t& message, const xeus::xauthentication& authentication) {
  std::size_t at = 0;
  while (at < message.size() && message[at].to_string_view() != "<IDS|MSG>") ++at;
  if (at == 0 || at + 6 > message.size()) return false;
  const zmq::message_t &header = message[at + 2], &parent = message[at + 3], &metadata = message[at + 4],
                       &content = message[at + 5];
  return authentication.verify(buffer_of(message[at + 1]), buffer_of(header), buffer_of(parent), buffer_of(metadata),
                               buffer_of(content)) &&
         is_object(header, {"msg_id", "msg_type", "username", "session", "date", "version"}) && is_object(parent) &&
         is_object(metadata) && is_object(content);
}

} // namespace

xeus::xconfiguration behind_gate(xeus::xconfiguration outside) {
  outside.m_transport = "inproc"; // within the process
  outside.m_ip = inside_ip;
  return outside;
}

void Gate::add(zmq::context_t& context, const std::string& port, bool checked, zmq::socket_type outside,
               zmq::socket_type inside) {
  Lane lane{{context, outside}, {context, inside}, checked};
  lane.inside.set(zmq::sockopt::sndhwm, 0); // a cell that runs must not hold up interrupts
  // Xeus answers on one socket those that have asked on another, by their identities, of which this is the first.
  if (inside == zmq::socket_type::dealer) lane.inside.set(zmq::sockopt::routing_id, "gate");
  lane.outside.bind(place_of(configuration_, port));
  lane.inside.connect(place_of(behind_gate(configuration_), port));
  lanes_.push_back(std::move(lane));
}

Gate::Gate(zmq::context_t& context, const xeus::xconfiguration& outside)
    : configuration_(outside), authentication_(xeus::make_xauthentication(outside.m_signature_scheme, outside.m_key)),
      end_(context, zmq::socket_type::pair), ended_(context, zmq::socket_type::pair) {
  using zmq::socket_type;
  add(context, outside.m_shell_port, true, socket_type::router, socket_type::dealer);
  add(context, outside.m_control_port, true, socket_type::router, socket_type::dealer);
  add(context, outside.m_stdin_port, true, socket_type::router, socket_type::dealer);
  add(context, outside.m_iopub_port, false, socket_type::xpub, socket_type::xsub);
  add(context, outside.m_hb_port, false, socket_type::router, socket_type::dealer);
  end_.bind("inproc://gate");
  ended_.connect("inproc://gate");
  thread_ = thread_without_signals([this] { serve(); });
}

Gate::~Gate() {
  end_.send(zmq::message_t(), zmq::send_flags::none);
}

/// Passes on one message of each socket that has one; returns whether there was one.
bool Gate::pass_on(std::chrono::milliseconds patience) {
  std::vector<zmq::pollitem_t> items;
  for (Lane& lane : lanes_) {
    items.push_back({lane.outside.handle(), 0, ZMQ_POLLIN, 0});
    items.push_back({lane.inside.handle(), 0, ZMQ_POLLIN, 0});
  }
  items.push_back({ended_.handle(), 0, ZMQ_POLLIN, 0});
  zmq::poll(items, patience);
  bool any = false;
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    Lane& lane = lanes_[i];
    zmq::multipart_t message;
    if (items[2 * i].revents != 0 && message.recv(lane.outside)) {
      any = true;
      if (!lane.checked || is_valid(message, *authentication_)) message.send(lane.inside);
    }
    message.clear();
    if (items[2 * i + 1].revents != 0 && message.recv(lane.inside)) {
      any = true;
      message.send(lane.outside);
    }
  }
  return any;
}

void Gate::serve() {
  zmq::message_t end;
  while (!ended_.recv(end, zmq::recv_flags::dontwait)) pass_on(std::chrono::milliseconds(-1));
  while (pass_on(std::chrono::milliseconds(100))) {
  }
}

} // namespace signorini::repl::kernel
