#pragma once
// Tasks on several threads. What a task writes must not depend on the thread that runs it, nor on the order of tasks.

#include <functional>

namespace signorini {

/// How many threads parallel() may use, the caller's included; 1 at the start. Call it while no task runs.
void set_worker_threads(int threads);
int worker_threads();

/// For a process that has just been forked, where the threads of its parent do not exist: works alone from here on.
void abandon_worker_threads();

/// Runs task(0) … task(count − 1), each once, and returns when all are done. The first exception, by the task's number,
/// is thrown again. Must not be called from within a task.
void parallel(int count, const std::function<void(int)>& task);

} // namespace signorini
