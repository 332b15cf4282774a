#pragma once
// What lib/signorini/modules/signorini_sandbox.so exports under the name signorini_sandbox: filters of system calls.

#include <string>

namespace signorini {

struct SeccompModule {
  std::string (*version)();
  /// Allows all threads only what a run needs; anything else fails with EPERM. `forks`: new processes, and signals to
  /// them, are allowed. Returns an error number, or 0.
  int (*filter)(bool forks);
  /// From now on no new processes, only threads. Returns an error number, or 0.
  int (*forbid_forks)();
};

} // namespace signorini
