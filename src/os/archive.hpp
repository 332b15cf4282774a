#pragma once
// Binary serialization of values: numbers bit by bit, least significant byte first, on any machine.
//
// A type is written by a free function write(ArchiveWriter&, const T&) and read by T read(ArchiveReader&,
// std::type_identity<T>), both in the type's namespace. This header has them for numbers, strings, lists and matrices,
// and for structs that are written member by member: a function members(T&) in the struct's namespace returns a tie of
// these.

#include "base/eigen.hpp"
#include "base/error.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

namespace signorini {

/// Collects bytes.
class ArchiveWriter {
public:
  template <class... T> void put(const T&... values) { (write(*this, values), ...); }
  /// Writes what `fill(ArchiveWriter&)` writes, preceded by its name and length.
  template <class Fill> void section(const std::string& name, const Fill& fill) {
    ArchiveWriter inside;
    fill(inside);
    put(name, inside.bytes_);
  }
  void append(const char* bytes, std::size_t count) { bytes_.append(bytes, count); }
  const std::string& bytes() const { return bytes_; }

private:
  std::string bytes_;
};

/// What a reader requires of values besides their form.
struct ArchiveLimits {
  bool finite = false; ///< numbers are neither nan nor infinite
  /// Most elements of a body: a few bytes can describe any number of them, those of a damaged file more than fit in
  /// memory.
  std::size_t elements = std::numeric_limits<std::size_t>::max();
};

/// Reads values from bytes that it does not own. Throws Error instead of reading beyond their end.
class ArchiveReader {
public:
  explicit ArchiveReader(std::string_view bytes, ArchiveLimits limits = {}) : rest_(bytes), limits_(limits) {}

