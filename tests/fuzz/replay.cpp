// Runs each target on its kept inputs, and on changed copies of them: replay <folder of inputs> <copies of each> [first
// seed].

#include "targets.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <vector>

namespace {

std::string contents(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace

int main(int count, char** words) {
  if (count < 3) {
    std::cerr << "usage: " << words[0] << " <folder> <copies> [first seed]\n";
    return 2;
  }
  const std::uint64_t copies = std::stoull(words[2]), first = count > 3 ? std::stoull(words[3]) : 1;
  for (const auto& target : signorini::fuzz::targets()) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(words[1]) / target.name))
      files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const auto& file : files) {
      const std::string input = contents(file);
      std::cout << target.name << " " << file.filename().string() << std::endl;
      target.run(input);
      for (std::uint64_t seed = first; seed < first + copies; ++seed) target.run(signorini::fuzz::mutated(input, seed));
    }
    std::cout << target.name << ": " << files.size() * (1 + copies) << " inputs" << std::endl;
  }
}
