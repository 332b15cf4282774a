#pragma once
// The kernel's entry in Jupyter's list.

#include <filesystem>
#include <string>
#include <vector>

namespace signorini::repl {

/// Writes kernel.json and the logos to kernels/signorini in the user's folder of Jupyter ($JUPYTER_DATA_DIR,
/// $XDG_DATA_HOME/jupyter or ~/.local/share/jupyter), which it returns. `options`: of this program, for the kernel.
/// Throws std::exception if the folder cannot be written.
std::filesystem::path install_kernel(const std::vector<std::string>& options);

} // namespace signorini::repl
