#include "os/lock.hpp"

#include "scratch.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace signorini {
namespace lock_test {

using test::holds;
using test::message_of;

TEST(Lock, IsHeldByOneProcessAtATime) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("lock");
  {
    const Lock first(file);
    EXPECT_TRUE(holds(message_of([&] { Lock second(file); }),
                      {"os.lock.held: file = " + file + ", holder = process " + std::to_string(::getpid()) + " on "}));
  }
  EXPECT_EQ(message_of([&] { Lock third(file); }), "no error");
}

TEST(Lock, IsReleasedWhenItsProcessEnds) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("lock");
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t holder = ::fork();
  if (holder == 0) {
    const Lock held(file);
    if (::write(ready[1], "x", 1) == 1) ::pause();
    ::_exit(1);
  }
  char byte;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  EXPECT_TRUE(holds(message_of([&] { Lock mine(file); }), {"holder = process " + std::to_string(holder)}));
  ::kill(holder, SIGKILL);
  ASSERT_EQ(::waitpid(holder, nullptr, 0), holder);
  EXPECT_EQ(message_of([&] { Lock mine(file); }), "no error");
  ::close(ready[0]);
  ::close(ready[1]);
}

TEST(Lock, ReportsWhereItCannotBeCreated) {
  EXPECT_TRUE(
      holds(message_of([] { Lock lock("/proc/signorini/lock"); }), {"os.lock.write: file = /proc/signorini/lock"}));
}

/// The name of the holder would be written into what a link refers to.
TEST(Lock, KeepsWhatIsNotALock) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("lock"), other = folder.file("other");
  std::ofstream(other) << "precious";
  const auto refused = [&] {
    EXPECT_TRUE(holds(message_of([&] { Lock lock(file); }), {"os.lock.foreign: file = " + file}));
    std::filesystem::remove(file);
  };
  std::filesystem::create_symlink("other", file);
  refused();
  std::filesystem::create_hard_link(other, file);
  refused();
  ASSERT_EQ(::mkfifo(file.c_str(), 0600), 0);
  refused();
  std::filesystem::copy_file(other, file);
  refused();
  std::string kept;
  std::getline(std::ifstream(other), kept);
  EXPECT_EQ(kept, "precious");
}

} // namespace lock_test
} // namespace signorini
