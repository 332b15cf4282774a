#include "solid/archive.hpp"

#include "nurbs/archive.hpp"
#include "solid/hyperelastic.hpp"
#include "solid/linear_elastic.hpp"
#include "solid/neo_hookean.hpp"
#include "solid/viscoelastic.hpp"
#include "symbolic/archive.hpp"

#include <algorithm>
#include <cmath>

namespace signorini::solid {

constexpr Volumetric last_value(std::type_identity<Volumetric>) {
  return Volumetric::projected;
}
constexpr Measure last_value(std::type_identity<Measure>) {
  return Measure::stretches;
}
constexpr Relaxes last_value(std::type_identity<Relaxes>) {
  return Relaxes::all;
}

namespace {

/// Throws Error unless λ and μ are those of E and ν.
void check(const ElasticConstants& constants) {
  const auto [E, nu, lambda, mu] = elastic_constants(constants.youngs_modulus, constants.poissons_ratio);
  const auto differs = [](double a, double b) { return !(std::abs(a - b) <= 1e-12 * std::abs(b)); };
  require(!differs(constants.lambda, lambda) && !differs(constants.mu, mu), "solid.archive.constants",
          {{"youngs_modulus", E}, {"poissons_ratio", nu}});
}

/// A law in files: its number, which is its index in the table below, and what it consists of.
struct LawRow {
  std::string_view name;
  void (*write)(ArchiveWriter& to, const void* law);
  Material (*read)(ArchiveReader& from);
};

/// A law whose members are numbers.
template <Law T> constexpr LawRow row() {
  using Members = std::array<double, sizeof(T) / sizeof(double)>;
  return {T::name,
          [](ArchiveWriter& to, const void* law) { to.put(std::bit_cast<Members>(*static_cast<const T*>(law))); },
          [](ArchiveReader& from) -> Material {
            const T law = std::bit_cast<T>(from.get<Members>());
            check(law);
            return law;
          }};
}

void write_formula(ArchiveWriter& to, const void* law) {
  const EnergyFormula& formula = static_cast<const Hyperelastic*>(law)->formula();
  to.put(formula.label, formula.measure, formula.fibers, symbolic::Formula{formula.graph, formula.energy});
}

Material read_formula(ArchiveReader& from) {
  auto label = from.get<std::string>();
  const auto measure = from.get<Measure>();
  auto fibers = from.get<std::vector<Vec<3>>>();
  auto [graph, energy] = symbolic::read_formula(from, variable_names(measure, fibers.size()));
  return hyperelastic({std::move(label), measure, std::move(fibers), std::move(graph), energy});
}

void write_series(ArchiveWriter& to, const void* law) {
  const Viscoelastic& own = *static_cast<const Viscoelastic*>(law);
  write(to, own.elastic);
  to.put(own.relaxes, static_cast<int>(own.series.size()));
  for (const auto& [fraction, time] : own.series) to.put(fraction, time);
}

Material read_series(ArchiveReader& from) {
  Material elastic = read(from, std::type_identity<Material>());
  const auto relaxes = from.get<Relaxes>();
  std::vector<Relaxation> series;
  for (int i = from.get<int>(); i > 0; --i) {
    const double fraction = from.get<double>();
    series.push_back({fraction, from.get<double>()});
  }
  return viscoelastic(std::move(elastic), std::move(series), relaxes);
}

/// New laws are appended: files identify laws by their index.
constexpr LawRow laws[] = {row<NeoHookean>(),
                           row<LinearElastic>(),
                           {Hyperelastic::name, write_formula, read_formula},
                           {Viscoelastic::name, write_series, read_series}};

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
  to.put(body.space(), body.material(), body.kind(), body.volumetric(), body.density());
}

template <int D> std::shared_ptr<const Body<D>> read_body(ArchiveReader& from) {
  auto space = std::make_shared<const nurbs::Discretization>(from.get<nurbs::Discretization>());
  const Material material = read(from, std::type_identity<Material>());
  const auto kind = from.get<Kind>();
  const auto volumetric = from.get<Volumetric>();
  const double density = from.get<double>();
  require(density > 0 && std::isfinite(density), "solid.archive.density", {{"density", density}});
  return std::make_shared<const Body<D>>(std::move(space), material, kind, volumetric, density);
}

template void write(ArchiveWriter&, const Body<2>&);
template void write(ArchiveWriter&, const Body<3>&);
template std::shared_ptr<const Body<2>> read_body<2>(ArchiveReader&);
template std::shared_ptr<const Body<3>> read_body<3>(ArchiveReader&);

} // namespace signorini::solid
