#include "os/archive.hpp"

#include "os/whole_file.hpp"

namespace signorini {

std::string_view ArchiveReader::take(std::size_t count) {
  require(count <= rest_.size(), "os.archive.bytes", {{"count", count}, {"left", rest_.size()}});
  const std::string_view taken = rest_.substr(0, count);
  rest_.remove_prefix(count);
  return taken;
}

std::size_t ArchiveReader::count() {
  const auto count = get<std::uint64_t>();
  require(count <= rest_.size(), "os.archive.list", {{"count", count}, {"left", rest_.size()}});
  return static_cast<std::size_t>(count);
}

std::string_view ArchiveReader::section(const std::string& name) {
  const auto found = get<std::string>();
  require(found == name, "os.archive.section", {{"expected", name}, {"found", found}});
  return take(count());
}

std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t sum = 0xcbf29ce484222325; // offset basis and prime of Fowler, Noll and Vo
  for (const char byte : bytes) sum = (sum ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  return sum;
}

namespace {

std::string first_line(const ArchiveKind& kind) {
  return text("SIGNORINI ", kind.name, "\n");
}

} // namespace

void write_archive(const std::string& file, const ArchiveKind& kind, const ArchiveWriter& archive, bool durable) {
  const std::string line = first_line(kind);
  ArchiveWriter whole;
  whole.append(line.data(), line.size());
  whole.put(kind.version, archive.bytes());
  whole.put(checksum(whole.bytes()));
  write_output(file, whole.bytes(), FileKind::checkpoint, durable);
}

ArchiveBytes read_archive(const std::string& file, const ArchiveKind& kind) {
  const std::string bytes = read_file(file), line = first_line(kind);
  require(bytes.starts_with(line), "os.archive.kind", {{"file", file}, {"kind", kind.name}});
  const auto damaged = [&](const Message& damage) { fail("os.archive.damaged", {{"file", file}, {"damage", damage}}); };
  const Message cut_off("os.archive.cut_off", {{"length", bytes.size()}});
  ArchiveReader reader(std::string_view(bytes).substr(line.size()));
  if (reader.remaining() < sizeof(kind.version)) damaged(cut_off);
  const auto version = reader.get<std::uint32_t>();
  require(version <= kind.version, "os.archive.newer", {{"file", file}, {"written", version}, {"known", kind.version}});
  require(version >= kind.oldest, "os.archive.older", {{"file", file}, {"written", version}, {"known", kind.oldest}});
  if (reader.remaining() < sizeof(std::uint64_t)) damaged(cut_off);
  const auto length = reader.get<std::uint64_t>();
  const std::size_t rest = reader.remaining(), tail = sizeof(std::uint64_t);
  if (rest < tail || length > rest - tail) damaged(cut_off);
  if (length < rest - tail) damaged(Message("os.archive.trailing", {{"count", rest - tail - length}}));
  std::string body(reader.take(static_cast<std::size_t>(length)));
  if (reader.get<std::uint64_t>() != checksum(std::string_view(bytes).substr(0, bytes.size() - tail)))
    damaged(Message("os.archive.checksum"));
  return {std::move(body), version};
}

} // namespace signorini
