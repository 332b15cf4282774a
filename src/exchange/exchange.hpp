#pragma once
// Patches in files that other isogeometric programs read and write.

#include "nurbs/patch.hpp"

#include <string>
#include <vector>

namespace signorini::exchange {

using nurbs::Patch;

/// The forms of a file: "gismo" (G+Smo's XML), "geopdes" (the text file of GeoPDEs and the NURBS toolbox), "mfem" (MFEM
/// NURBS mesh v1.0 with patches).
std::vector<std::string> forms();
/// The form that a file's name stands for by its ending: .xml, .txt, .mesh; empty for any other.
std::string form_named_by(const std::string& file);

/// All patches of a file, in its order; which form it has its first characters say. Throws Error with file, line and
/// what was expected.
std::vector<Patch> read_patches(const std::string& file);

/// Writes patches to a file, whole or not at all. Their control points come back to the last bit. Throws Error when
/// there is none, or more than the form takes.
void write_patches(const std::string& file, const std::vector<Patch>& patches, const std::string& form);

} // namespace signorini::exchange
