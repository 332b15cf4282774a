#pragma once
// Threads of the kernel. Signals belong to the main thread, which runs the cells.

#include <csignal>
#include <thread>
#include <utility>

namespace signorini::repl::kernel {

/// Starts a thread that receives no signals; its end is requested and awaited by the destructor.
template <class Function> std::jthread thread_without_signals(Function function) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  std::jthread thread(std::move(function));
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  return thread;
}

} // namespace signorini::repl::kernel
