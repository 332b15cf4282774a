#pragma once
// Modules: parts of the program in shared libraries of their own, loaded when first needed.

#include <array>
#include <filesystem>

namespace signorini {

/// The folders in which modules are looked for: lib/signorini next to the program or to its folder (bin, tests).
std::array<std::filesystem::path, 2> module_folders();

/// The file of a module, such as "signorini_view.so"; empty if none of the folders contains it.
std::filesystem::path find_module(const char* module);

/// What a module's file exports under a name. The file is loaded once and never unloaded: VTK's factories, Mesa's
/// threads, GLib's types and MPI do not survive unloading.
const void* load_module(const std::filesystem::path& file, const char* name);

} // namespace signorini
