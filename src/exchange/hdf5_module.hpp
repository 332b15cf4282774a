#pragma once
// The interface of signorini_hdf5.so, the only part of the program that is linked with HDF5. It stores arrays under
// paths; which ones a run has is decided in lua/signorini/output/hdf5.lua.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace signorini::exchange {

/// Numbers, whole numbers or UTF-8 texts, the last index of an array running fastest.
using Hdf5Values = std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::string>>;
using Hdf5Shape = std::vector<std::uint64_t>;

/// A file of HDF5 in memory. Paths begin with "/"; groups on the way to an array are created.
class Hdf5File {
public:
  virtual ~Hdf5File() = default;
  virtual void make_group(const std::string& path) = 0;
  /// Writes an array.
  virtual void write(const std::string& path, const Hdf5Shape& shape, const Hdf5Values& values) = 0;
  /// Writes entries of this shape from number `first` on into an array that grows along its first index; entries that
  /// were left out are nan, 0 or "".
  virtual void append(const std::string& path, std::uint64_t first, const Hdf5Shape& entry,
                      const Hdf5Values& values) = 0;
  /// Reduces an array that grows to its first entries.
  virtual void truncate(const std::string& path, std::uint64_t entries) = 0;
  /// Sets an attribute of a group or an array: a list, or a single value.
  virtual void set(const std::string& object, const std::string& name, const Hdf5Values& values, bool is_list) = 0;
  /// The numbers of an array; none if it does not exist.
  virtual std::vector<double> numbers(const std::string& path) const = 0;
  /// The texts of an attribute; none if it or its object does not exist.
  virtual std::vector<std::string> texts(const std::string& object, const std::string& attribute) const = 0;
  /// The contents of the file on a disk, until the next change.
  virtual std::string_view bytes() = 0;
};

/// What the module exports as `signorini_hdf5`. Functions throw Error.
struct Hdf5Module {
  std::string (*description)();
  std::unique_ptr<Hdf5File> (*make)();
  /// From the contents of a file on a disk; `file`: its name in messages.
  std::unique_ptr<Hdf5File> (*open)(const std::string& file, const std::string& bytes);
};

} // namespace signorini::exchange
