#pragma once
// Bodies in files: their tables are made anew from the same space, material and kind, so they have the same bits.

#include "base/archive.hpp"
#include "solid/body.hpp"

namespace signorini::solid {

void write(ArchiveWriter& to, const Material& material);
Material read(ArchiveReader& from, std::type_identity<Material>);

template <int D> void write(ArchiveWriter& to, const Body<D>& body);
template <int D> std::shared_ptr<const Body<D>> read_body(ArchiveReader& from);

} // namespace signorini::solid
