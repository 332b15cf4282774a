#include "solid/archive.hpp"

#include "nurbs/archive.hpp"
#include "solid/linear_elastic.hpp"
#include "solid/neo_hookean.hpp"

#include <algorithm>

namespace signorini::solid {

namespace {

/// A law in files: its number, which is its index in the table below, and its members, which are numbers.
struct LawRow {
  std::string_view name;
  void (*write)(ArchiveWriter& to, const void* law);
  Material (*read)(ArchiveReader& from);
};

template <Law T> constexpr LawRow row() {
  using Members = std::array<double, sizeof(T) / sizeof(double)>;
  return {T::name,
          [](ArchiveWriter& to, const void* law) { to.put(std::bit_cast<Members>(*static_cast<const T*>(law))); },
          [](ArchiveReader& from) -> Material { return std::bit_cast<T>(from.get<Members>()); }};
}

/// New laws are appended: files identify laws by their index.
constexpr LawRow laws[] = {row<NeoHookean>(), row<LinearElastic>()};

} // namespace

void write(ArchiveWriter& to, const Material& material) {
  const auto* row =
      std::find_if(std::begin(laws), std::end(laws), [&](const LawRow& one) { return one.name == material.name(); });
  require(row != std::end(laws), "solid.archive.unknown_law", {{"material", material.name()}});
  to.put(static_cast<int>(row - laws));
  row->write(to, material.law());
}

Material read(ArchiveReader& from, std::type_identity<Material>) {
  const int number = from.get<int>();
  require(number >= 0 && number < std::ssize(laws), "solid.archive.law", {{"number", number}});
  return laws[number].read(from);
}

template <int D> void write(ArchiveWriter& to, const Body<D>& body) {
  to.put(body.space(), body.material(), body.kind());
}

template <int D> std::shared_ptr<const Body<D>> read_body(ArchiveReader& from) {
  auto space = std::make_shared<const nurbs::Discretization>(from.get<nurbs::Discretization>());
  const Material material = read(from, std::type_identity<Material>());
  return std::make_shared<const Body<D>>(std::move(space), material, from.get<Kind>());
}

template void write(ArchiveWriter&, const Body<2>&);
template void write(ArchiveWriter&, const Body<3>&);
template std::shared_ptr<const Body<2>> read_body<2>(ArchiveReader&);
template std::shared_ptr<const Body<3>> read_body<3>(ArchiveReader&);

} // namespace signorini::solid
