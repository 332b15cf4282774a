#include "bind/library.hpp"
#include "bind/wording/wording.hpp"

#include "base/machine.hpp"
#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "bind/threads.hpp"
#include "bind/versions.hpp"
#include "model/field.hpp"
#include "solve/linear.hpp"
#include "view/camera.hpp"
#include "view/picture.hpp"

#include <algorithm>
#include <cstdlib>
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

} // namespace

fs::path find_home() {
  std::vector<fs::path> places;
  if (const char* home = std::getenv("SIGNORINI_HOME"); home && *home)
    places = {home};
  else {
    const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
    places = {folder / "../share/signorini", folder / ".."};
  }
  std::string tried;
  for (const fs::path& place : places) {
    if (fs::exists(place / "lua/signorini.lua")) return fs::canonical(place);
    tried += (tried.empty() ? "" : ", ") + place.lexically_normal().string();
  }
  fail("the library lua/signorini.lua is not in ", tried,
       ": install the program with cmake --install, or set SIGNORINI_HOME to the folder that holds lua/");
}

fs::path find_share() {
  const fs::path home = find_home();
  return fs::exists(home / "share") ? home / "share" : home;
}

std::string find_script(const std::string& name) {
  if (name.empty() || name == "-" || fs::exists(name) || fs::path(name).is_absolute()) return name;
  const fs::path home = find_home();
  const fs::path place = name.starts_with("scripts/") ? home / name : home / "scripts" / name;
  return place.extension() == ".lua" && fs::exists(place) ? place.string() : name;
}

void open_library(lua_State* L, const Settings& settings) {
  const fs::path home = find_home(), lua = home / "lua";
  luaL_openlibs(L);
  set_library_folder(L, lua.string());

  lua_getglobal(L, "package");
  lua_getfield(L, -1, "path");
  // The scripts that come along stand last: they share modules, and hide none of the user's.
  const std::string path =
      text((lua / "?.lua").string(), ";", lua_tostring(L, -1), ";", (home / "scripts/?.lua").string());
  lua_pop(L, 1);
  set_field(L, "path", path);
  lua_getfield(L, -1, "preload");
  lua_pushcfunction(L, core_module);
  lua_setfield(L, -2, "signorini.core");
  lua_pop(L, 2);

  word_warnings();
  open_core(L);
  open_content(L);
  open_jobs(L);
  open_files(L);
  open_json(L);
  open_patch(L);
  open_curves(L);
  open_exchange(L);
  open_shapes(L);
  open_material(L);
  open_body(L);
  open_rigid(L);
  open_scene(L);
  open_model(L);
  open_checkpoint(L);
  open_chart(L);
  open_heatmap(L);
  open_picture(L);
  open_vtu(L);

  push_table(L, "core");
  push_table(L, "sg");
  lua_setfield(L, -2, "sg");
  set_field(L, "terminal", isatty(STDERR_FILENO) == 1); // where progress is shown
  set_field(L, "quiet", settings.quiet);
  set_field(L, "threads", settings.threads);
  set_field(L, "most_threads", most_threads);
  set_field(L, "linear_solvers", solve::linear_names());
  set_field(L, "colormaps", view::colormaps());
  set_field(L, "cameras", view::camera_names());
  set_field(L, "markers", view::marker_names());
  std::vector<std::string> fields;
  for (const auto& field : model::fields<3>()) fields.push_back(field.name);
  fields.push_back("contact_pressure");
  set_field(L, "fields", fields);
  const int processors = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  set_field(L, "processors", processors);
  set_field(L, "at_once", settings.jobs > 0 ? settings.jobs : processors);
  set_field(L, "host", host_name());
  set_field(L, "processor", processor_name());
  lua_newtable(L);
  for (const auto& [name, version] : versions()) set_field(L, name.c_str(), version);
  lua_setfield(L, -2, "versions");
  set_field(L, "share", find_share().string());
  set_field(L, "home", home.string());
  lua_pop(L, 1);
}

} // namespace signorini::bind
