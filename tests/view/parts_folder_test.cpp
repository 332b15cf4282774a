// Folders for the parts of films: what killed processes have left is removed, two writers do not disturb each other.

#include "scratch.hpp"
#include "view/parts_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <optional>

namespace signorini::view {
namespace parts_folder_test {

namespace fs = std::filesystem;

void write(const std::string& file) {
  std::ofstream(file) << "x";
}

TEST(PartsFolder, IsHiddenNextToTheFileAndRemovedWithItsContents) {
  const test::ScratchFolder scratch;
  {
    const PartsFolder folder(scratch.file("x'y.mp4"));
    EXPECT_EQ(folder.path("1.png"), scratch.file(".x'y.mp4.parts/1.png"));
    write(folder.path("1.png"));
  }
  EXPECT_EQ(scratch.count(), 0);
}

TEST(PartsFolder, LosesWhatAKilledProcessHasLeft) {
  const test::ScratchFolder scratch;
  fs::create_directories(scratch.file(".x.mp4.parts/inner"));
  write(scratch.file(".x.mp4.parts/7.png"));
  write(scratch.file(".x.mp4.parts/inner/8.png"));
  const PartsFolder folder(scratch.file("x.mp4"));
  EXPECT_TRUE(fs::is_empty(folder.path("")));
}

TEST(PartsFolder, IsAnotherOneWhileTheSameFileIsMade) {
  const test::ScratchFolder scratch;
  std::optional<PartsFolder> first(scratch.file("x.mp4"));
  write(first->path("1.png"));
  std::string place;
  {
    const PartsFolder second(scratch.file("x.mp4"));
    place = second.path("1.png");
    EXPECT_NE(place, first->path("1.png"));
    write(place);
    EXPECT_TRUE(fs::exists(first->path("1.png")));
    first.reset();
    EXPECT_TRUE(fs::exists(place));
  }
  EXPECT_EQ(scratch.count(), 0);
}

TEST(PartsFolder, FollowsNoLink) {
  const test::ScratchFolder scratch;
  fs::create_directory(scratch.file("own"));
  write(scratch.file("own/kept"));
  fs::create_directory_symlink(scratch.file("own"), scratch.file(".x.mp4.parts"));
  { const PartsFolder folder(scratch.file("x.mp4")); }
  EXPECT_TRUE(fs::exists(scratch.file("own/kept")));
}

TEST(PartsFolder, NeedsAFolderForTheFile) {
  const test::ScratchFolder scratch;
  const std::string message = test::message_of([&] { PartsFolder(scratch.file("missing/x.mp4")); });
  EXPECT_TRUE(test::holds(message, {"view.series.folder"}));
}

} // namespace parts_folder_test
} // namespace signorini::view