  template <class T> T get() { return read(*this, std::type_identity<T>()); }
  template <class... T> void into(T&... values) { ((values = get<T>()), ...); }
  /// The bytes of a section. Throws Error if the next section has another name.
  std::string_view section(const std::string& name);
  std::string_view take(std::size_t count);
  /// Number of elements that follow, each of at least one byte.
  std::size_t count();
  std::size_t remaining() const { return rest_.size(); }
  const ArchiveLimits& limits() const { return limits_; }

private:
  std::string_view rest_;
  ArchiveLimits limits_;
};

template <class T>
concept Plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

template <Plain T> void write(ArchiveWriter& to, T value) {
  auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
  to.append(bytes.data(), bytes.size());
}
template <class T>
requires std::is_arithmetic_v<T> T read(ArchiveReader& from, std::type_identity<T>) {
  std::array<char, sizeof(T)> bytes{};
  const std::string_view taken = from.take(sizeof(T));
  std::copy(taken.begin(), taken.end(), bytes.begin());
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
  if constexpr (std::is_same_v<T, bool>) {
    return bytes[0] != 0;
  } else {
    const T value = std::bit_cast<T>(bytes);
    if constexpr (std::is_floating_point_v<T>)
      require(!from.limits().finite || std::isfinite(value), "os.archive.finite", {{"value", value}});
    return value;
  }
}

/// The values of an enumeration are 0 … last_value(std::type_identity<T>()), a function in its namespace.
template <class T>
requires std::is_enum_v<T> T read(ArchiveReader& from, std::type_identity<T>) {
  const auto number = static_cast<long>(from.get<std::underlying_type_t<T>>());
  const auto last = static_cast<long>(last_value(std::type_identity<T>()));
  require(number >= 0 && number <= last, "os.archive.enumeration", {{"number", number}, {"last", last}});
  return static_cast<T>(number);
}

inline void write(ArchiveWriter& to, const std::string& value) {
  to.put(static_cast<std::uint64_t>(value.size()));
  to.append(value.data(), value.size());
}
inline std::string read(ArchiveReader& from, std::type_identity<std::string>) {
  return std::string(from.take(from.count()));
}

template <class T> void write(ArchiveWriter& to, const std::vector<T>& values) {
  to.put(static_cast<std::uint64_t>(values.size()));
  for (const auto& value : values) to.put(value);
}
template <class T> std::vector<T> read(ArchiveReader& from, std::type_identity<std::vector<T>>) {
  const std::size_t count = from.count();
  std::vector<T> values;
  values.reserve(std::min(count, from.remaining() / sizeof(T))); // a damaged file must not take memory
  for (std::size_t i = 0; i < count; ++i) values.push_back(from.get<T>());
  return values;
}

template <class T, std::size_t N> void write(ArchiveWriter& to, const std::array<T, N>& values) {
  for (const T& value : values) to.put(value);
}
template <class T, std::size_t N> std::array<T, N> read(ArchiveReader& from, std::type_identity<std::array<T, N>>) {
  std::array<T, N> values;
  for (T& value : values) value = from.get<T>();
  return values;
}

/// A flag comes first: true if there is a value.
template <class T> void write(ArchiveWriter& to, const std::optional<T>& value) {
  to.put(value.has_value());
  if (value) to.put(*value);
}
template <class T> std::optional<T> read(ArchiveReader& from, std::type_identity<std::optional<T>>) {
  return from.get<bool>() ? std::optional<T>(from.get<T>()) : std::nullopt;
}

/// The numbers of rows and columns come first.
template <int Rows, int Columns> void write(ArchiveWriter& to, const Eigen::Matrix<double, Rows, Columns>& matrix) {
  to.put(static_cast<std::uint64_t>(matrix.rows()), static_cast<std::uint64_t>(matrix.cols()));
  for (Eigen::Index i = 0; i < matrix.size(); ++i) to.put(matrix.data()[i]);
}
template <int Rows, int Columns>
auto read(ArchiveReader& from, std::type_identity<Eigen::Matrix<double, Rows, Columns>>) {
  const auto rows = from.get<std::uint64_t>(), columns = from.get<std::uint64_t>();
  constexpr auto fits = [](int fixed, std::uint64_t size) {
    return fixed == Eigen::Dynamic || static_cast<std::uint64_t>(fixed) == size;
  };
  require(fits(Rows, rows) && fits(Columns, columns), "os.archive.matrix",
          {{"rows", rows}, {"columns", columns}, {"expected_rows", Rows}, {"expected_columns", Columns}});
  constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<int>::max()); // also of rows without columns
  require(rows <= most && columns <= most && rows * columns <= from.remaining() / sizeof(double),
          "os.archive.matrix_cut_off", {{"rows", rows}, {"columns", columns}});
  Eigen::Matrix<double, Rows, Columns> matrix(static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns));
  for (Eigen::Index i = 0; i < matrix.size(); ++i) matrix.data()[i] = from.get<double>();
  return matrix;
}

template <class T>
concept Record = requires(T& record) {
  members(record);
};

template <Record T> void write(ArchiveWriter& to, const T& record) {
  std::apply([&](const auto&... parts) { to.put(parts...); }, members(const_cast<T&>(record)));
}
template <Record T> T read(ArchiveReader& from, std::type_identity<T>) {
  T record{};
  std::apply([&](auto&... parts) { from.into(parts...); }, members(record));
  return record;
}

/// A type of file: a line that names the type, the version of its format, length, bytes, and a checksum of all.
struct ArchiveKind {
  std::string name;      ///< "checkpoint"
  std::uint32_t version; ///< of files that are written
  std::uint32_t oldest;  ///< version that is read
};

/// Bytes of a file of an archive and the version of its format.
struct ArchiveBytes {
  std::string bytes;
  std::uint32_t version;
};

/// Writes the file atomically and removes temporary files left by killed processes. `durable`: the file is on the disk
/// on return. Throws Error if it cannot be written.
void write_archive(const std::string& file, const ArchiveKind& kind, const ArchiveWriter& archive, bool durable = true);

/// The bytes of a file for an ArchiveReader. Throws Error if the file is of another type, of an older version than the
/// oldest or of a newer one, or damaged.
ArchiveBytes read_archive(const std::string& file, const ArchiveKind& kind);

/// FNV-1a, 64 bits: changing any one byte changes it.
std::uint64_t checksum(std::string_view bytes);

} // namespace signorini
