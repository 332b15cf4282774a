#include "base/archive.hpp"
#include "base/lock.hpp"
#include "base/whole_file.hpp"
#include "bind/functions.hpp"
#include "bind/open.hpp"

#include <algorithm>
#include <filesystem>

namespace signorini::bind {

template <> struct Type<Lock> { static constexpr auto name = "lock"; };

namespace {

const Argument file_argument{"file", "a path"};

int write_file(lua_State* L) {
  std::size_t size;
  const char* bytes = luaL_checklstring(L, 2, &size);
  const bool durable = lua_toboolean(L, 3) != 0;
  write_whole(read_string(L, 1, file_argument), {bytes, size}, durable);
  return 0;
}

int read_file(lua_State* L) {
  push(L, read_whole(read_string(L, 1, file_argument)));
  return 1;
}

int list_folder(lua_State* L) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(read_string(L, 1, {"folder"})))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  push(L, names);
  return 1;
}

int remove_temporary_files(lua_State* L) {
  remove_leftovers(read_string(L, 1, file_argument));
  return 0;
}

int hash(lua_State* L) {
  std::size_t size;
  const char* bytes = luaL_checklstring(L, 1, &size);
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(checksum({bytes, size})));
  push(L, digits);
  return 1;
}

int lock(lua_State* L) {
  push_object(L, Lock(read_string(L, 1, file_argument)));
  return 1;
}

constexpr Function files_entries[] = {
    {"write_file", write_file,
     "core.write_file(file, bytes, durable = false)\n"
     "Writes a file, whole or not at all; durable: on the disk on return, so that it outlives the machine's power."},
    {"read_file", read_file, "core.read_file(file)\nAll bytes of a file."},
    {"list_folder", list_folder, "core.list_folder(folder)\nThe names of what a folder holds, sorted."},
    {"remove_leftovers", remove_temporary_files,
     "core.remove_leftovers(file)\nRemoves temporary files of this name that killed processes left."},
    {"hash", hash, "core.hash(bytes)\nSixteen hexadecimal digits that stand for a text."},
    {"lock", lock,
     "core.lock(file)\nHolds a file, made where there is none, until :release(). An error when somebody holds it."},
};

constexpr Function methods[] = {
    {"release", collect<Lock>, "lock:release()\nLets go of the file."},
};

} // namespace

void open_files(lua_State* L) {
  register_type<Lock>(L, methods);
  register_functions(L, "core", files_entries);
}

} // namespace signorini::bind
