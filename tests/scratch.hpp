#pragma once
// A temporary folder for a test's files, and messages of errors.

#include "base/error.hpp"

#include <filesystem>
#include <stdlib.h>
#include <string>

namespace signorini::test {

/// A temporary folder, removed with its contents.
class ScratchFolder {
public:
  ScratchFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "signorini-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }
  /// The number of its files.
  long count() const { return std::distance(std::filesystem::directory_iterator(path_), {}); }

private:
  std::filesystem::path path_;
};

/// The message of the Error that the action throws; "no error" when it throws none.
template <class Action> std::string message_of(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

} // namespace signorini::test
