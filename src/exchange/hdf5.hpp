#pragma once
// Files of HDF5, by a module that is loaded when the first one is made.

#include "exchange/hdf5_module.hpp"

namespace signorini::exchange {

/// The module. Throws Error if it is not installed.
const Hdf5Module& hdf5();
bool has_hdf5();

} // namespace signorini::exchange
