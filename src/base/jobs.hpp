#pragma once
// Jobs in processes of their own, side by side: what one of them does to memory, or its crash, touches no other.

#include "base/message.hpp"

#include <functional>
#include <limits>
#include <string>

namespace signorini {

/// How a job ended: with what it returned, or with a reason.
struct JobEnd {
  int job = 0;        ///< its number, from 0
  std::string output; ///< what it returned; empty when it failed
  Message failure;    ///< why it failed: "base.jobs.time" and others of jobs.cpp; empty when it returned
};

struct JobLimits {
  int at_once = 1;                                          ///< processes side by side
  double seconds = std::numeric_limits<double>::infinity(); ///< wall time after which a job is killed
};

/// Runs job(0) … job(count − 1), each in a child process that ends with what it returned, and calls done() here for
/// each as it ends. Returns false when Ctrl-C ended it: jobs under way are killed, those that had ended were handed
/// over. An exception from done() passes, and kills the jobs under way. No child outlives the call, nor this process.
/// look(running) is called every tenth of a second or more often, for whoever shows how things stand.
/// A child has one thread, whatever set_worker_threads() said, and does not see Ctrl-C. Linux only.
bool run_jobs(int count, const JobLimits& limits, const std::function<std::string(int)>& job,
              const std::function<void(const JobEnd&)>& done, const std::function<void(int)>& look = {});

} // namespace signorini
