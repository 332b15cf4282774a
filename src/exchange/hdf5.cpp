#include "exchange/hdf5.hpp"

#include "base/error.hpp"
#include "os/module.hpp"

namespace signorini::exchange {

namespace {

constexpr const char* hdf5_file = "signorini_hdf5.so";

} // namespace

const Hdf5Module& hdf5() {
  static const Hdf5Module& loaded = []() -> const Hdf5Module& {
    const std::filesystem::path file = find_module(hdf5_file);
    const auto [first, second] = module_folders();
    require(!file.empty(), "exchange.hdf5.missing",
            {{"module", hdf5_file}, {"first", first.string()}, {"second", second.string()}});
    return *static_cast<const Hdf5Module*>(load_module(file, "signorini_hdf5"));
  }();
  return loaded;
}

bool has_hdf5() {
  return !find_module(hdf5_file).empty();
}

} // namespace signorini::exchange
