#pragma once
// Jobs in separate processes, in parallel: a crash or memory error of one does not affect the others.

#include "base/message.hpp"

#include <functional>
#include <limits>
#include <string>

namespace signorini {

/// How a job ended: with its output, or with a reason.
struct JobEnd {
  int job = 0;        ///< index, from 0
  std::string output; ///< what it returned; empty if it failed
  Message failure;    ///< why it failed: "os.jobs.time" and others of jobs.cpp; empty on success
};

struct JobLimits {
  int at_once = 1;                                          ///< number of parallel processes
  double seconds = std::numeric_limits<double>::infinity(); ///< wall time after which a job is killed
  double grace = 0; ///< seconds after a notice (notice.hpp) in which jobs may reach a checkpoint, then they are killed
};

/// Runs job(0) … job(count − 1), each in a child process that returns a text, and calls done() in this process for each
/// as it ends. Returns false if Ctrl-C ended it: running jobs are killed, results of finished ones were passed to
/// done(). An exception from done() is passed on and kills the running jobs. No child survives the call or this
/// process. After a notice no job is started, the running ones get it too, and it returns false unless all had ended;
/// those that end at a checkpoint or are killed fail by "os.jobs.stopped". look(running) is called at least every
/// tenth of a second, for displays of progress. A child has one thread, whatever set_worker_threads() was given, and
/// ignores Ctrl-C. In a sandbox (sandbox.hpp) at most its number of processes run at once, and a child cannot run jobs.
/// Linux only.
bool run_jobs(int count, const JobLimits& limits, const std::function<std::string(int)>& job,
              const std::function<void(const JobEnd&)>& done, const std::function<void(int)>& look = {});

} // namespace signorini
