#include "repl/connection.hpp"

#include "bind/lua/message.hpp"
#include "os/whole_file.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

namespace signorini::repl {

namespace {

using ConnectionJson = nlohmann::json;

/// The checked entries of a connection file.
struct Entries {
  const std::string& file;
  ConnectionJson json;

  [[noreturn]] void fail(const std::string& key, const std::string& expected) const {
    const std::string got = json.contains(key) ? "got " + json[key].dump() : "which is missing";
    bind::fail("--kernel: ", key, " of the connection file '", file, "' must be ", expected, ", ", got);
  }

  std::string word(const std::string& key, const std::vector<std::string>& known) const {
    const bool ok = json.contains(key) && json[key].is_string() &&
                    std::find(known.begin(), known.end(), json[key].get<std::string>()) != known.end();
    if (!ok) fail(key, bind::one_of(known));
    return json[key].get<std::string>();
  }
  std::string any(const std::string& key) const {
    if (!json.contains(key) || !json[key].is_string()) fail(key, "a text");
    return json[key].get<std::string>();
  }
  std::string port(const std::string& key) const {
    constexpr int largest = 65535;
    const bool ok = json.contains(key) && json[key].is_number_integer() && json[key].get<double>() >= 1 &&
                    json[key].get<double>() <= largest;
    if (!ok) fail(key, text("a port, an integer from 1 to ", largest));
    return std::to_string(json[key].get<int>());
  }
};

constexpr const char* who_writes = "Hint: Jupyter writes this file when it starts a kernel; --install-kernel makes the "
                                   "kernel known to it";

} // namespace

Connection read_connection(const std::string& file) {
  if (!std::filesystem::is_regular_file(file))
    bind::fail("--kernel must be followed by a connection file, got '", file, "', which ",
               std::filesystem::exists(file) ? "is not a file. " : "does not exist. ", who_writes);
  Entries entries{file, ConnectionJson::parse(read_file(file), nullptr, false)};
  if (!entries.json.is_object())
    bind::fail("--kernel must be followed by a connection file, got '", file, "', which is not a JSON object. ",
               who_writes);
  Connection connection;
  connection.transport = entries.word("transport", {"tcp", "ipc"});
  connection.ip = entries.any("ip");
  connection.shell = entries.port("shell_port");
  connection.control = entries.port("control_port");
  connection.input = entries.port("stdin_port");
  connection.publisher = entries.port("iopub_port");
  connection.heartbeat = entries.port("hb_port");
  connection.key = entries.any("key");
  if (!connection.key.empty())
    connection.scheme = entries.word(
        "signature_scheme", {"hmac-sha256", "hmac-sha224", "hmac-sha384", "hmac-sha512", "hmac-sha1", "hmac-md5"});
  return connection;
}

} // namespace signorini::repl
