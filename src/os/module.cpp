#include "os/module.hpp"

#include "base/error.hpp"
#include "os/machine.hpp"

#include <dlfcn.h>

namespace signorini {

std::array<std::filesystem::path, 2> module_folders() {
  const auto here = program_file().parent_path();
  return {here / "lib/signorini/modules", here.parent_path() / "lib/signorini/modules"};
}

std::filesystem::path find_module(const char* module) {
  for (const auto& folder : module_folders())
    if (std::filesystem::exists(folder / module)) return folder / module;
  return {};
}

const void* load_module(const std::filesystem::path& file, const char* name) {
  void* loaded = ::dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL | RTLD_NODELETE);
  if (loaded == nullptr) fail("os.module.load", {{"file", file.string()}, {"reason", ::dlerror()}});
  const void* found = ::dlsym(loaded, name);
  require(found != nullptr, "os.module.foreign", {{"file", file.string()}});
  return found;
}

} // namespace signorini
