#pragma once
// What takes long to load, or only some runs need, lives in modules of its own in lib/signorini: OpenGL with VTK, Cairo
// with Pango. The first picture loads them.

namespace signorini::view {

/// The table of functions that a module has under a name; the module stays loaded. Throws Error where it is missing.
const void* module_table(const char* module, const char* name);

} // namespace signorini::view
