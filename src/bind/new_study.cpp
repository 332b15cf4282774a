#include "bind/new_study.hpp"

#include "base/whole_file.hpp"
#include "bind/library.hpp"
#include "bind/message.hpp"

namespace signorini::bind {

void write_new_study(const std::string& file) {
  require(file.ends_with(".lua"), "--new takes the name of a Lua file, got '", file, "': write ", file, ".lua");
  require(!std::filesystem::exists(file), "--new: there is a file '", file,
          "' already, which stays as it is: choose another name");
  write_whole(file, read_whole((find_share() / "starter.lua").string()));
}

} // namespace signorini::bind
