// core.make_result_file and others: files of HDF5, and what lua/signorini/output/hdf5 writes into them that no public
// function returns: the function spaces of bodies, the faces of contacts.

#include "exchange/hdf5.hpp"
#include "bind/lua/arguments.hpp"
#include "bind/lua/functions.hpp"
#include "bind/lua/open.hpp"
#include "bind/model/model.hpp"
#include "model/results/results.hpp"
#include "os/file_identity.hpp"
#include "os/whole_file.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace signorini::bind {

namespace {

struct Hdf5 {
  std::unique_ptr<exchange::Hdf5File> file;
  std::optional<FileIdentity> written; ///< the file on the disk, as this process has left it
};

} // namespace

template <> struct Type<Hdf5> { static constexpr auto name = "HDF5 file"; };

namespace {

// ── Files ────────────────────────────────────────────────────────────────────────────────────────────────────────────

/// core.open_result_file(file): a file that exists.
Hdf5 open_result_file(const std::string& file) {
  const std::string bytes = read_file(file);
  return {exchange::hdf5().open(file, bytes), identity_of(file)};
}

/// A list at a stack index whose entries are of a kind: "number", "integer" or "text".
exchange::Hdf5Values values_of(lua_State* L, int index, const std::string& kind) {
  if (kind == "number") return to<std::vector<double>>(L, index);
  if (kind == "text") return to<std::vector<std::string>>(L, index);
  const auto list = to<std::vector<int>>(L, index);
  return std::vector<std::int64_t>(list.begin(), list.end());
}

exchange::Hdf5Shape shape_of(lua_State* L, int index) {
  const auto list = to<std::vector<int>>(L, index);
  for (const int size : list) require(size >= 0, "sizes of an array are expected, got ", size);
  return {list.begin(), list.end()};
}

/// file:write(path, kind, shape, values)
int write_array(const Hdf5& hdf5, const std::string& path, const std::string& kind, lua_State* L) {
  const exchange::Hdf5Shape shape = shape_of(L, 4);
  const exchange::Hdf5Values values = values_of(L, 5, kind);
  const double entries = std::accumulate(shape.begin(), shape.end(), 1.0, std::multiplies<>());
  const std::size_t count = std::visit([](const auto& list) { return list.size(); }, values);
  require(entries == static_cast<double>(count), "an array of ", entries, " values is given ", count);
  hdf5.file->write(path, shape, values);
  return 0;
}

/// file:append(path, kind, shape of an entry, values, first = 0)
int append_to_array(const Hdf5& hdf5, const std::string& path, const std::string& kind, lua_State* L) {
  hdf5.file->append(path, static_cast<std::uint64_t>(luaL_checkinteger(L, 6)), shape_of(L, 4), values_of(L, 5, kind));
  return 0;
}

/// file:set(object, name, kind, a list or a single value)
int set_attribute(const Hdf5& hdf5, const std::string& object, const std::string& name, const std::string& kind,
                  lua_State* L) {
  const bool is_list = lua_istable(L, 5);
  if (!is_list) { // a list of it
    lua_createtable(L, 1, 0);
    lua_pushvalue(L, 5);
    lua_rawseti(L, -2, 1);
  }
  hdf5.file->set(object, name, values_of(L, lua_gettop(L), kind), is_list);
  return 0;
}

/// Replaces the file on the disk. Throws Error if something else has replaced it since the last time.
void save_result_file(Hdf5& hdf5, const std::string& file) {
  const auto found = identity_of(file);
  require(
      !hdf5.written || !found || *found == *hdf5.written, "'", file,
      "' has been replaced by another run or program since this run wrote it. Hint: give each run a file of its own");
  write_output(file, hdf5.file->bytes(), FileKind::hdf5);
  hdf5.written = identity_of(file);
}

constexpr Function hdf5_methods[] = {
    {"make_group", call<[](const Hdf5& hdf5, const std::string& path) { hdf5.file->make_group(path); }>},
    {"write", call<write_array>},
    {"append", call<append_to_array>},
    {"truncate",
     call<[](const Hdf5& hdf5, const std::string& path, int entries) { hdf5.file->truncate(path, entries); }>},
    {"set", call<set_attribute>},
    {"numbers", call<[](const Hdf5& hdf5, const std::string& path) { return hdf5.file->numbers(path); }>},
    {"texts", call<[](const Hdf5& hdf5, const std::string& object, const std::string& attribute) {
       return hdf5.file->texts(object, attribute);
     }>},
    {"save", call<save_result_file>},
};

// ── Scenes ───────────────────────────────────────────────────────────────────────────────────────────────────────────

/// The index of a value in a list, to which it is added if necessary.
template <class T> int index_in(std::vector<T>& list, const T& value) {
  const auto found = std::find(list.begin(), list.end(), value);
  if (found != list.end()) return static_cast<int>(found - list.begin());
  list.push_back(value);
  return std::ssize(list) - 1;
}

/// Pushes the spaces of a body: `spaces`, each { degree, knots } or { breaks, degrees, first, extraction };
/// `row_spaces`, per row of control points and direction
/// of the row the index of its space; `row_start`, the first control point of each row, and their number.
void push_spaces(lua_State* L, const nurbs::Discretization& space) {
  std::vector<nurbs::Space1D> spaces = {space.stack()};
  std::vector<int> row_spaces, row_start;
  for (int j = 0; j < std::ssize(space.rows()); ++j) {
    row_start.push_back(space.first_function(j));
    for (const nurbs::Space1D& one : space.rows()[j].directions()) row_spaces.push_back(index_in(spaces, one));
  }
  row_start.push_back(space.functions());
  set_fields(L, "through", space.through(), "row_spaces", row_spaces, "row_start", row_start);
  push_list(L, spaces, [&](const nurbs::Space1D& one) {
    if (one.knots()) return push_fields(L, "degree", one.degree(), "knots", one.knots()->knots());
    // Several degrees: per element degree, first function and Bézier extraction, row by row
    std::vector<int> degrees, first;
    std::vector<double> extraction;
    for (int e = 0; e < one.elements(); ++e) {
      degrees.push_back(one.degree(e));
      first.push_back(one.functions_on(e).front());
      const auto matrix = one.extraction(e);
      extraction.insert(extraction.end(), matrix.data(), matrix.data() + matrix.size());
    }
    push_fields(L, "breaks", one.breaks(), "degrees", degrees, "first", first, "extraction", extraction);
  });
  lua_setfield(L, -2, "spaces");
}

/// core.body_data(model, body): what a file stores of it.
template <int D> int body_data(const model::Model<D>& model, const std::string& name, lua_State* L) {
  const auto& scene = model.system.scene;
  const Body<D>& body = scene.bodies[find_body(model, name)].body;
  const nurbs::Discretization& space = body->space();
  const MatrixX points = space.points();
  const solid::Material& material = body->material();
  push_fields(L, "dimension", D, "kind",
              D == 3                                    ? "solid"
              : scene.kind == solid::Kind::axisymmetric ? "axisymmetric"
                                                        : "plane strain",
              "points", VectorX(points.reshaped()), "weights", VectorX(space.homogeneous().row(D)), "law",
              material.name(), "E", material.constants().youngs_modulus, "nu", material.constants().poissons_ratio);
  push_object(L, body);
  lua_setfield(L, -2, "body");
  push_spaces(L, space);
  return 1;
}

/// core.body_displacement(model, body): a flat list, and the dimension.
template <int D> int body_displacement(const model::Model<D>& model, const std::string& name, lua_State* L) {
  push(L, VectorX(model::body_displacement(model, find_body(model, name)).reshaped()));
  push(L, D);
  return 2;
}

/// "south of die"; the faces of a list with commas between them.
template <int D> std::string faces_in_words(const model::Model<D>& model, const model::Faces& faces) {
  std::string words;
  for (const model::FaceReference& face : faces)
    words +=
        text(words.empty() ? "" : ", ", nurbs::name_of(face.side), " of ", model.system.scene.bodies[face.body].name);
  return words;
}

/// core.contact_faces(model, contact or tie): slave and master in words.
template <int D> int contact_faces(const model::Model<D>& model, const std::string& name, lua_State* L) {
  const auto& scene = model.system.scene;
  for (const model::Tie& tie : scene.ties)
    if (tie.name == name) {
      push_fields(L, "slave", faces_in_words(model, tie.slave), "master", faces_in_words(model, tie.master));
      return 1;
    }
  const auto& contact = scene.contacts[find(scene.contacts, name, "contact")];
  const auto* master = std::get_if<model::Faces>(&contact.master);
  push_fields(L, "slave", faces_in_words(model, contact.slave), "master",
              master ? faces_in_words(model, *master) : "rigid obstacle");
  return 1;
}

constexpr Function hdf5_entries[] = {
    {"make_result_file", call<[]() {
       return Hdf5{exchange::hdf5().make(), {}};
     }>},
    {"open_result_file", call<open_result_file>},
};
template <int D>
constexpr Function part_entries[] = {
    {"body_data", call<body_data<D>>},
    {"body_displacement", call<body_displacement<D>>},
    {"contact_faces", call<contact_faces<D>>},
};
template <int D>
constexpr Function snapshot_core[] = {
    {"model_of", call<[](const Snapshot<D>& snapshot) { return snapshot.model; }>},
};

} // namespace

void open_hdf5(lua_State* L) {
  register_type<Hdf5>(L, hdf5_methods);
  register_functions(L, "core", hdf5_entries);
  register_functions<Model<2>, Model<3>>(L, "core", part_entries<2>, part_entries<3>);
  register_functions<Snapshot<2>, Snapshot<3>>(L, "core", snapshot_core<2>, snapshot_core<3>);
}

} // namespace signorini::bind
