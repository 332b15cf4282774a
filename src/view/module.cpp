#include "view/module.hpp"

#include "base/error.hpp"

#include <dlfcn.h>
#include <filesystem>

namespace signorini::view {
namespace {

/// Modules stand in lib/signorini next to the program or to the program's folder (bin, tests).
std::filesystem::path file_of(const char* module) {
  const auto here = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  for (const auto& folder : {here / "lib/signorini", here.parent_path() / "lib/signorini"})
    if (std::filesystem::exists(folder / module)) return folder / module;
  fail("pictures need ", module, ", which is neither in ", (here / "lib/signorini").string(), " nor in ",
       (here.parent_path() / "lib/signorini").string(), "; build it or install the program as a whole");
}

} // namespace

const void* module_table(const char* module, const char* name) {
  const std::string file = file_of(module).string();
  // Never unloaded: VTK's factories, Mesa's threads and GLib's types do not survive that.
  void* loaded = ::dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL | RTLD_NODELETE);
  if (loaded == nullptr) fail("cannot load ", file, " for pictures: ", ::dlerror());
  const void* table = ::dlsym(loaded, name);
  require(table != nullptr, file, " is not Signorini's; install the program as a whole");
  return table;
}

} // namespace signorini::view
