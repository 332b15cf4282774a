#include "view/output.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace signorini::view {

std::string file_ending(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending;
}

} // namespace signorini::view
