#include "base/base64.hpp"

#include <array>
#include <cstdint>

namespace signorini {

std::string base64(std::string_view bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string result;
  result.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::array<std::uint32_t, 3> byte{};
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < count; ++k) byte[k] = static_cast<unsigned char>(bytes[i + k]);
    const std::uint32_t all = byte[0] << 16 | byte[1] << 8 | byte[2];
    for (std::size_t k = 0; k < 4; ++k) result += k <= count ? digits[all >> (18 - 6 * k) & 63] : '=';
  }
  return result;
}

} // namespace signorini
