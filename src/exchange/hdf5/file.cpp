// Files of HDF5 in memory (its driver "core"), so that HDF5 never writes to a disk: a file on a disk is replaced as a
// whole by the bytes in memory.

#include "exchange/hdf5/handle.hpp"
#include "exchange/hdf5_module.hpp"

#include "base/error.hpp"
#include "base/text.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>

namespace signorini::exchange {

namespace {

constexpr std::uint64_t large = 32768;      // bytes from which an entry is compressed, as a chunk of its own
constexpr std::uint64_t chunk = 4096;       // bytes of chunks of smaller entries, which are not compressed
constexpr std::uint64_t chunk_entries = 64; // at most, so that short runs have small files
constexpr unsigned level = 1;               // of gzip: higher ones take longer and hardly reduce numbers further
constexpr std::size_t growth = 1 << 20;     // bytes by which the memory of a file grows

herr_t take_description(unsigned, const H5E_error2_t* error, void* reason) {
  *static_cast<std::string*>(reason) = error->desc;
  return 0;
}

// ── Types and spaces ─────────────────────────────────────────────────────────────────────────────────────────────────

Handle text_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  checked(H5Tset_size(type, H5T_VARIABLE));
  checked(H5Tset_cset(type, H5T_CSET_UTF8));
  return type;
}

/// On a disk, numbers are little-endian on every machine.
Handle stored_type(const Hdf5Values& values) {
  if (std::holds_alternative<std::vector<double>>(values)) return {H5Tcopy(H5T_IEEE_F64LE), H5Tclose};
  if (std::holds_alternative<std::vector<std::int64_t>>(values)) return {H5Tcopy(H5T_STD_I64LE), H5Tclose};
  return text_type();
}

/// Calls use(type in memory, pointer to the values).
void with_memory(const Hdf5Values& values, const std::function<void(hid_t, const void*)>& use) {
  if (const auto* numbers = std::get_if<std::vector<double>>(&values)) return use(H5T_NATIVE_DOUBLE, numbers->data());
  if (const auto* whole = std::get_if<std::vector<std::int64_t>>(&values)) return use(H5T_NATIVE_INT64, whole->data());
  std::vector<const char*> texts;
  for (const std::string& one : std::get<std::vector<std::string>>(values)) texts.push_back(one.c_str());
  use(text_type(), texts.data());
}

std::uint64_t count_of(const Hdf5Values& values) {
  return std::visit([](const auto& list) { return static_cast<std::uint64_t>(list.size()); }, values);
}

std::uint64_t product(const Hdf5Shape& shape) {
  return std::accumulate(shape.begin(), shape.end(), std::uint64_t{1}, std::multiplies<>());
}

Handle space_of(const Hdf5Shape& shape, const hsize_t* most = nullptr) {
  const std::vector<hsize_t> sizes(shape.begin(), shape.end());
  return {H5Screate_simple(static_cast<int>(sizes.size()), sizes.data(), most), H5Sclose};
}

Hdf5Shape joined(std::uint64_t entries, const Hdf5Shape& entry) {
  Hdf5Shape shape = {entries};
  shape.insert(shape.end(), entry.begin(), entry.end());
  return shape;
}

/// The layout of an array in chunks of this shape.
Handle chunked(const Hdf5Shape& shape, bool compressed) {
  Handle layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  const std::vector<hsize_t> sizes(shape.begin(), shape.end());
  checked(H5Pset_chunk(layout, static_cast<int>(sizes.size()), sizes.data()));
  if (compressed) {
    checked(H5Pset_shuffle(layout));
    checked(H5Pset_deflate(layout, level));
  }
  return layout;
}

/// Groups on the way to a new object are created.
Handle with_parents() {
  Handle creation(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  checked(H5Pset_create_intermediate_group(creation, 1));
  checked(H5Pset_char_encoding(creation, H5T_CSET_UTF8));
  return creation;
}

// ── The file ─────────────────────────────────────────────────────────────────────────────────────────────────────────

/// Files of HDF5 1.8, which every later version reads.
Handle access() {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  constexpr bool writes_to_disk = false;
  checked(H5Pset_fapl_core(access, growth, writes_to_disk));
  checked(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18));
  return access;
}

/// HDF5 distinguishes files in memory by their names.
std::string new_name() {
  static int count = 0;
  return text("memory ", ++count);
}

class File final : public Hdf5File {
public:
  File() : file_(H5Fcreate(new_name().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access()), H5Fclose) {}

