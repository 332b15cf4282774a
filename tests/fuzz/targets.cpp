#include "targets.hpp"

namespace signorini::fuzz {

namespace {

constexpr Target all[] = {
#ifdef SIGNORINI_FUZZ_DATA
    {"data", data}, // with Lua, which the preset `sanitize` does not build
#else
    {"geometry", geometry},
    {"checkpoint", checkpoint},
    {"archive", archive},
    {"words", words},
#endif
};

} // namespace

std::span<const Target> targets() {
  return all;
}

} // namespace signorini::fuzz
