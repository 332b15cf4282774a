#pragma once
// Folder for the parts of a file that is being made.

#include <string>

namespace signorini::view {

/// A folder next to a file for what the file is made of, removed with its contents at the end: .name.parts, so that the
/// next process removes what a killed one has left; while another process makes the same file, or where folders cannot
/// be locked, .name.XXXXXX. Throws Error if the file's folder does not exist or cannot be written to.
class PartsFolder {
public:
  explicit PartsFolder(const std::string& file);
  ~PartsFolder();
  PartsFolder(const PartsFolder&) = delete;
  PartsFolder& operator=(const PartsFolder&) = delete;

  std::string path(const std::string& name) const { return folder_ + "/" + name; }

private:
  bool take();

  std::string folder_;
  int handle_ = -1; ///< holds the lock
};

} // namespace signorini::view
