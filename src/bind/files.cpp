#include "base/archive.hpp"
#include "base/lock.hpp"
#include "base/whole_file.hpp"
#include "bind/arguments.hpp"
#include "bind/functions.hpp"
#include "bind/open.hpp"

#include <algorithm>
#include <filesystem>

namespace signorini::bind {

template <> struct Type<Lock> { static constexpr auto name = "lock"; };

namespace {

/// core.write_file(file, bytes, durable = false): writes a file, whole or not at all; durable: on the disk on return,
/// so that it outlives the machine's power.
int write_file(lua_State* L) {
  std::size_t size;
  const char* bytes = luaL_checklstring(L, 2, &size);
  const bool durable = lua_toboolean(L, 3) != 0;
  write_whole(to<std::string>(L, 1), {bytes, size}, durable);
  return 0;
}

/// core.read_file(file): all bytes of a file.
int read_file(lua_State* L) {
  push(L, read_whole(to<std::string>(L, 1)));
  return 1;
}

/// core.list_folder(folder): the names of what a folder holds, sorted.
int list_folder(lua_State* L) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(to<std::string>(L, 1)))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  push(L, names);
  return 1;
}

/// core.remove_leftovers(file): removes temporary files of this name that killed processes left.
int remove_temporary_files(lua_State* L) {
  remove_leftovers(to<std::string>(L, 1));
  return 0;
}

/// core.hash(bytes): sixteen hexadecimal digits that stand for a text.
int hash(lua_State* L) {
  std::size_t size;
  const char* bytes = luaL_checklstring(L, 1, &size);
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(checksum({bytes, size})));
  push(L, digits);
  return 1;
}

/// core.lock(file): holds a file, made where there is none, until :release(). An error when somebody holds it.
int lock(lua_State* L) {
  push_object(L, Lock(to<std::string>(L, 1)));
  return 1;
}

constexpr Function files_entries[] = {
    {"write_file", write_file},
    {"read_file", read_file},
    {"list_folder", list_folder},
    {"remove_leftovers", remove_temporary_files},
    {"hash", hash},
    {"lock", lock},
};

constexpr Function lock_methods[] = {{"release", collect<Lock>}}; // lets go of the file

} // namespace

void open_files(lua_State* L) {
  register_type<Lock>(L, lock_methods);
  register_functions(L, "core", files_entries);
}

} // namespace signorini::bind
