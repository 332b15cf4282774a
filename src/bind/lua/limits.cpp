#include "bind/lua/limits.hpp"

#include "base/text.hpp"
#include "bind/lua/coroutines.hpp"
#include "os/limits.hpp"

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace signorini::bind {

namespace {

std::string own_chunks;              // how the sources of the library's chunks begin
char position[LUA_IDSIZE + 16] = ""; // "script.lua:12: "

/// Allocates nothing.
void note_position(lua_State* L) {
  lua_Debug frame;
  for (int level = 0; L && lua_getstack(L, level, &frame); ++level) {
    lua_getinfo(L, "Sl", &frame);
    if (frame.currentline <= 0 || std::string_view(frame.source).starts_with(own_chunks)) continue;
    std::snprintf(position, sizeof position, "%s:%d: ", frame.short_src, frame.currentline);
    return;
  }
}

void* allocate(void*, void* block, std::size_t, std::size_t size) {
  if (size == 0) {
    std::free(block);
    return nullptr;
  }
  void* made = std::realloc(block, size);
  if (!made) note_position(running_thread());
  return made;
}

} // namespace

void note_missing_memory(lua_State* L, const std::string& library) {
  own_chunks = text("@", library, "/");
  lua_setallocf(L, allocate, nullptr);
}

std::string missing_memory() {
  const std::string& limit = memory_limit();
  if (limit.empty()) return "not enough memory: use fewer elements, points or pixels";
  return text("more memory is needed than the ", limit,
              " allowed by --memory: use fewer elements, points or pixels, or "
              "allow more");
}

std::string missing_lua_memory() {
  return position + missing_memory();
}

std::string interruption() {
  if (!out_of_time()) return "interrupted";
  return text("stopped, because the time limit of ", time_limit(), " is over (--time)");
}

} // namespace signorini::bind
