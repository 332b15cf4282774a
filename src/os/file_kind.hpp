#pragma once
// Kinds of files that the program writes, recognized by their first bytes.

#include "base/message.hpp"

#include <string>
#include <string_view>

namespace signorini {

enum class FileKind {
  empty,
  checkpoint,
  hdf5,
  png,
  svg,
  pdf,
  mp4,
  vtk,
  html,
  gismo,
  geopdes,
  mfem,
  json,
  table,
  other
};

/// The kind of a file that begins with these bytes; empty also if all are zero, as a power failure may leave a file.
/// A table is text with lines of as many fields as the first, apart from comments, and a number, truth value or nothing
/// in one field of each line after it; or a single line of several words, its head.
FileKind kind_of(std::string_view beginning);

/// True if an output of a kind may replace a file of this name that begins with these bytes: one of the same kind, or
/// any text if the name ends as usual for this kind (.csv, .json). A program text is never replaced by text.
bool may_replace(const std::string& file, std::string_view beginning, FileKind kind);

/// "an HDF5 file"
Message name_of(FileKind kind);

} // namespace signorini
