#include "os/whole_file.hpp"

#include "scratch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace signorini {
namespace whole_file_test {

using test::holds;
using test::message_of;

TEST(WholeFile, ReplacesAFileAndLeavesNoOther) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("a.txt");
  write_record(file, "first, longer");
  write_record(file, "second");
  EXPECT_EQ(read_file(file), "second");
  write_record(file, std::string("third\0", 6), true);
  EXPECT_EQ(read_file(file), std::string("third\0", 6));
  EXPECT_EQ(folder.count(), 1);
}

TEST(WholeFile, OutputsReplaceTheTargetOfALinkAndRecordsTheLink) {
  const test::ScratchFolder folder;
  std::filesystem::create_directory(folder.file("data"));
  write_record(folder.file("data/a.json"), "[1]");
  std::filesystem::create_symlink("data/a.json", folder.file("a.json"));
  std::filesystem::create_symlink("data/b.json", folder.file("b.json"));
  for (const char* name : {"a.json", "b.json"}) { // b.json: a link whose target does not exist yet
    const std::string target = folder.file("data") + "/" + name;
    write_output(folder.file(name), "[2]", FileKind::json);
    EXPECT_TRUE(std::filesystem::is_symlink(folder.file(name)));
    EXPECT_EQ(read_file(target), "[2]");
    write_record(folder.file(name), "[3]");
    EXPECT_FALSE(std::filesystem::is_symlink(folder.file(name)));
    EXPECT_EQ(read_file(folder.file(name)), "[3]");
    EXPECT_EQ(read_file(target), "[2]");
  }
}

/// A rename would replace the pipe, or /dev/null, by a file.
TEST(WholeFile, WritesIntoAPipe) {
  const test::ScratchFolder folder;
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  write_output(pipe, "through", FileKind::table);
  char bytes[16] = {};
  EXPECT_EQ(::read(reader, bytes, sizeof bytes), 7);
  EXPECT_STREQ(bytes, "through");
  close(reader);
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
  EXPECT_EQ(folder.count(), 1);
  write_output("/dev/null", "x", FileKind::json);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

/// Opening such a pipe would wait for another program, possibly forever.
TEST(WholeFile, DoesNotWaitForTheOtherEndOfAPipe) {
  const test::ScratchFolder folder;
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_TRUE(holds(message_of([&] { write_output(pipe, "x", FileKind::json); }), {"os.file.unread_pipe"}));
  EXPECT_TRUE(holds(message_of([&] { read_file(pipe); }), {"os.file.read_pipe"}));
  int ends[2]; // one without a name in a folder, as between the commands of a shell
  ASSERT_EQ(::pipe(ends), 0);
  ASSERT_EQ(::write(ends[1], "abc", 3), 3);
  ::close(ends[1]);
  EXPECT_EQ(read_file("/dev/fd/" + std::to_string(ends[0])), "abc");
  ::close(ends[0]);
}

TEST(WholeFile, KeepsAFileOfAnotherKind) {
  const test::ScratchFolder folder;
  const std::string script = folder.file("study.lua"), link = folder.file("link.h5");
  std::ofstream(script) << "-- my study\n";
  std::filesystem::create_symlink("study.lua", link);
  for (const FileKind kind : {FileKind::hdf5, FileKind::checkpoint, FileKind::png, FileKind::json, FileKind::table}) {
    EXPECT_TRUE(holds(message_of([&] { write_output(script, "x", kind); }), {"os.file.other_kind: file = " + script}));
    EXPECT_TRUE(holds(message_of([&] { check_output(link, kind); }), {"os.file.other_kind"}));
    EXPECT_TRUE(holds(message_of([&] { move_output(link, script, kind); }), {"os.file.other_kind"}));
  }
  EXPECT_EQ(read_file(script), "-- my study\n");
  std::ofstream(script, std::ios::trunc) << "";
  write_output(script, "[1]", FileKind::json); // an empty file has no content to lose
  EXPECT_EQ(read_file(script), "[1]");
}

/// Without the signal of the limit, which repl ignores, too.
TEST(WholeFile, ReportsTheLimitOfTheSizeOfFiles) {
  const test::ScratchFolder folder;
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{}, limit{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  limit = {1000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &limit), 0);
  const std::string message = message_of([&] { write_record(folder.file("a"), std::string(2000, 'x')); });
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  EXPECT_TRUE(holds(message, {"os.file.too_large: file = " + folder.file("a") + ", most = 1000"}));
  EXPECT_EQ(folder.count(), 0);
}

TEST(WholeFile, ErrorsNameFileAndRemedyIfItCannotWrite) {
  const test::ScratchFolder folder;
  const std::string nowhere = folder.file("missing") + "/a.txt";
  EXPECT_TRUE(holds(message_of([&] { write_record(nowhere, "x"); }),
                    {"os.file.no_folder: file = " + nowhere + ", folder = " + folder.file("missing")}));

  write_record(folder.file("file"), "x");
  EXPECT_TRUE(holds(message_of([&] { write_record(folder.file("file") + "/a/b.txt", "x"); }),
                    {"above = " + folder.file("file")}));
  std::filesystem::remove(folder.file("file"));
  EXPECT_TRUE(holds(message_of([&] { write_record("~/a.txt", "x"); }), {"os.file.tilde"}));

  std::filesystem::create_directory(folder.file("folder"));
  EXPECT_TRUE(holds(message_of([&] { write_record(folder.file("folder"), "x", true); }), {"os.file.write_folder"}));
  EXPECT_TRUE(holds(message_of([&] { write_record("/proc/signorini.txt", "x"); }),
                    {"os.file.write: file = /proc/signorini.txt"}));
  EXPECT_EQ(folder.count(), 1);
}

TEST(WholeFile, ErrorsNameAFileThatItCannotRead) {
  const test::ScratchFolder folder;
  EXPECT_TRUE(holds(message_of([&] { read_file(folder.file("a")); }),
                    {"os.file.read: file = " + folder.file("a") + ", reason = No such file"}));
  std::filesystem::create_directory(folder.file("folder"));
  EXPECT_TRUE(holds(message_of([&] { read_file(folder.file("folder")); }), {"os.file.read_folder"}));
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
  write_record(file, "x");
  EXPECT_EQ(read_file(file), "x");
  EXPECT_EQ(names(), std::vector<std::string>{"a.sgn"});

  const int held = ::open(left.c_str(), O_WRONLY | O_CREAT, 0666);
  struct flock whole {};
  whole.l_type = F_WRLCK;
  ASSERT_EQ(::fcntl(held, F_OFD_SETLK, &whole), 0);
  write_record(file, "y");
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
    write_record(file, "z");
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
  write_record(file, content(0));
  std::vector<pid_t> processes;
  for (int writer = 0; writer < writers; ++writer) {
    processes.push_back(::fork());
    if (processes.back() != 0) continue;
    for (int k = 0; k < times; ++k) {
      write_record(file, content(writer));
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
