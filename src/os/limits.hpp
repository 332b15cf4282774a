#pragma once
// The memory and the time that --memory and --time allow.

#include <string>

namespace signorini {

/// Limits the process, and each one that is forked from it, to this much memory: the heap, other private memory and
/// stacks of threads, as RLIMIT_DATA counts them; files and libraries that are mapped for reading are not counted.
/// Allocations beyond it fail: std::bad_alloc, or NULL in C. `written` is the limit in the user's notation, for
/// messages. Throws Error if the process has more already or the system refuses.
void limit_memory(double bytes, const std::string& written);

/// The limit as the user wrote it, "4G"; empty without one.
const std::string& memory_limit();

/// During its lifetime the limit is larger by a reserve of a sixteenth, at least 64 MB: for messages about missing
/// memory, and for libraries that end the process when an allocation fails. Costs nothing without a limit.
class MemoryReserve {
public:
  MemoryReserve();
  ~MemoryReserve();
  MemoryReserve(const MemoryReserve&) = delete;
  MemoryReserve& operator=(const MemoryReserve&) = delete;
};

/// Throws std::bad_alloc unless this much more memory is allowed. For libraries that end the process when an allocation
/// fails: their need is estimated first, and a MemoryReserve covers the rest. Costs nothing without a limit.
void demand_memory(double bytes);

/// From start_time_limit() on, the process has so many seconds. Then the Ctrl-C flag is set (interrupt.hpp) and `over`
/// is called in a signal handler. If the time is not stopped a tenth of the limit later, at least 2 seconds, the
/// process ends with status 124. Children that are forked have no limit. Uses SIGALRM.
void limit_time(double seconds, const std::string& written, void (*over)());
/// Both do nothing without a limit.
void start_time_limit();
void stop_time_limit();

/// The limit as the user wrote it, "10m".
const std::string& time_limit();
/// True if the flag was set because the time is over that was started last.
bool out_of_time();

} // namespace signorini
