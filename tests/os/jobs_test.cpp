#include "os/jobs.hpp"

#include "base/notice.hpp"
#include "os/interrupt.hpp"
#include "os/parallel.hpp"
#include "scratch.hpp"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace signorini {
namespace jobs_test {

using Ends = std::map<int, JobEnd>;

/// How all jobs ended, by job number; fails if one ends twice.
Ends ends_of(int count, const JobLimits& limits, const std::function<std::string(int)>& job) {
  Ends ends;
  EXPECT_TRUE(run_jobs(count, limits, job, [&](const JobEnd& end) { EXPECT_TRUE(ends.emplace(end.job, end).second); }));
  return ends;
}

void expect_no_children() {
  errno = 0;
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

void sleep_for(double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

TEST(Jobs, ReturnTheirOutputs) {
  for (int at_once : {1, 2, 5}) {
    const Ends ends =
        ends_of(7, {.at_once = at_once}, [](int i) { return std::string("square ") + std::to_string(i * i); });
    ASSERT_EQ(ends.size(), 7U);
    for (const auto& [i, end] : ends) {
      EXPECT_EQ(end.output, "square " + std::to_string(i * i));
      EXPECT_EQ(bare_text(end.failure), "");
    }
  }
  expect_no_children();
}

TEST(Jobs, RunInParallelProcessesAndEndInAnyOrder) {
  int here = 0;
  std::vector<int> order;
  const test::ScratchFolder folder;
  const auto ended = [&](int i) { return folder.file("ended_" + std::to_string(i)); };
  run_jobs(
      3, {.at_once = 3, .seconds = 60},
      [&](int i) {
        here = i;
        // each waits until the next one has ended, which requires that all run in parallel
        while (i < 2 && !std::filesystem::exists(ended(i + 1))) sleep_for(0.01);
        return std::to_string(getpid());
      },
      [&](const JobEnd& end) {
        EXPECT_NE(end.output, std::to_string(getpid()));
        order.push_back(end.job);
        std::ofstream(ended(end.job)) << "ended";
      });
  EXPECT_EQ(order, (std::vector<int>{2, 1, 0}));
  EXPECT_EQ(here, 0);
}

TEST(Jobs, RunNoMoreInParallelThanAllowed) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("log");
  for (int at_once : {1, 2}) {
    std::ofstream(file) << "";
    ends_of(6, {.at_once = at_once}, [&](int) {
      for (const char* line : {"begins\n", "ends\n"}) std::ofstream(file, std::ios::app) << line << std::flush;
      return "";
    });
    int running = 0, most = 0, lines = 0;
    std::ifstream log(file);
    for (std::string line; std::getline(log, line); ++lines) {
      running += line == "begins" ? 1 : -1;
      most = std::max(most, running);
    }
    EXPECT_EQ(lines, 12);
    EXPECT_LE(most, at_once);
  }
}

TEST(Jobs, MayReturnAnEmptyText) {
  const Ends ends = ends_of(1, {}, [](int) { return ""; });
  EXPECT_EQ(bare_text(ends.at(0).failure), "");
}

TEST(Jobs, MayReturnMoreThanAPipeHolds) {
  const Ends ends = ends_of(2, {.at_once = 2}, [](int i) { return std::string(3000000, static_cast<char>('a' + i)); });
  EXPECT_TRUE(ends.at(0).output == std::string(3000000, 'a'));
  EXPECT_TRUE(ends.at(1).output == std::string(3000000, 'b'));
}

TEST(Jobs, ReportWhyTheyFailed) {
  const Ends ends = ends_of(4, {.at_once = 2}, [](int i) -> std::string {
    switch (i) {
    case 0:
      std::raise(SIGKILL);
      break;
    case 1:
      throw std::runtime_error("no luck");
    case 2:
      _exit(3);
    default:
      break;
    }
    return "fine";
  });
  EXPECT_EQ(bare_text(ends.at(0).failure), "os.jobs.signal: signal = 9");
  EXPECT_EQ(bare_text(ends.at(1).failure), "os.jobs.threw: error = no luck");
  EXPECT_EQ(bare_text(ends.at(2).failure), "os.jobs.status: status = 3");
  EXPECT_EQ(bare_text(ends.at(3).failure), "");
  EXPECT_EQ(ends.at(3).output, "fine");
  EXPECT_EQ(ends.at(1).output, "");
  expect_no_children();
}

TEST(Jobs, AreKilledAtTheTimeLimit) {
  const Ends ends = ends_of(2, {.at_once = 2, .seconds = 0.01}, [](int) {
    for (;;) pause();
    return "";
  });
  EXPECT_EQ(bare_text(ends.at(0).failure), "os.jobs.time");
  EXPECT_EQ(bare_text(ends.at(1).failure), "os.jobs.time");
  expect_no_children();
}

TEST(Jobs, PrintBufferedOutputOnce) {
  const std::string file = testing::TempDir() + "jobs_output";
  const auto print = [&] {
    std::freopen(file.c_str(), "w", stdout);
    std::printf("before ");
    ends_of(1, {}, [](int) {
      std::printf("within ");
      return "";
    });
    std::printf("behind\n");
    std::fflush(stdout);
    _exit(0);
  };
  EXPECT_EXIT(print(), testing::ExitedWithCode(0), "");
  std::string line;
  std::ifstream in(file);
  std::getline(in, line);
  EXPECT_EQ(line, "before within behind");
}

TEST(Jobs, UseOneThreadIfTheParentHasSeveral) {
  set_worker_threads(3);
  std::vector<int> runs(100);
  const auto count_up = [&](int i) { ++runs[i]; };
  parallel(100, count_up);
  const Ends ends = ends_of(2, {.at_once = 2, .seconds = 20}, [&](int) {
    const int threads = worker_threads();
    parallel(100, count_up);
    set_worker_threads(1);
    return std::to_string(threads) + " " + std::to_string(runs[99]);
  });
  EXPECT_EQ(ends.at(0).output, "1 2");
  EXPECT_EQ(ends.at(1).output, "1 2");
  EXPECT_EQ(worker_threads(), 3);
  parallel(100, count_up);
  EXPECT_EQ(runs[99], 2);
  set_worker_threads(1);
}

TEST(Jobs, CtrlCKillsThemAndKeepsFinishedResults) {
  catch_interrupts();
  std::vector<int> ended;
  const bool whole = run_jobs(
      4, {.at_once = 2},
      [](int i) {
        std::raise(SIGINT); // a terminal's Ctrl-C reaches all processes; only the parent reacts
        if (i > 0) sleep_for(60);
        return "";
      },
      [&](const JobEnd& end) {
        ended.push_back(end.job);
        std::raise(SIGINT);
      });
  EXPECT_FALSE(whole);
  EXPECT_EQ(ended, std::vector<int>{0});
  expect_no_children();
  clear_interrupt();
}

TEST(Jobs, ErrorInTheCallbackIsPassedOnAndLeavesNoChild) {
  const auto run = [] {
    run_jobs(
        2, {.at_once = 2},
        [](int i) {
          if (i > 0) sleep_for(60);
          return "";
        },
        [](const JobEnd&) { throw std::runtime_error("tolerance"); });
  };
  EXPECT_THROW(run(), std::runtime_error);
  expect_no_children();
}

TEST(Jobs, EndWithTheirParent) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const pid_t parent = fork();
  if (parent == 0) {
    run_jobs(
        1, {},
        [&](int) {
          const pid_t own = getpid();
          EXPECT_EQ(::write(ends[1], &own, sizeof own), static_cast<ssize_t>(sizeof own));
          sleep_for(60);
          return "";
        },
        [](const JobEnd&) {});
    _exit(0);
  }
  close(ends[1]);
  pid_t job = 0;
  ASSERT_EQ(::read(ends[0], &job, sizeof job), static_cast<ssize_t>(sizeof job));
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  char nothing;
  EXPECT_EQ(::read(ends[0], &nothing, 1), 0); // the last process with the write end has ended
  close(ends[0]);
}

// The notice is a flag of the process that cannot be taken back, so it is given to a fork of the test.
TEST(Jobs, EndAtACheckpointOrAreKilledAfterANotice) {
  const pid_t parent = fork();
  if (parent == 0) {
    catch_notice();
    std::map<int, std::string> ends;
    const auto job = [](int i) -> std::string {
      if (i == 1) kill(getppid(), SIGUSR1);
      while (i != 0 || !notice_given()) sleep_for(0.01);
      _exit(to_be_continued); // as a run that looks at the notice when it saves a checkpoint; job 1 never does
    };
    const bool whole = run_jobs(3, {.at_once = 2, .grace = 1}, job,
                                [&](const JobEnd& end) { ends[end.job] = bare_text(end.failure); });
    const bool stopped = ends == std::map<int, std::string>{{0, "os.jobs.stopped"}, {1, "os.jobs.stopped"}};
    _exit(!whole && stopped ? 0 : 1); // job 2 never began
  }
  int status = 0;
  ASSERT_EQ(waitpid(parent, &status, 0), parent);
  EXPECT_EQ(status, 0);
}

TEST(Jobs, InvalidLimitsAreRejected) {
  const auto run = [](const JobLimits& limits) {
    run_jobs(
        1, limits, [](int) { return ""; }, [](const JobEnd&) {});
  };
  EXPECT_THROW(run({.at_once = 0}), std::runtime_error);
  EXPECT_THROW(run({.seconds = 0}), std::runtime_error);
}

} // namespace jobs_test
} // namespace signorini
