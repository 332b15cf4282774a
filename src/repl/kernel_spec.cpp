#include "repl/kernel_spec.hpp"

#include "bind/lua/message.hpp"
#include "bind/program/library.hpp"
#include "os/machine.hpp"
#include "os/whole_file.hpp"
#include "repl/kernel.hpp"

#include <cstdlib>
#include <nlohmann/json.hpp>

namespace signorini::repl {

namespace {

std::filesystem::path jupyter_folder() {
  const auto variable = [](const char* name) -> std::filesystem::path {
    const char* value = std::getenv(name);
    return value ? value : "";
  };
  if (const auto folder = variable("JUPYTER_DATA_DIR"); !folder.empty()) return folder;
  if (const auto folder = variable("XDG_DATA_HOME"); !folder.empty()) return folder / "jupyter";
  const auto home = variable("HOME");
  if (home.empty()) bind::fail("--install-kernel needs a folder. Hint: set HOME or JUPYTER_DATA_DIR");
  return home / ".local/share/jupyter";
}

} // namespace

std::filesystem::path install_kernel(const std::vector<std::string>& options) {
  require_kernel("--install-kernel");
  // The order of entries is kept.
  using SpecJson = nlohmann::ordered_json;
  const std::filesystem::path logos = bind::find_share() / "jupyter", folder = jupyter_folder() / "kernels/signorini";
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    bind::fail("--install-kernel: cannot create the folder '", folder.string(), "' (", error.message(),
               "). Hint: JUPYTER_DATA_DIR sets another one");
  SpecJson spec = SpecJson::parse(read_file((logos / "kernel.json").string()));
  std::vector<std::string> arguments = {program_file().string()};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const auto given = spec["argv"].get<std::vector<std::string>>();
  arguments.insert(arguments.end(), given.begin() + 1, given.end());
  spec["argv"] = arguments;
  if (const char* home = std::getenv("SIGNORINI_HOME"))
    spec["env"] = {{"SIGNORINI_HOME", std::filesystem::absolute(home).string()}};
  for (const char* logo : {"logo-32x32.png", "logo-64x64.png"})
    write_record((folder / logo).string(), read_file((logos / logo).string()));
  write_record((folder / "kernel.json").string(), spec.dump(1) + "\n");
  return folder;
}

} // namespace signorini::repl
