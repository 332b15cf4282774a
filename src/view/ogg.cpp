#include "view/ogg.hpp"

#include <cstddef>

namespace signorini::view {

bool is_whole_ogg(std::string_view bytes) {
  // Page header: "OggS", version, type, position (8 bytes), stream (4), sequence number (4), checksum (4), number of
  // segments, and a byte with the size of each.
  constexpr std::size_t header = 27, type = 5, sequence = 18, segments = 26;
  constexpr unsigned last_page = 4;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  bool ended = false;
  for (std::size_t begin = 0, number = 0; begin < bytes.size(); ++number) {
    if (ended || bytes.size() - begin < header || bytes.substr(begin, 4) != "OggS") return false;
    std::size_t found = 0;
    for (std::size_t i = 4; i-- > 0;) found = 256 * found + byte(begin + sequence + i);
    std::size_t size = header + byte(begin + segments);
    if (found != number || bytes.size() - begin < size) return false;
    for (std::size_t i = header, end = size; i < end; ++i) size += byte(begin + i);
    if (bytes.size() - begin < size) return false;
    ended = (byte(begin + type) & last_page) != 0;
    begin += size;
  }
  return ended;
}

} // namespace signorini::view
