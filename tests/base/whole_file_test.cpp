#include "base/whole_file.hpp"

#include "scratch.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
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

/// Files of processes that have ended are removed; those of running processes and files of other names stay.
TEST(WholeFile, RemovesFilesOfKilledProcesses) {
  const test::ScratchFolder folder;
  const pid_t gone = ::fork();
  if (gone == 0) ::_exit(0);
  ASSERT_EQ(::waitpid(gone, nullptr, 0), gone);
  const auto temporary = [&](const std::string& name, int process) {
    const std::string file = folder.file("." + name + "." + std::to_string(process) + ".part");
    std::ofstream(file) << "half of i";
    return file;
  };
  const std::string left = temporary("a.sgn", gone), other = temporary("b.sgn", gone),
                    writing = temporary("a.sgn", ::getppid());
  write_atomically(folder.file("a.sgn"), "x");
  EXPECT_TRUE(std::filesystem::exists(left));
  std::vector<std::string> files = files_with_leftovers(folder.file(""));
  std::sort(files.begin(), files.end());
  EXPECT_EQ(files, (std::vector<std::string>{"a.sgn", "b.sgn"}));
  remove_leftovers(folder.file("a.sgn"));
  EXPECT_FALSE(std::filesystem::exists(left));
  EXPECT_TRUE(std::filesystem::exists(other));
  EXPECT_TRUE(std::filesystem::exists(writing));
  for (const char* name :
       {".part", ".a.part", "a.1.part", ".a.x.part", ".a.-7.part", ".a.7x.part", "..part", ".1.part"})
    std::ofstream(folder.file(name)) << "not a temporary file";
  EXPECT_EQ(files_with_leftovers(folder.file("")), std::vector<std::string>{"b.sgn"});
  EXPECT_TRUE(files_with_leftovers(folder.file("missing")).empty());
}

} // namespace whole_file_test
} // namespace signorini
