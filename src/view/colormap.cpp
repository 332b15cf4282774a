#include "view/colorbar.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::view {
namespace {

struct Map {
  const char* name;
  bool diverging;
  std::vector<std::uint32_t> anchors; // 0xRRGGBB, evenly spaced
};

// Colors of the published maps, evenly spaced: viridis, magma, inferno, plasma (S. van der Walt, N. Smith, 2015, CC0),
// cividis (Nuñez, Anderton, Renslow, PLoS ONE 13, 2018), coolwarm (K. Moreland, "Diverging color maps for scientific
// visualization", 2009).
const std::vector<Map>& maps() {
  static const std::vector<Map> all = {
      {"viridis",
       false,
       {0x440154, 0x482475, 0x414487, 0x355F8D, 0x2A788E, 0x21918C, 0x22A884, 0x44BF70, 0x7AD151, 0xBDDF26, 0xFDE725}},
      {"magma",
       false,
       {0x000004, 0x140E36, 0x3B0F70, 0x641A80, 0x8C2981, 0xB73779, 0xDE4968, 0xF7705C, 0xFE9F6D, 0xFECF92, 0xFCFDBF}},
      {"inferno",
       false,
       {0x000004, 0x160B39, 0x420A68, 0x6A176E, 0x932667, 0xBC3754, 0xDD513A, 0xF37819, 0xFCA50A, 0xF6D746, 0xFCFFA4}},
      {"plasma",
       false,
       {0x0D0887, 0x41049D, 0x6A00A8, 0x8F0DA4, 0xB12A90, 0xCC4778, 0xE16462, 0xF2844B, 0xFCA636, 0xFCCE25, 0xF0F921}},
      {"cividis",
       false,
       {0x00224E, 0x123570, 0x3B496C, 0x575D6D, 0x707173, 0x8A8678, 0xA59C74, 0xC3B369, 0xE1CC55, 0xFEE838}},
      {"gray", false, {0x202020, 0xF0F0F0}},
      {"coolwarm",
       true,
       {0x3B4CC0, 0x4D68D7, 0x6282EA, 0x779AF7, 0x8DB0FE, 0xA3C2FF, 0xB8D0F9, 0xCCD9EE, 0xDDDDDD, 0xECD3C5, 0xF5C4AD,
        0xF7B194, 0xF49A7B, 0xEC7F63, 0xDE604D, 0xCB3E38, 0xB40426}},
  };
  return all;
}

const Map& find(const std::string& name) {
  const auto map = std::find_if(maps().begin(), maps().end(), [&](const Map& m) { return m.name == name; });
  if (map != maps().end()) return *map;
  fail("view.colormap.unknown", {{"colormap", name}, {"known", colormaps()}});
}

/// Catmull–Rom interpolation of p₋₁, p₀, p₁, p₂: smooth, because kinks of linear interpolation are visible as bands.
double cubic(double before, double a, double b, double after, double t) {
  const double da = 0.5 * (b - before), db = 0.5 * (after - a);
  return a + t * (da + t * (3 * (b - a) - 2 * da - db + t * (2 * (a - b) + da + db)));
}

} // namespace

std::vector<Rgb> colormap(const std::string& name) {
  const auto& anchors = find(name).anchors;
  const int last = std::ssize(anchors) - 1;
  const auto channel = [&](int k, int shift) {
    // Linear extrapolation beyond the ends.
    const auto value = [&](int i) { return static_cast<double>((anchors[i] >> shift) & 0xFF); };
    return k < 0 ? 2 * value(0) - value(1) : k > last ? 2 * value(last) - value(last - 1) : value(k);
  };
  std::vector<Rgb> colors(256);
  for (int i = 0; i < 256; ++i) {
    const double position = last * i / 255.0;
    const int k = std::min(static_cast<int>(position), last - 1);
    for (int c = 0; c < 3; ++c) {
      const int s = 16 - 8 * c;
      const double value = cubic(channel(k - 1, s), channel(k, s), channel(k + 1, s), channel(k + 2, s), position - k);
      colors[i][c] = static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
    }
  }
  return colors;
}

bool is_diverging(const std::string& name) {
  return find(name).diverging;
}

std::vector<std::string> colormaps() {
  std::vector<std::string> names;
  for (const Map& map : maps()) names.push_back(map.name);
  return names;
}

} // namespace signorini::view
