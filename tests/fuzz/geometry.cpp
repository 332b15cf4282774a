#include "exchange/text.hpp"
#include "targets.hpp"

namespace signorini::fuzz {

/// What was read is written in each format and read again.
void geometry(std::string_view input) {
  passes([&] {
    const exchange::Geometry read = exchange::read_geometry(file_of(input));
    for (const nurbs::Patch& patch : read.patches)
      require_that(patch.homogeneous().allFinite() && patch.weights().minCoeff() > 0, "patches read are valid");
    for (const auto write : {exchange::gismo, exchange::geopdes, exchange::mfem}) {
      std::string text;
      if (!passes([&] { text = write(read); })) continue; // a format may not have what another one has
      const auto again = exchange::read_geometry(file_of(text));
      require_that(again.patches.size() == read.patches.size(), "a written file has all patches");
    }
  });
}

} // namespace signorini::fuzz
