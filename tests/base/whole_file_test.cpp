#include "base/whole_file.hpp"

#include "scratch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace signorini {
namespace whole_file_test {

using test::message_of;

TEST(WholeFile, ReplacesAFileAndLeavesNoOther) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("a.txt");
  write_atomically(file, "first, longer");
  write_atomically(file, "second");
  EXPECT_EQ(read_file(file), "second");
  write_atomically(file, std::string("third\0", 6), true);
  EXPECT_EQ(read_file(file), std::string("third\0", 6));
  EXPECT_EQ(folder.count(), 1);
}

TEST(WholeFile, ReplacesTheTargetOfALinkAndKeepsTheLink) {
  const test::ScratchFolder folder;
  std::filesystem::create_directory(folder.file("data"));
  write_atomically(folder.file("data/a.txt"), "old");
  std::filesystem::create_symlink("data/a.txt", folder.file("a.txt"));
  std::filesystem::create_symlink("data/b.txt", folder.file("b.txt"));
  for (const char* name : {"a.txt", "b.txt"}) { // b.txt: a link whose target does not exist yet
    write_atomically(folder.file(name), "new");
    EXPECT_TRUE(std::filesystem::is_symlink(folder.file(name)));
    EXPECT_EQ(read_file(folder.file("data") + "/" + name), "new");
  }
}

/// A rename would replace the pipe, or /dev/null, by a file.
TEST(WholeFile, WritesIntoAPipe) {
  const test::ScratchFolder folder;
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  write_atomically(pipe, "through");
  char bytes[16] = {};
  EXPECT_EQ(::read(reader, bytes, sizeof bytes), 7);
  EXPECT_STREQ(bytes, "through");
  close(reader);
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
  EXPECT_EQ(folder.count(), 1);
}

TEST(WholeFile, ErrorsNameFileAndRemedyIfItCannotWrite) {
  const test::ScratchFolder folder;
  const std::string nowhere = folder.file("missing") + "/a.txt";
  const std::string message = message_of([&] { write_atomically(nowhere, "x"); });
  EXPECT_NE(message.find("base.file.no_folder: file = " + nowhere + ", folder = " + folder.file("missing")),
            std::string::npos)
      << message;

  write_atomically(folder.file("file"), "x");
  const std::string below = message_of([&] { write_atomically(folder.file("file") + "/a/b.txt", "x"); });
  EXPECT_NE(below.find("above = " + folder.file("file")), std::string::npos) << below;
  std::filesystem::remove(folder.file("file"));
  const std::string home = message_of([&] { write_atomically("~/a.txt", "x"); });
  EXPECT_NE(home.find("base.file.tilde"), std::string::npos) << home;

  std::filesystem::create_directory(folder.file("folder"));
  EXPECT_NE(message_of([&] { write_atomically(folder.file("folder"), "x", true); }).find("base.file.write_folder"),
            std::string::npos);
  EXPECT_NE(message_of([&] {
              write_atomically("/proc/signorini.txt", "x");
            }).find("base.file.write: file = /proc/signorini.txt"),
            std::string::npos);
  EXPECT_EQ(folder.count(), 1);
}

TEST(WholeFile, ErrorsNameAFileThatItCannotRead) {
  const test::ScratchFolder folder;
  const std::string message = message_of([&] { read_file(folder.file("a")); });
  EXPECT_NE(message.find("base.file.read: file = " + folder.file("a") + ", reason = No such file"), std::string::npos)
      << message;
  std::filesystem::create_directory(folder.file("folder"));
  EXPECT_NE(message_of([&] { read_file(folder.file("folder")); }).find("base.file.read_folder"), std::string::npos);
}

/// What a killed process has left is used again; while another process holds it, and where it is a link, a file of
/// another name is.
TEST(WholeFile, WritesOverWhatAKilledProcessHasLeft) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("a.sgn"), left = folder.file(".a.sgn.part");
  const auto names = [&] {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder.file("")))
      found.push_back(entry.path().filename().string());
    std::sort(found.begin(), found.end());
    return found;
  };
  std::ofstream(left) << "half of it, and longer";
  write_atomically(file, "x");
  EXPECT_EQ(read_file(file), "x");
  EXPECT_EQ(names(), std::vector<std::string>{"a.sgn"});

  const int held = ::open(left.c_str(), O_WRONLY | O_CREAT, 0666);
  struct flock whole {};
  whole.l_type = F_WRLCK;
  ASSERT_EQ(::fcntl(held, F_OFD_SETLK, &whole), 0);
  write_atomically(file, "y");
  EXPECT_EQ(read_file(file), "y");
  EXPECT_EQ(names(), (std::vector<std::string>{".a.sgn.part", "a.sgn"}));
  ::close(held);

  std::ofstream(folder.file("other")) << "kept";
  for (const bool symbolic : {true, false}) {
    std::filesystem::remove(left);
    if (symbolic)
      std::filesystem::create_symlink("other", left);
    else
      std::filesystem::create_hard_link(folder.file("other"), left);
    write_atomically(file, "z");
    EXPECT_EQ(read_file(file), "z");
    EXPECT_EQ(read_file(folder.file("other")), "kept");
  }
}

/// Files of processes that write the same one at the same time are whole.
TEST(WholeFile, IsWholeWhileOthersWriteIt) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("a");
  constexpr int writers = 4, times = 50;
  const auto content = [](int writer) {
    return std::string(static_cast<std::size_t>(20'000 * (writer + 1)), static_cast<char>('a' + writer));
  };
  write_atomically(file, content(0));
  std::vector<pid_t> processes;
  for (int writer = 0; writer < writers; ++writer) {
    processes.push_back(::fork());
    if (processes.back() != 0) continue;
    for (int k = 0; k < times; ++k) {
      write_atomically(file, content(writer));
      const std::string bytes = read_file(file);
      if (bytes.empty() || bytes != content(bytes[0] - 'a')) ::_exit(1);
    }
    ::_exit(0);
  }
  for (const pid_t process : processes) {
    int status = -1;
    ASSERT_EQ(::waitpid(process, &status, 0), process);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.file("")), {}), 1);
}

} // namespace whole_file_test
} // namespace signorini
