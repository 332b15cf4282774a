#pragma once
// Reading and writing of patches in files of other isogeometric programs.

#include "nurbs/patch.hpp"

#include <string>
#include <vector>

namespace signorini::exchange {

using nurbs::Patch;

/// Supported formats: "gismo" (G+Smo's XML), "geopdes" (text file of GeoPDEs and the NURBS toolbox), "mfem" (MFEM NURBS
/// mesh v1.0 with patches).
std::vector<std::string> forms();
/// The format of a file name by its extension: .xml, .txt, .mesh; empty for any other.
std::string form_named_by(const std::string& file);

/// All patches of a file, in its order; the format is recognized from its first characters. Throws Error with file,
/// line and what was expected.
std::vector<Patch> read_patches(const std::string& file);

/// Writes patches to a file atomically, control points without loss of bits. Throws Error if there are none, or more
/// than the format supports.
void write_patches(const std::string& file, const std::vector<Patch>& patches, const std::string& form);

} // namespace signorini::exchange
