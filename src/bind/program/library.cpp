#include "bind/program/library.hpp"
#include "bind/lua/wording/wording.hpp"

#include "base/notice.hpp"
#include "bind/lua/coroutines.hpp"
#include "bind/lua/functions.hpp"
#include "bind/lua/limits.hpp"
#include "bind/lua/open.hpp"
#include "bind/lua/threads.hpp"
#include "bind/program/doctor.hpp"
#include "model/results/face_values.hpp"
#include "model/results/field.hpp"
#include "os/archive.hpp"
#include "os/limits.hpp"
#include "os/machine.hpp"
#include "os/whole_file.hpp"
#include "solve/linear.hpp"
#include "solve/mumps.hpp"
#include "terminal/screen.hpp"
#include "view/camera.hpp"
#include "view/chart.hpp"
#include "view/colorbar.hpp"
#include "view/picture.hpp"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <thread>
#include <unistd.h>
#include <vector>

namespace signorini::bind {

namespace fs = std::filesystem;

namespace {

int core_module(lua_State* L) {
  push_table(L, "core");
  return 1;
}

/// The working directory, by the name that the shell has for it: on clusters the name behind a link differs between
/// machines.
std::string working_directory() {
  std::error_code ignored;
  const char* name = std::getenv("PWD");
  return name && fs::equivalent(name, ".", ignored) ? name : fs::current_path(ignored).string();
}

} // namespace

fs::path find_home() {
  std::vector<fs::path> places;
  if (const char* home = std::getenv("SIGNORINI_HOME"); home && *home)
    places = {home};
  else {
    const fs::path folder = program_file().parent_path();
    places = {folder / "../share/signorini", folder / ".."};
  }
  for (const fs::path& place : places)
    if (fs::exists(place / "lua/signorini.lua")) return fs::canonical(place);
  const auto normal = [](const fs::path& place) { return place.lexically_normal().string(); };
  fail("the library lua/signorini.lua was not found in ", joined_by(", ", places, normal),
       ": install the program with cmake --install, or set SIGNORINI_HOME to the folder that contains lua/");
}

fs::path find_share() {
  const fs::path home = find_home();
  return fs::exists(home / "share") ? home / "share" : home;
}

std::string release() {
  const fs::path home = find_home();
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(home / "lua"))
    if (entry.path().extension() == ".lua") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::string all = source_hash;
  for (const fs::path& file : files) all += text(fs::relative(file, home).string(), "\n", read_file(file.string()));
  return text(SIGNORINI_VERSION " (", fmt::format("{:016x}", checksum(all)), ")");
}

std::string find_script(const std::string& name) {
  if (name.empty() || name == "-" || fs::exists(name) || fs::path(name).is_absolute()) return name;
  const fs::path home = find_home();
  for (const char* folder : {"", "scripts", "scripts/problems", "scripts/studies"}) {
    const fs::path place = home / folder / name;
    const bool script = place.extension() == ".lua" && place.string().starts_with((home / "scripts").string());
    if (script && fs::exists(place)) return place.string();
  }
  return name;
}

void write_new_study(const std::string& file) {
  require(file.ends_with(".lua"), "--new needs the name of a Lua file, got '", file, "': write ", file, ".lua");
  require(!std::filesystem::exists(file), "--new: the file '", file,
          "' exists already and is not overwritten: choose another name");
  write_record(file, read_file((find_share() / "starter.lua").string()));
}

std::string write_editor_settings(const std::string& study) {
  using Json = nlohmann::ordered_json;
  const fs::path folder = fs::path(study).parent_path();
  for (const char* name : {".luarc.json", ".luarc.jsonc"}) {
    const fs::path file = folder / name;
    if (fs::exists(file)) return text("Kept: ", file.string(), ", the settings of editors: share/doc/use/editor.md");
  }
  const fs::path built = program_file().parent_path() / "generated/library";
  const fs::path library = fs::exists(built) ? built : find_share() / "library";
  const Json settings = {{"runtime.version", "Lua 5.4"},
                         {"workspace.library", Json::array({fs::weakly_canonical(library).string()})},
                         {"workspace.checkThirdParty", false}};
  const std::string file = (folder / ".luarc.json").string();
  write_record(file, settings.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  return text("Written: ", file, ", by which editors with a Lua language server complete and check scripts");
}

void open_library(lua_State* L, const Settings& settings) {
  const fs::path home = find_home(), lua = home / "lua";
  luaL_openlibs(L);
  set_library_folder(L, lua.string());
  follow_coroutines(L);
  if (!memory_limit().empty()) note_missing_memory(L, lua.string());

  lua_getglobal(L, "package");
  lua_getfield(L, -1, "path");
  // Supplied scripts come last: they share modules and hide none of the user's.
  const std::string path =
      text((lua / "?.lua").string(), ";", lua_tostring(L, -1), ";", (home / "scripts/?.lua").string());
  lua_pop(L, 1);
  set_field(L, "path", path);
  lua_getfield(L, -1, "preload");
  lua_pushcfunction(L, core_module);
  lua_setfield(L, -2, "signorini.core");
  lua_pop(L, 2);

  push_table(L, "core");
  lua_getglobal(L, "require");
  lua_setfield(L, -2, "require"); // see push_require()
  lua_pop(L, 1);

  word_warnings();
  if (settings.pictures) terminal::set_protocol(*settings.pictures);
  for (auto* open :
       {open_core,    open_algebra,  open_jobs,    open_json,       open_patch,      open_curves, open_shapes,
        open_symbols, open_material, open_body,    open_rigid,      open_scene,      open_model,  open_path,
        open_changes, open_modes,    open_results, open_checkpoint, open_adaptation, open_chart,  open_heatmap,
        open_picture, open_screen,   open_vtu,     open_hdf5})
    open(L);

  push_table(L, "core");
  push_table(L, "sg");
  lua_setfield(L, -2, "sg");
  std::vector<std::string> fields;
  for (const auto& field : model::fields<3>()) fields.push_back(field.name);
  for (const model::FaceField field : model::face_fields) fields.emplace_back(name_of(field));
  const int processors = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  set_fields(L, "terminal", isatty(STDERR_FILENO) == 1, // where progress is displayed
             "interactive", isatty(STDIN_FILENO) && isatty(STDOUT_FILENO), "quiet", settings.quiet, "threads",
             settings.threads, "most_threads", most_threads, "processors", processors, "at_once",
             settings.jobs > 0 ? settings.jobs : processors, "host", host_name(), "program", program_file().string(),
             "directory", working_directory(), "processor", processor_name(), "linear_solvers", solve::linear_names(),
             "mumps", solve::has_mumps(), "ranks", solve::started_ranks(), "fields", fields, "colormaps",
             view::colormaps(), "cameras", view::camera_names(), "markers", view::marker_names(), "share",
             find_share().string(), "home", home.string(), "to_be_continued", to_be_continued);
  if (!settings.on.empty()) set_field(L, "on", settings.on);
  if (!settings.chunk.empty()) set_field(L, "chunk", settings.chunk);
  if (!settings.sandbox.empty()) set_field(L, "sandbox", settings.sandbox);
  lua_newtable(L);
  for (const auto& [name, version] : versions()) set_field(L, name.c_str(), version);
  lua_setfield(L, -2, "versions");
  lua_pop(L, 1);
}

} // namespace signorini::bind
