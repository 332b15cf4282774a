#pragma once
// The complete language in a Lua state: bindings, the library in lua/, and its location.

#include "terminal/choice.hpp"

#include <lua.hpp>

#include <filesystem>
#include <optional>
#include <string>

namespace signorini::bind {

struct Settings {
  bool quiet = false; ///< no progress, no banner
  int threads = 1;    ///< of BLAS and loops
  int jobs = 0;       ///< parallel processes if a study does not set them; 0: number of processors
  std::string on;     ///< where studies are executed, such as "slurm"; empty: where they say
  std::string chunk;  ///< the cases of one study to solve, "jobs.json:3"; empty: all
  std::optional<terminal::Protocol> pictures = {}; ///< how the terminal takes pictures; by default it is asked
  std::string sandbox;                             ///< the folder of --sandbox; empty without
};

/// The folder that contains lua/: $SIGNORINI_HOME, else ../share/signorini or .. relative to the executable. Throws
/// Error that lists the folders searched.
std::filesystem::path find_home();

/// The folder of supplied data: share/ of the source tree; next to lua/ when installed.
std::filesystem::path find_share();

/// Hash of the files of src that the program was built from; in a source that the build writes.
extern const char* const source_hash;
/// "0.1.0 (3f2a91c0d4e5b687)": the version, and a hash of src and of the library's Lua files, on which results depend.
std::string release();

/// The file of a script: the path as given, or if that does not exist the supplied script of that name, "hertz2d.lua"
/// "problems/hertz2d.lua" or "scripts/problems/hertz2d.lua".
std::string find_script(const std::string& name);

/// Writes share/starter.lua, the study for new users, atomically to a new file. Throws Error when the file exists, its
/// name does not end with .lua, or it cannot be written.
void write_new_study(const std::string& file);

/// Writes .luarc.json next to a study, which tells Lua language servers where the definitions of this library are;
/// existing settings are kept. Returns a line about what was done.
std::string write_editor_settings(const std::string& study);

/// Opens Lua's own libraries, the bindings (module "signorini.core"), and package.path: the library first, the supplied
/// scripts last.
void open_library(lua_State* L, const Settings& settings);

} // namespace signorini::bind
