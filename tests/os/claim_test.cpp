#include "os/claim.hpp"

#include "os/jobs.hpp"
#include "os/whole_file.hpp"
#include "scratch.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace signorini {
namespace claim_test {

TEST(Claim, IsCreatedOnceAndKeepsItsContent) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("case.claim");
  EXPECT_TRUE(create_claim(file, "first"));
  EXPECT_FALSE(create_claim(file, "second"));
  EXPECT_EQ(read_file(file), "first");
  EXPECT_EQ(folder.count(), 1); // no temporary file remains
  std::filesystem::remove(file);
  EXPECT_TRUE(create_claim(file, "third"));
}

TEST(Claim, IsGotByOneOfSeveralProcesses) {
  const test::ScratchFolder folder;
  constexpr int files = 50, processes = 4;
  std::vector<int> owners(files, 0);
  run_jobs(
      processes, {.at_once = processes},
      [&](int) {
        std::string got;
        for (int i = 0; i < files; ++i) got += create_claim(folder.file(std::to_string(i)), "") ? '1' : '0';
        return got;
      },
      [&](const JobEnd& end) {
        ASSERT_EQ(end.output.size(), owners.size());
        for (int i = 0; i < files; ++i) owners[i] += end.output[i] == '1';
      });
  EXPECT_EQ(owners, std::vector<int>(files, 1));
}

TEST(Claim, ReportsWhereItCannotBeCreated) {
  const test::ScratchFolder folder;
  EXPECT_TRUE(test::holds(test::message_of([&] { create_claim(folder.file("missing/case.claim"), ""); }), {"os.file"}));
}

} // namespace claim_test
} // namespace signorini
