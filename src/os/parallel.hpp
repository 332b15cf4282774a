#pragma once
// Tasks on several threads. A task's results must not depend on the thread that runs it or on the order of tasks.

#include <functional>

namespace signorini {

/// Number of threads that parallel() may use, the caller's included; initially 1. Call it while no task runs.
void set_worker_threads(int threads);
int worker_threads();

/// Throws Error unless the system starts a thread: libraries that need one would end the program.
void check_threads();

/// For a process that has just been forked, in which the parent's threads do not exist: uses one thread from now on.
void abandon_worker_threads();

/// Runs task(0) … task(count − 1), each once, and returns when all are done. Rethrows the exception with the lowest
/// task number. A call from a task runs its own tasks one after the other.
void parallel(int count, const std::function<void(int)>& task);

} // namespace signorini
