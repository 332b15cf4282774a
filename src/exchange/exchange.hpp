#pragma once
// Reading and writing of patches in files of other isogeometric programs.

#include "nurbs/patch.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace signorini::exchange {

using nurbs::Patch;

/// A face of one of several patches.
struct PatchFace {
  int patch; ///< from 0
  nurbs::Side side;
  bool operator==(const PatchFace&) const = default;
};

/// Two faces on each other.
using Interface = std::array<PatchFace, 2>;

/// Faces that make up a named part of the surface.
struct Boundary {
  std::string name;
  std::vector<PatchFace> faces;
};

struct Geometry {
  std::vector<Patch> patches;
  /// Empty if the file does not list any, so that those faces touch that coincide.
  std::optional<std::vector<Interface>> interfaces = {};
  std::vector<Boundary> boundaries = {};
};

/// Supported formats: "gismo" (G+Smo's XML), "geopdes" (text file of GeoPDEs and the NURBS toolbox), "mfem" (MFEM NURBS
/// mesh v1.0 with patches).
std::vector<std::string> forms();
/// The format of a file name by its extension: .xml, .txt, .mesh; empty for any other.
std::string form_named_by(const std::string& file);

/// All patches of a file, in its order, with interfaces and boundaries as far as the file has them; the format is
/// recognized from its first characters. Throws Error with file, line and what was expected.
Geometry read_geometry(const std::string& file);

/// Writes patches to a file atomically, control points without loss of bits. Interfaces that the geometry does not list
/// are found. Throws Error if there are no patches, or if the format does not support them.
void write_geometry(const std::string& file, const Geometry& geometry, const std::string& form);

} // namespace signorini::exchange
