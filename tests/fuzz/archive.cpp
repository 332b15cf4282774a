#include "os/archive.hpp"
#include "contact/method/archive.hpp"
#include "nurbs/archive.hpp"
#include "solid/archive.hpp"
#include "symbolic/archive.hpp"
#include "targets.hpp"

namespace signorini::fuzz {

namespace {

/// Reads a value; what was read is written and read again with the same bytes.
template <class T> void repeat(ArchiveReader from) {
  ArchiveWriter first, second;
  first.put(from.get<T>());
  second.put(ArchiveReader(first.bytes()).get<T>());
  require_that(first.bytes() == second.bytes(), "an object is read as it was written");
}

template <int D> void repeat_body(ArchiveReader from) {
  ArchiveWriter first, second;
  first.put(*solid::read_body<D>(from));
  ArchiveReader again(first.bytes());
  second.put(*solid::read_body<D>(again));
  require_that(first.bytes() == second.bytes(), "a body is read as it was written");
}

using Read = void (*)(ArchiveReader);
constexpr Read reads[] = {
    repeat<nurbs::KnotVector>,    repeat<nurbs::Patch>,   repeat<nurbs::Space1D>, repeat<nurbs::Discretization>,
    repeat<solid::Material>,      repeat_body<2>,         repeat_body<3>,         repeat<contact::Obstacle<2>>,
    repeat<contact::Obstacle<3>>, repeat<contact::Method>};

} // namespace

void archive(std::string_view input) {
  if (input.empty()) return;
  const auto kind = static_cast<unsigned char>(input.front()) % std::size(reads);
  passes([&] { reads[kind](ArchiveReader(input.substr(1), {.finite = true, .elements = 4096})); });
}

} // namespace signorini::fuzz
