#include "view/ogg.hpp"

#include <gtest/gtest.h>

#include <string>

namespace signorini::view {
namespace ogg_tests {

/// A page with `size` bytes in one or two segments.
std::string page(unsigned char number, bool last, unsigned size) {
  std::string segments = size < 255 ? std::string(1, static_cast<char>(size))
                                    : std::string{static_cast<char>(255), static_cast<char>(size - 255)};
  std::string header = "OggS" + std::string(1, '\0') + static_cast<char>(last ? 4 : 0) + std::string(12, '\0');
  header += static_cast<char>(number) + std::string(7, '\0') + static_cast<char>(segments.size());
  return header + segments + std::string(size, 'x');
}

TEST(Ogg, IsWholeWithAllItsPages) {
  const std::string film = page(0, false, 40) + page(1, false, 300) + page(2, true, 7);
  EXPECT_TRUE(is_whole_ogg(film));
  for (std::size_t size = 0; size < film.size(); ++size) EXPECT_FALSE(is_whole_ogg(film.substr(0, size))) << size;
  EXPECT_FALSE(is_whole_ogg(film + "x"));
  EXPECT_FALSE(is_whole_ogg(page(0, false, 40) + page(2, true, 7))) << "a page is missing";
  EXPECT_FALSE(is_whole_ogg(page(0, false, 40) + page(1, false, 7))) << "the last page is missing";
}

} // namespace ogg_tests
} // namespace signorini::view
