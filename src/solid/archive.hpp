#pragma once
// Serialization of bodies: their tables are rebuilt from space, material and kind, with identical bits.

#include "os/archive.hpp"
#include "solid/body.hpp"

namespace signorini::solid {

constexpr Kind last_value(std::type_identity<Kind>) {
  return Kind::plane_stress;
}

void write(ArchiveWriter& to, const Material& material);
Material read(ArchiveReader& from, std::type_identity<Material>);

template <int D> void write(ArchiveWriter& to, const Body<D>& body);
template <int D> std::shared_ptr<const Body<D>> read_body(ArchiveReader& from);

} // namespace signorini::solid
