#include "model/files/checkpoint.hpp"
#include "os/archive.hpp"
#include "targets.hpp"

namespace signorini::fuzz {

namespace {

/// The input as the body of a checkpoint, with line, version, length and checksum as they must be.
std::string completed(std::string_view input) {
  const std::string_view line = "SIGNORINI checkpoint\n";
  constexpr std::size_t head = sizeof(std::uint32_t) + sizeof(std::uint64_t), tail = sizeof(std::uint64_t);
  const bool whole = input.starts_with(line) && input.size() >= line.size() + head + tail;
  std::string_view body = input, version("\7\0\0\0", 4);
  if (whole) {
    version = input.substr(line.size(), version.size());
    body = input.substr(line.size() + head, input.size() - line.size() - head - tail);
  }
  ArchiveWriter file;
  file.append(line.data(), line.size());
  file.append(version.data(), version.size());
  file.put(std::string(body));
  file.put(checksum(file.bytes()));
  return file.bytes();
}

} // namespace

/// A model that was loaded can be restored, with the same bits each time.
void checkpoint(std::string_view input) {
  passes([&] {
    const std::string file = file_of(completed(input));
    model::load_text(file);
    std::visit(
        [&](auto model) {
          const std::string first = content(*model, snapshot(*model));
          model::restore(model, file);
          require_that(content(*model, snapshot(*model)) == first, "a state is restored bit by bit");
        },
        model::load(file));
  });
}

} // namespace signorini::fuzz
