#include "os/parallel.hpp"

#include "base/error.hpp"

#include <atomic>
#include <cstdint>
#include <exception>
#include <memory>
#include <system_error>
#include <thread>
#include <vector>

namespace signorini {

namespace {

thread_local bool in_task = false; ///< the team has one call at a time

/// Threads that sleep between calls.
class Team {
public:
  explicit Team(int helpers) {
    try {
      for (int i = 0; i < helpers; ++i) threads_.emplace_back([this] { serve(); });
    } catch (const std::system_error& e) {
      end();
      fail("os.threads.start", {{"started", size()}, {"wanted", helpers + 1}, {"reason", e.what()}});
    }
  }
  ~Team() { end(); }
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  int size() const { return std::ssize(threads_) + 1; }

  /// A thread that wakes late finds the call finished and sleeps again: nothing waits for it.
  void run(int count, const std::function<void(int)>& task) {
    task_ = &task;
    errors_.assign(static_cast<std::size_t>(count), nullptr);
    done_ = 0;
    begin(count);
    work(call_);
    for (std::uint32_t done = done_; done < count_; done = done_) done_.wait(done);
    for (const auto& error : errors_)
      if (error) std::rethrow_exception(error);
  }

private:
  static constexpr int bits = 32;
  static constexpr std::uint64_t closed = 0xffffffff;

  void end() {
    over_ = true;
    begin(0);
    for (auto& thread : threads_) thread.join();
  }

  void begin(int count) {
    const std::uint32_t call = call_ + 1;
    const std::uint64_t first = static_cast<std::uint64_t>(call) << bits;
    next_ = first | closed; // closed: threads late for the last call take none of its tasks while count_ changes
    count_ = static_cast<std::uint32_t>(count);
    next_ = first;
    call_ = call;
    call_.notify_all();
  }

  /// Takes tasks of one call until none is left or the next call has begun. A call does not end before the tasks taken
  /// from it have, so task_ and errors_ are valid during a task.
  void work(std::uint32_t call) {
    for (std::uint64_t place = next_; place >> bits == call; place = next_) {
      const auto i = static_cast<std::uint32_t>(place & closed);
      if (i >= count_) return;
      if (!next_.compare_exchange_weak(place, place + 1)) continue;
      in_task = true;
      try {
        (*task_)(static_cast<int>(i));
      } catch (...) {
        errors_[i] = std::current_exception();
      }
      in_task = false;
      if (done_.fetch_add(1) + 1 == count_) done_.notify_one();
    }
  }

  void serve() {
    for (std::uint32_t seen = 0;;) {
      call_.wait(seen);
      seen = call_;
      if (over_) return;
      work(seen);
    }
  }

  std::vector<std::thread> threads_;
  std::atomic<std::uint32_t> call_ = 0; ///< number of the current call
  std::atomic<std::uint64_t> next_ = 0; ///< the call's number in the high bits, the next task's in the low ones
  std::atomic<std::uint32_t> count_ = 0, done_ = 0;
  std::atomic<bool> over_ = false;
  const std::function<void(int)>* task_ = nullptr;
  std::vector<std::exception_ptr> errors_;
};

std::unique_ptr<Team> team;

} // namespace

void set_worker_threads(int threads) {
  if (threads == worker_threads()) return;
  team.reset();
  if (threads > 1) team = std::make_unique<Team>(threads - 1);
}

int worker_threads() {
  return team ? team->size() : 1;
}

void check_threads() {
  constexpr int count = 4; // at once: Pango starts up to three for its first text
  std::atomic<bool> all = false;
  std::vector<std::thread> threads;
  std::string reason;
  try {
    for (int i = 0; i < count; ++i) threads.emplace_back([&] { all.wait(false); });
  } catch (const std::system_error& e) {
    reason = e.what();
  }
  all = true;
  all.notify_all();
  for (std::thread& thread : threads) thread.join();
  require(reason.empty(), "os.threads.none", {{"reason", reason}});
}

void abandon_worker_threads() {
  static_cast<void>(team.release()); // the threads do not exist in this process and cannot be joined
}

void parallel(int count, const std::function<void(int)>& task) {
  if (team && count > 1 && !in_task) return team->run(count, task);
  for (int i = 0; i < count; ++i) task(i);
}

} // namespace signorini
