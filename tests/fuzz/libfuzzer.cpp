// One program for all targets of libFuzzer; the environment variable SIGNORINI_TARGET names one.

#include "targets.hpp"

#include <cstring>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

const signorini::fuzz::Target& target() {
  static const signorini::fuzz::Target& chosen = []() -> const auto& {
    const char* name = std::getenv("SIGNORINI_TARGET");
    for (const auto& one : signorini::fuzz::targets())
      if (name && std::strcmp(name, one.name) == 0) return one;
    std::cerr << "SIGNORINI_TARGET must be one of:";
    for (const auto& one : signorini::fuzz::targets()) std::cerr << " " << one.name;
    std::cerr << "\n";
    std::exit(2);
  }
  ();
  return chosen;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  target().run({reinterpret_cast<const char*>(data), size});
  return 0;
}

/// Half of the inputs are changed by libFuzzer, which is guided by comparisons in the program, half by numbers.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  if (seed % 2 == 0) return LLVMFuzzerMutate(data, size, most);
  const std::string changed = signorini::fuzz::mutated({reinterpret_cast<const char*>(data), size}, seed);
  const std::size_t length = std::min(changed.size(), most);
  std::memcpy(data, changed.data(), length);
  return length;
}
