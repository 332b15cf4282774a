#pragma once
// The whole language in a Lua state: bindings, the library of the lua/ folder, and where that folder is.

#include <lua.hpp>

#include <filesystem>
#include <string>

namespace signorini::bind {

struct Settings {
  bool quiet = false; ///< no progress, no banner
  int threads = 1;    ///< for BLAS and loops
  int jobs = 0;       ///< processes side by side where a study does not say; 0: as many as there are processors
};

/// The folder that holds lua/: $SIGNORINI_HOME, else ../share/signorini or .. seen from the executable.
/// Throws Error that lists where it looked.
std::filesystem::path find_home();

/// The folder of data that come with the program: share/ of the source tree, in an installed tree beside lua/.
std::filesystem::path find_share();

/// The file of a script: as it is named, or where there is no such file the one of that name among the scripts that
/// come along, "hertz2d.lua" or "scripts/hertz2d.lua".
std::string find_script(const std::string& name);

/// Writes share/starter.lua, the study that a new user begins with, to a file that does not exist yet, whole or not at
/// all. Throws Error when it exists, its name does not end with .lua, or it cannot be written.
void write_new_study(const std::string& file);

/// Opens Lua's own libraries, the bindings (module "signorini.core"), and package.path: the library first, the
/// scripts that come along last.
void open_library(lua_State* L, const Settings& settings);

} // namespace signorini::bind
