#include "solid/archive.hpp"

#include "nurbs/archive.hpp"

namespace signorini::solid {

void write(ArchiveWriter& to, const Material& material) {
  const auto& [youngs_modulus, poissons_ratio, lambda, mu] = constants(material);
  to.put(static_cast<int>(material.index()), youngs_modulus, poissons_ratio, lambda, mu);
}

Material read(ArchiveReader& from, std::type_identity<Material>) {
  const int law = from.get<int>();
  ElasticConstants constants;
  auto& [youngs_modulus, poissons_ratio, lambda, mu] = constants;
  from.into(youngs_modulus, poissons_ratio, lambda, mu);
  require(law == 0 || law == 1, "material: there is no law ", law);
  if (law == 0) return NeoHookean{constants};
  return LinearElastic{constants};
}

template <int D> void write(ArchiveWriter& to, const Body<D>& body) {
  to.put(body.space(), body.material(), body.kind());
}

template <int D> std::shared_ptr<const Body<D>> read_body(ArchiveReader& from) {
  auto space = std::make_shared<const nurbs::Discretisation>(from.get<nurbs::Discretisation>());
  const Material material = read(from, std::type_identity<Material>());
  return std::make_shared<const Body<D>>(std::move(space), material, from.get<Kind>());
}

template void write(ArchiveWriter&, const Body<2>&);
template void write(ArchiveWriter&, const Body<3>&);
template std::shared_ptr<const Body<2>> read_body<2>(ArchiveReader&);
template std::shared_ptr<const Body<3>> read_body<3>(ArchiveReader&);

} // namespace signorini::solid
