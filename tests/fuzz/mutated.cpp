#include "targets.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <random>

#include <sys/mman.h>
#include <unistd.h>

namespace signorini::fuzz {

namespace {

constexpr std::uint32_t integers[] = {0, 1, 2, 3, 5, 100, 0x7fffffff, 0x80000000, 0xffffffff, 0xfffffffe, 1u << 20};
constexpr double numbers[] = {0.0,
                              -0.0,
                              1,
                              -1,
                              0.5,
                              1e-300,
                              1e308,
                              -1e308,
                              std::numeric_limits<double>::denorm_min(),
                              std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()};
constexpr const char* texts[] = {
    "0",        "-1",    "1",     "2",      "3",          "-0",          "nan",
    "inf",      "1e999", "1e308", "1e-320", "1e9",        "+1",          "0x1",
    "10000000", "00",    "1.5",   ".",      "#",          "<",           "\n",
    "\"",       "{",     "[",     "]",      "2147483647", "-2147483649", "99999999999999999999"};

template <class T> const T& one_of(std::span<const T> values, std::mt19937_64& random) {
  return values[random() % values.size()];
}

template <class T> void overwrite(std::string& bytes, const T& value, std::mt19937_64& random) {
  if (bytes.size() < sizeof value) return;
  std::memcpy(bytes.data() + random() % (bytes.size() - sizeof value + 1), &value, sizeof value);
}

bool is_digit(char c) {
  return (c >= '0' && c <= '9') || c == '.' || c == '-';
}

/// Replaces a number, or inserts a text.
void replace_word(std::string& bytes, std::mt19937_64& random) {
  const std::size_t from = random() % (bytes.size() + 1);
  const auto begin = std::find_if(bytes.begin() + static_cast<std::ptrdiff_t>(from), bytes.end(), is_digit);
  const auto end = std::find_if_not(begin, bytes.end(), is_digit);
  bytes.replace(begin, end, one_of<const char*>(texts, random));
}

void move_part(std::string& bytes, std::mt19937_64& random) {
  const std::size_t length = 1 + random() % std::min<std::size_t>(bytes.size(), 64);
  const std::string part = bytes.substr(random() % bytes.size(), length);
  const std::size_t to = random() % bytes.size();
  switch (random() % 4) {
  case 0:
    bytes.insert(to, part);
    return;
  case 1:
    bytes.erase(to, length);
    return;
  default:
    bytes.replace(to, std::min(part.size(), bytes.size() - to), part, 0, std::min(part.size(), bytes.size() - to));
  }
}

void change(std::string& bytes, std::mt19937_64& random) {
  if (bytes.empty()) bytes = "0";
  switch (random() % 10) {
  case 0:
    bytes[random() % bytes.size()] = static_cast<char>(random());
    return;
  case 1:
    bytes[random() % bytes.size()] ^= static_cast<char>(1 << random() % 8);
    return;
  case 2:
  case 3:
    return overwrite(bytes, one_of<std::uint32_t>(integers, random), random);
  case 4:
    return overwrite(bytes, static_cast<std::uint64_t>(one_of<std::uint32_t>(integers, random)) << random() % 33,
                     random);
  case 5:
    return overwrite(bytes, one_of<double>(numbers, random), random);
  case 6:
  case 7:
    return replace_word(bytes, random);
  case 8:
    return move_part(bytes, random);
  default:
    if (random() % 8 == 0) bytes.resize(random() % bytes.size());
  }
}

} // namespace

std::string mutated(std::string_view input, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::string bytes(input);
  for (std::uint64_t count = 1 + random() % 3; count > 0; --count) change(bytes, random);
  return bytes;
}

std::string file_of(std::string_view bytes) {
  static const int handle = ::memfd_create("input", MFD_CLOEXEC);
  require_that(::ftruncate(handle, 0) == 0 &&
                   ::pwrite(handle, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()),
               "a file in memory can be written");
  return "/proc/self/fd/" + std::to_string(handle);
}

} // namespace signorini::fuzz
