#pragma once
// The sockets that front ends see. Xeus takes any message for a valid one, and ends the process at the first that is
// not: only those with all parts, the right signature and JSON pass to its own sockets, which no other process reaches.

#include <xeus/xauthentication.hpp>
#include <xeus/xkernel_configuration.hpp>
#include <zmq.hpp>

#include <memory>
#include <thread>
#include <vector>

namespace signorini::repl::kernel {

/// The configuration of xeus' sockets behind a gate.
xeus::xconfiguration behind_gate(xeus::xconfiguration outside);

class Gate {
public:
  /// Listens as `outside` states and passes messages on, on a thread of its own. Throws zmq::error_t if it cannot.
  Gate(zmq::context_t& context, const xeus::xconfiguration& outside);
  /// Passes on what has been sent so far.
  ~Gate();
  Gate(const Gate&) = delete;
  Gate& operator=(const Gate&) = delete;

private:
  struct Lane {
    zmq::socket_t outside, inside;
    bool checked; ///< true if what comes from outside must be a valid request
  };

  void add(zmq::context_t& context, const std::string& port, bool checked, zmq::socket_type outside,
           zmq::socket_type inside);
  bool pass_on(std::chrono::milliseconds patience);
  void serve();

  const xeus::xconfiguration configuration_;
  std::unique_ptr<xeus::xauthentication> authentication_;
  std::vector<Lane> lanes_;
  zmq::socket_t end_, ended_; ///< a pair: what the destructor sends, and the thread receives
  std::jthread thread_;
};

} // namespace signorini::repl::kernel
