-- Help pages that belong to no function.

local core = require "signorini.core"

local scene = core.read_file(core.home .. "/lua/signorini/help/scene.lua"):gsub("%s+$", "")

local texts = {
  scene = scene,
  start = [[
signorini: isogeometric contact mechanics.
  help "labels"           discretization labels such as N2-N2.2
  help "geometry"         patches and how to make them
  help "contact"          parts of a scene and its path; also support, load, material, stage
  help "prompt"           what the prompt understands besides Lua
  help "examples"         the scene that the examples of help speak of
  help "solving"          the pages on a subject: patches, bodies, solving, results, methods, pictures, studies, scripts
  help(sg.shapes)         what a table holds
  help(sg.shapes.block)   one function: arguments, units, defaults, an example
  help "refine"           every page and script with this word
  help "gallery"          the scripts that come along: published problems, studies
Units are yours, as long as they are consistent; angles are degrees; directions and indices count from 1.]],
  prompt = [[
At the prompt:
  ?sg.body, ?refine       help on a name or a word
  2 * x                   shows what an expression gives; _ is the last such result
  Tab                     completes names, fields, methods, named arguments in name{ … }, texts and file names in quotes
  Ctrl-C                  stops a solve after its iteration: the model keeps its last accepted state, and _ is the run;
                          or forgets the line. Pressing it again never ends the prompt
  Ctrl-D, exit, quit      leaves; on a further line of a statement Ctrl-D forgets that
  traceback()             how the last error came about
A statement may go over several lines. A local variable lives for one of them only: leave out `local`. Lines are kept in
~/.local/state/signorini/history. NO_COLOR in the environment turns colors off.]],
  examples = [[
The examples speak of this scene, which can be typed or copied to the prompt:

]] .. scene,
  labels = [[
Discretization labels, values of `order` in sg.body{ … }, for the directions along the contact face:
  Np          NURBS of degree p, continuity C^(p-1)
  Np.s        Np elevated s times more: degree p + s, still C^(p-1)
  Lp          classical C0 elements of degree p; the geometry is interpolated at p equidistant parameters per span
  Nb-Nc       degree b in the bulk, degree c on the contact face's row of control points only
  Nb-Nc.s     the same, the row elevated s times more
  Nb-Nc.sxr   the same on the first r rows from the contact face, such as N2-N2.2x2 (x1 is the default)
A solid's face has two directions: one label holds for both, order = {"N2-N2.2", "N2"} gives each its own, the direction
of the lower xi first. Without a contact face a list has one label per parametric direction.
Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method (thesis, IIT Guwahati).]],
  geometry = [[
A patch is a NURBS curve, surface or volume, an immutable value.
  sg.shapes.*    ready-made patches: rectangle, half_annulus, quarter_annulus, block, …
  sg.nurbs.*     curve, surface, volume from knots and points; line, arc, circle, ruled, extrude, revolve, coons
  patch(xi)      a point; patch:face "south", patch:refine{ elements = {8, 3} } and more: help "patch"
Faces: west/east are the ends of xi1, south/north of xi2, front/back of xi3. Points run fastest in xi1.]],
}

return texts
