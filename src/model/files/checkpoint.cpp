#include "model/files/checkpoint.hpp"

#include "contact/method/archive.hpp"
#include "model/adapt/following.hpp"
#include "model/adapt/scene_archive.hpp"
#include "model/scene/changed_contact.hpp"
#include "os/whole_file.hpp"

#include <algorithm>
#include <memory>

namespace signorini {

namespace solve {

constexpr LinearKind last_value(std::type_identity<LinearKind>) {
  return LinearKind::mumps;
}

} // namespace solve

namespace model {

namespace {

const ArchiveKind kind{"checkpoint", 13, 13};

using Parts = std::vector<ScenePart>;

template <int D> void write_state(ArchiveWriter& to, const Snapshot<D>& saved) {
  const auto& [displacement, targets, force, factor, time, relaxed, contacts, internal] = saved.state;
  const auto& [increment, previous, before, targets_before, linear_error, quadratic_error, force_scale, work] =
      saved.path;
  to.put(displacement, increment, targets, previous, before, targets_before, force_scale, work, force, factor, time,
         linear_error, quadratic_error, saved.linear);
  for (const auto& history : contacts) contact::write_history<D>(to, history);
  for (const auto& values : internal)
    if (!values.empty()) to.put(values);
}

/// Reads the state into a snapshot of a model of the same scene.
template <int D> void read_state(ArchiveReader& from, const System<D>& system, Snapshot<D>& saved) {
  auto& [displacement, targets, force, factor, time, relaxed, contacts, internal] = saved.state;
  auto& [increment, previous, before, targets_before, linear_error, quadratic_error, force_scale, work] = saved.path;
  const Eigen::Index dofs = displacement.size(), components = targets.size();
  from.into(displacement, increment, targets, previous, before, targets_before, force_scale, work, force, factor, time,
            linear_error, quadratic_error, saved.linear);
  require(displacement.size() == dofs && increment.size() == dofs && before.size() == dofs && force.size() == dofs &&
              targets.size() == components && previous.size() == components && targets_before.size() == components,
          "model.checkpoint.size", {{"saved", displacement.size()}, {"dofs", dofs}});
  using solve::LinearKind; // a path begins with one of two
  require(saved.linear == LinearKind::automatic || saved.linear == LinearKind::reuse, "model.checkpoint.solver",
          {{"number", static_cast<int>(saved.linear)}});
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    contact::read_history<D>(from, *system.contacts[k], contacts.own()[k]);
    check_changes(system.scene.contacts[k], contacts[k].changes);
  }
  for (auto& values : internal) {
    const std::size_t count = values.size();
    if (count > 0) from.into(values);
    require(values.size() == count, "model.checkpoint.internal_variables",
            {{"saved", values.size()}, {"count", count}});
  }
}

template <int D> void take_state(Model<D>& model, std::string_view bytes) {
  const Snapshot<D> before = snapshot(model);
  Snapshot<D> saved = before;
  ArchiveReader from(bytes, {.finite = true});
  read_state(from, model.system, saved);
  try {
    restore(model, saved);
    settle(model);
    require(model.present.force.allFinite(), "model.checkpoint.not_finite");
  } catch (const Error&) {
    restore(model, before);
    throw;
  }
}

/// Parts of a file.
struct Content {
  std::unique_ptr<const std::string> bytes; ///< which do not move with the content
  int dimension;
  std::string_view text, scene, layers, state; ///< of bytes
};

using Layers = std::vector<nurbs::RaisedElements>;

Content open(const std::string& file) {
  Content content{std::make_unique<const std::string>(read_archive(file, kind).bytes), 0, {}, {}, {}, {}};
  ArchiveReader from(*content.bytes);
  content.dimension = from.get<int>();
  content.text = from.section("text");
  content.scene = from.section("scene");
  content.layers = from.section("layers");
  content.state = from.section("state");
  return content;
}

/// Brings a model of the file's scene into the state of the file; it is replaced if the layers are elsewhere.
template <int D> void take(std::shared_ptr<Model<D>>& model, const Content& content) {
  if (const auto places = ArchiveReader(content.layers).get<Layers>(); places != layers(*model)) {
    const std::size_t bodies = model->system.scene.bodies.size();
    require(places.size() == bodies, "model.checkpoint.bodies", {{"saved", places.size()}, {"count", bodies}});
    rollback(*model);
    auto other = with_layers(*model, places);
    require(other != nullptr, "model.checkpoint.layers");
    model = std::move(other);
  }
  take_state(*model, content.state);
}

/// A state has more numbers than its bodies have elements.
template <int D> std::shared_ptr<Model<D>> load_model(const Content& content) {
  const ArchiveLimits limits{.finite = true, .elements = content.state.size() / sizeof(double)};
  auto model = std::make_shared<Model<D>>(read_scene<D>(ArchiveReader(content.scene).get<Parts>(), limits));
  take(model, content);
  return model;
}

/// Names of the parts that differ.
std::vector<std::string> differences(const Parts& here, const Parts& there) {
  const auto match = [](const Parts& parts, const ScenePart& part) {
    return std::find_if(parts.begin(), parts.end(), [&](const ScenePart& other) { return other.name == part.name; });
  };
  std::vector<std::string> names;
  for (const ScenePart& part : there)
    if (const auto own = match(here, part); own == here.end() || own->bytes != part.bytes) names.push_back(part.name);
  for (const ScenePart& part : here)
    if (match(there, part) == there.end()) names.push_back(part.name);
  return names;
}

} // namespace

template <int D> void save(Model<D>& model, const std::string& file, const std::string& text, bool durable) {
  require(settled(model), "model.checkpoint.unsettled");
  settle(model);
  ArchiveWriter archive;
  archive.put(D);
  archive.section("text", [&](ArchiveWriter& to) { to.append(text.data(), text.size()); });
  archive.section("scene", [&](ArchiveWriter& to) { to.put(scene_parts(model)); });
  archive.section("layers", [&](ArchiveWriter& to) { to.put(layers(model)); });
  archive.section("state", [&](ArchiveWriter& to) { write_state(to, snapshot(model)); });
  write_archive(file, kind, archive, durable);
}

template <int D> std::string content(const Model<D>& model, const Snapshot<D>& state) {
  ArchiveWriter archive;
  archive.put(scene_parts(model), layers(model));
  write_state(archive, state);
  return archive.bytes();
}

AnyModel load(const std::string& file) {
  const Content content = open(file);
  require(content.dimension == 2 || content.dimension == 3, "model.checkpoint.no_dimension",
          {{"dimension", content.dimension}});
  if (content.dimension == 3) return load_model<3>(content);
  return load_model<2>(content);
}

std::string load_text(const std::string& file) {
  return std::string(open(file).text);
}

template <int D> void restore(std::shared_ptr<Model<D>>& model, const std::string& file) {
  const Content content = open(file);
  require(content.dimension == D, "model.checkpoint.dimension",
          {{"file", file}, {"dimension", content.dimension}, {"expected", D}});
  const auto differ = differences(scene_parts(*model), ArchiveReader(content.scene).get<Parts>());
  require(differ.empty(), "model.checkpoint.scene", {{"file", file}, {"differences", differ}});
  take(model, content);
}

template void save(Model<2>&, const std::string&, const std::string&, bool);
template void save(Model<3>&, const std::string&, const std::string&, bool);
template std::string content(const Model<2>&, const Snapshot<2>&);
template std::string content(const Model<3>&, const Snapshot<3>&);
template void restore(std::shared_ptr<Model<2>>&, const std::string&);
template void restore(std::shared_ptr<Model<3>>&, const std::string&);

} // namespace model

} // namespace signorini
