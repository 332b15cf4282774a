#include "os/archive.hpp"

#include "os/whole_file.hpp"
#include "scratch.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace signorini {
namespace archive_test {

using test::holds;
using test::message_of;

const ArchiveKind trial{"trial", 7, 6};

/// A value of each type.
ArchiveWriter example() {
  ArchiveWriter out;
  MatrixX matrix(2, 3);
  matrix << 1, 2, 3, 4, 5, 6;
  out.put(-3, true, 1e-310, std::string("a\0b", 3), std::vector<double>{0.1, 0.2}, std::vector<int>());
  out.section("inside", [&](ArchiveWriter& to) { to.put(matrix, Vec<3>(7, 8, 9), std::array<int, 2>{4, 5}); });
  return out;
}

void read_example(std::string_view bytes) {
  ArchiveReader in(bytes);
  EXPECT_EQ(in.get<int>(), -3);
  EXPECT_EQ(in.get<bool>(), true);
  EXPECT_EQ(in.get<double>(), 1e-310);
  EXPECT_EQ(in.get<std::string>(), std::string("a\0b", 3));
  EXPECT_EQ(in.get<std::vector<double>>(), (std::vector<double>{0.1, 0.2}));
  EXPECT_TRUE(in.get<std::vector<int>>().empty());
  ArchiveReader inside(in.section("inside"));
  EXPECT_EQ(inside.get<MatrixX>()(1, 2), 6);
  EXPECT_EQ(inside.get<Vec<3>>(), Vec<3>(7, 8, 9));
  EXPECT_EQ((inside.get<std::array<int, 2>>()), (std::array<int, 2>{4, 5}));
  EXPECT_EQ(inside.remaining(), 0u);
  EXPECT_EQ(in.remaining(), 0u);
}

TEST(Archive, ReturnsWrittenValues) {
  read_example(example().bytes());
  ArchiveWriter empty;
  empty.put(VectorX(), MatrixX(3, 0));
  ArchiveReader in(empty.bytes());
  EXPECT_EQ(in.get<VectorX>().size(), 0);
  EXPECT_EQ(in.get<MatrixX>().rows(), 3);
}

TEST(Archive, KeepsAllBitsOfNumbers) {
  using Limits = std::numeric_limits<double>;
  for (const double value :
       {0.0, -0.0, Limits::denorm_min(), Limits::max(), Limits::infinity(), -Limits::quiet_NaN(), 0.1, 1.0 / 3}) {
    ArchiveWriter out;
    out.put(value);
    const double back = ArchiveReader(out.bytes()).get<double>();
    EXPECT_EQ(std::memcmp(&back, &value, sizeof(double)), 0) << value;
  }
}

/// The file format does not depend on the machine.
TEST(Archive, WritesLeastSignificantByteFirst) {
  ArchiveWriter out;
  out.put(0x01020304, 1.5);
  EXPECT_EQ(out.bytes(), std::string("\4\3\2\1\0\0\0\0\0\0\xf8\x3f", 12));
}

TEST(Archive, NeverReadsBeyondTheEnd) {
  const std::string bytes = example().bytes();
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_THROW(read_example(std::string_view(bytes).substr(0, length)), Error) << length;
  ArchiveWriter vast;
  vast.put(std::numeric_limits<std::uint64_t>::max() / 8, std::uint64_t(8));
  EXPECT_THROW(ArchiveReader(vast.bytes()).get<std::vector<double>>(), Error);
  EXPECT_THROW(ArchiveReader(vast.bytes()).get<std::string>(), Error);
  EXPECT_THROW(ArchiveReader(vast.bytes()).get<MatrixX>(), Error);
  ArchiveWriter empty; // of 2^63 rows without columns, which would be a negative number
  empty.put(std::uint64_t(1) << 63, std::uint64_t(0));
  EXPECT_THROW(ArchiveReader(empty.bytes()).get<MatrixX>(), Error);
}

TEST(Archive, ChecksSectionsAndSizes) {
  ArchiveWriter out;
  out.section("one", [](ArchiveWriter& to) { to.put(Vec<2>(1, 2)); });
  EXPECT_EQ(message_of([&] { ArchiveReader(out.bytes()).section("two"); }),
            "os.archive.section: expected = two, found = one");
  EXPECT_THROW(ArchiveReader(ArchiveReader(out.bytes()).section("one")).get<Vec<3>>(), Error);
}

enum class Color { red, green };
constexpr Color last_value(std::type_identity<Color>) {
  return Color::green;
}

TEST(Archive, ChecksEnumerationsAndOnRequestNumbers) {
  ArchiveWriter out;
  out.put(Color::green, 2, -1);
  ArchiveReader in(out.bytes());
  EXPECT_EQ(in.get<Color>(), Color::green);
  EXPECT_EQ(message_of([&] { in.get<Color>(); }), "os.archive.enumeration: number = 2, last = 1");
  EXPECT_THROW(in.get<Color>(), Error);
  ArchiveWriter numbers;
  numbers.put(1.5, std::numeric_limits<double>::infinity());
  ArchiveReader finite(numbers.bytes(), {.finite = true});
  EXPECT_EQ(finite.get<double>(), 1.5);
  EXPECT_THROW(finite.get<double>(), Error);
}

TEST(ArchiveFile, ReturnsItsBytes) {
  const test::ScratchFolder folder;
  write_archive(folder.file("a"), trial, example());
  read_example(read_archive(folder.file("a"), trial).bytes);
  EXPECT_TRUE(read_file(folder.file("a")).starts_with("SIGNORINI trial\n"));
  EXPECT_EQ(folder.count(), 1);
}

TEST(ArchiveFile, ReportsDamagedAndWrongFiles) {
  const test::ScratchFolder folder;
  const std::string file = folder.file("a");
  const auto message = [&](const std::string& bytes) {
    write_record(file, bytes);
    return message_of([&] { read_archive(file, trial); });
  };
  write_archive(file, trial, example());
  const std::string good = read_file(file);
  EXPECT_TRUE(holds(message("PK\3\4 something else"), {"os.archive.kind: file = " + file + ", kind = trial"}));
  EXPECT_TRUE(holds(message(""), {"os.archive.kind"}));
  std::string other = good;
  char& version = other[std::strlen("SIGNORINI trial\n")];
  version = 8;
  EXPECT_TRUE(holds(message(other), {"os.archive.newer: file = " + file + ", written = 8, known = 7"}));
  version = 5;
  EXPECT_TRUE(holds(message(other), {"os.archive.older: file = " + file + ", written = 5, known = 6"}));
  EXPECT_TRUE(holds(message(good + "x"), {"damage = (os.archive.trailing: count = 1)"}));
  for (std::size_t length = std::strlen("SIGNORINI trial\n"); length < good.size(); ++length)
    EXPECT_TRUE(holds(message(good.substr(0, length)), {"damage = (os.archive.cut_off: length = "}));
  // Every single bit is flipped in turn.
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    std::string flipped = good;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << bit % 8));
    ASSERT_NE(message(flipped), "no error") << bit;
  }
}

} // namespace archive_test
} // namespace signorini