  explicit File(const std::string& bytes) : file_(opened(bytes)) {}

  void make_group(const std::string& path) override {
    if (!exists(path)) Handle(H5Gcreate2(file_, path.c_str(), with_parents(), H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  }

  void write(const std::string& path, const Hdf5Shape& shape, const Hdf5Values& values) override {
    const bool compressed = !is_text(values) && product(shape) * sizeof(double) >= large;
    const Handle layout = compressed ? chunked(shape, true) : Handle(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    const Handle data(
        H5Dcreate2(file_, path.c_str(), stored_type(values), space_of(shape), with_parents(), layout, H5P_DEFAULT),
        H5Dclose);
    with_memory(values, [&](hid_t type, const void* memory) {
      checked(H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, memory));
    });
  }

  void append(const std::string& path, std::uint64_t first, const Hdf5Shape& entry, const Hdf5Values& values) override {
    const std::uint64_t count = count_of(values) / std::max(product(entry), std::uint64_t{1});
    const Handle data = exists(path) ? open(path) : make_growing(path, entry, values);
    resize(data, first + count);
    if (count == 0) return;
    const Handle all(H5Dget_space(data), H5Sclose), part = space_of(joined(count, entry));
    std::vector<hsize_t> start(entry.size() + 1, 0), size = {count};
    start[0] = first;
    size.insert(size.end(), entry.begin(), entry.end());
    checked(H5Sselect_hyperslab(all, H5S_SELECT_SET, start.data(), nullptr, size.data(), nullptr));
    with_memory(values,
                [&](hid_t type, const void* memory) { checked(H5Dwrite(data, type, part, all, H5P_DEFAULT, memory)); });
  }

  void truncate(const std::string& path, std::uint64_t entries) override {
    if (exists(path)) resize(open(path), entries);
  }

  void set(const std::string& object, const std::string& name, const Hdf5Values& values, bool is_list) override {
    const Handle owner(H5Oopen(file_, object.c_str(), H5P_DEFAULT), H5Oclose);
    if (checked(H5Aexists(owner, name.c_str())) > 0) checked(H5Adelete(owner, name.c_str()));
    const Handle space = is_list ? space_of({count_of(values)}) : Handle(H5Screate(H5S_SCALAR), H5Sclose);
    const Handle attribute(H5Acreate2(owner, name.c_str(), stored_type(values), space, H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose);
    if (count_of(values) > 0)
      with_memory(values, [&](hid_t type, const void* memory) { checked(H5Awrite(attribute, type, memory)); });
  }

  std::vector<double> numbers(const std::string& path) const override {
    if (!exists(path)) return {};
    const Handle data = open(path), space(H5Dget_space(data), H5Sclose);
    std::vector<double> values(static_cast<std::size_t>(checked(H5Sget_simple_extent_npoints(space))));
    if (!values.empty()) checked(H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
    return values;
  }

  std::vector<std::string> texts(const std::string& object, const std::string& attribute) const override {
    if (!exists(object)) return {};
    const Handle owner(H5Oopen(file_, object.c_str(), H5P_DEFAULT), H5Oclose);
    if (checked(H5Aexists(owner, attribute.c_str())) == 0) return {};
    const Handle found(H5Aopen(owner, attribute.c_str(), H5P_DEFAULT), H5Aclose), type(H5Aget_type(found), H5Tclose),
        space(H5Aget_space(found), H5Sclose);
    if (checked(H5Tis_variable_str(type)) == 0) return {};
    std::vector<char*> texts(static_cast<std::size_t>(checked(H5Sget_simple_extent_npoints(space))));
    std::vector<std::string> result;
    if (texts.empty()) return result;
    checked(H5Aread(found, text_type(), texts.data()));
    for (char* one : texts) {
      result.emplace_back(one ? one : "");
      H5free_memory(one);
    }
    return result;
  }

  /// HDF5's own memory: a copy would be as large again.
  std::string_view bytes() override {
    checked(H5Fflush(file_, H5F_SCOPE_LOCAL));
    const auto size = static_cast<std::size_t>(checked(H5Fget_file_image(file_, nullptr, 0)));
    void* memory = nullptr; // the driver's pointer to its memory
    checked(H5Fget_vfd_handle(file_, H5P_DEFAULT, &memory));
    return {*static_cast<const char**>(memory), size};
  }

private:
  static Handle opened(const std::string& bytes) {
    const Handle with_bytes = access();
    // HDF5 copies the bytes, although its argument is not const.
    checked(H5Pset_file_image(with_bytes, const_cast<char*>(bytes.data()), bytes.size()));
    return {H5Fopen(new_name().c_str(), H5F_ACC_RDWR, with_bytes), H5Fclose};
  }

  static bool is_text(const Hdf5Values& values) { return std::holds_alternative<std::vector<std::string>>(values); }

  /// True if an object exists, whose groups may be missing.
  bool exists(const std::string& path) const {
    if (path == "/") return true;
    for (std::size_t end = path.find('/', 1); end != path.npos; end = path.find('/', end + 1))
      if (checked(H5Lexists(file_, path.substr(0, end).c_str(), H5P_DEFAULT)) == 0) return false;
    return checked(H5Lexists(file_, path.c_str(), H5P_DEFAULT)) > 0;
  }

  Handle open(const std::string& path) const { return {H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose}; }

  static void resize(const Handle& data, std::uint64_t entries) {
    const Handle space(H5Dget_space(data), H5Sclose);
    std::vector<hsize_t> sizes(static_cast<std::size_t>(checked(H5Sget_simple_extent_ndims(space))));
    checked(H5Sget_simple_extent_dims(space, sizes.data(), nullptr));
    sizes[0] = entries;
    checked(H5Dset_extent(data, sizes.data()));
  }

  Handle make_growing(const std::string& path, const Hdf5Shape& entry, const Hdf5Values& values) {
    const std::uint64_t bytes = std::max(product(entry), std::uint64_t{1}) * sizeof(double);
    const bool compressed = !is_text(values) && bytes >= large;
    const std::uint64_t entries = compressed ? 1 : std::clamp(chunk / bytes, std::uint64_t{1}, chunk_entries);
    Hdf5Shape size = joined(entries, entry), none = joined(0, entry);
    for (std::uint64_t& count : size) count = std::max(count, std::uint64_t{1}); // a contact may have no points
    const Handle layout = chunked(size, compressed);
    constexpr double gap = std::numeric_limits<double>::quiet_NaN();
    if (std::holds_alternative<std::vector<double>>(values))
      checked(H5Pset_fill_value(layout, H5T_NATIVE_DOUBLE, &gap));
    std::vector<hsize_t> most(none.begin(), none.end());
    most[0] = H5S_UNLIMITED;
    return {H5Dcreate2(file_, path.c_str(), stored_type(values), space_of(none, most.data()), with_parents(), layout,
                       H5P_DEFAULT),
            H5Dclose};
  }

  Handle file_;
};

/// Errors are exceptions; HDF5 would print them as well.
void silence() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

std::string description() {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return text("HDF5 ", major, ".", minor, ".", release);
}

std::unique_ptr<Hdf5File> make() {
  silence();
  return std::make_unique<File>();
}

std::unique_ptr<Hdf5File> open(const std::string& file, const std::string& bytes) {
  silence();
  try {
    return std::make_unique<File>(bytes);
  } catch (const Error&) {
    fail("exchange.hdf5.foreign", {{"file", file}});
  }
}

} // namespace

void fail_in_hdf5() {
  std::string reason = "unknown";
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_description, &reason);
  fail("exchange.hdf5.failed", {{"reason", reason}});
}

} // namespace signorini::exchange

extern "C" const signorini::exchange::Hdf5Module signorini_hdf5 = {
    signorini::exchange::description, signorini::exchange::make, signorini::exchange::open};
