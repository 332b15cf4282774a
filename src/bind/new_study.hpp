#pragma once
// The study that a new user begins with.

#include <string>

namespace signorini::bind {

/// Writes share/starter.lua to a file that does not exist yet, whole or not at all. Throws Error when it exists, its
/// name does not end with .lua, or it cannot be written.
void write_new_study(const std::string& file);

} // namespace signorini::bind
