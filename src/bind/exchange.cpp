// sg.nurbs.read, sg.nurbs.write and patch:write: patches in files of other programs.

#include "exchange/exchange.hpp"

#include "bind/functions.hpp"
#include "bind/open.hpp"
#include "bind/patch.hpp"

namespace signorini::bind {

using nurbs::Patch;

namespace {

int read(lua_State* L) {
  const auto patches = exchange::read_patches(read_string(L, 1, {"file", "a file of patches"}));
  lua_createtable(L, static_cast<int>(patches.size()), 0);
  for (std::size_t i = 0; i < patches.size(); ++i) {
    push_object(L, patches[i]);
    lua_rawseti(L, -2, static_cast<lua_Integer>(i) + 1);
  }
  return 1;
}

/// Writes to the file at one index of the stack, in the form at the next one that is given, else by the file's ending.
int write_to(lua_State* L, int file_index, int form_index, const std::vector<Patch>& patches) {
  const Argument file_argument{"file", "where the patches go"};
  const std::string file = read_string(L, file_index, file_argument);
  const std::string form = lua_isnoneornil(L, form_index)
                               ? exchange::form_named_by(file)
                               : read_choice(L, form_index, {"form", "of the file"}, exchange::forms());
  if (form.empty())
    reject(L, file_index, file_argument, "a name that ends with .xml, .txt or .mesh",
           "or say the form as well: " + one_of(exchange::forms()));
  exchange::write_patches(file, patches, form);
  return 0;
}

int write_patches(lua_State* L) {
  std::vector<Patch> patches;
  const Argument argument{"patches", "what is written"};
  if (const Patch* one = test_object<Patch>(L, 2)) {
    patches = {*one};
  } else {
    const int count = read_list(L, 2, argument, "a patch or a list of patches");
    if (count == 0) reject(L, 2, argument, "a list of at least one patch");
    for (int i = 1; i <= count; ++i) {
      lua_rawgeti(L, 2, i);
      patches.push_back(read_object<Patch>(L, -1, {text("patches[", i, "]"), "what is written"}));
      lua_pop(L, 1);
    }
  }
  return write_to(L, 1, 3, patches);
}

constexpr Function exchange_entries[] = {
    {"read", read,
     "sg.nurbs.read(file)\n"
     "All patches of a file, as a list in the file's order. Which form it has is seen by how it begins:\n"
     "  G+Smo's XML: geometries BSpline, Nurbs, TensorBSpline2 and 3, TensorNurbs2 and 3\n"
     "  the text file of GeoPDEs and the NURBS toolbox, versions 0.7, 1.0 and 2.1, one or several patches\n"
     "  MFEM NURBS mesh v1.0 with a section `patches`\n"
     "How patches meet, and boundaries, are not read. Wrong files are errors that name file and line.\n"
     "Example: sg.shapes.half_annulus{ inner = 1, outer = 2 }:write \"bracket.xml\"\n"
     "         bracket = sg.nurbs.read(\"bracket.xml\")[1]"},
    {"write", write_patches,
     "sg.nurbs.write(file, patches, form)\n"
     "Writes a patch or a list of patches, whole or not at all. form: \"gismo\" (G+Smo's XML), \"geopdes\" (text "
     "file,\n"
     "version 2.1, without interfaces), \"mfem\" (NURBS mesh v1.0, one patch; the attributes of its sides are west 1,\n"
     "east 2, south 3, north 4, front 5, back 6); by default what the file's ending says: .xml, .txt, .mesh.\n"
     "Knots, weights and control points come back to the last bit.\n"
     "Example: sg.nurbs.write(\"annulus.txt\", sg.shapes.half_annulus{ inner = 1, outer = 2 })"},
};

} // namespace

int write_patch(lua_State* L) {
  return write_to(L, 2, 3, {self<Patch>(L)});
}

void open_exchange(lua_State* L) {
  register_functions(L, "sg.nurbs", exchange_entries);
}

} // namespace signorini::bind
