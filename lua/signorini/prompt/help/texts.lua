-- Help pages on subjects.

local core = require "signorini.core"

local scene = core.read_file(core.home .. "/lua/signorini/prompt/help/scene.lua"):gsub("%s+$", "")

local texts = {
  scene = scene,
  start = [[
signorini: isogeometric contact mechanics.
  sg.scenes.ironing{}     a scene to begin with: m, path = sg.scenes.ironing{}; m:run(path); help "scenes" lists more
  help "orders"           order labels of discretizations such as N2-N2.2
  help "geometry"         patches and how to make them
  help "units"            consistent units; also quasi-static
  help "contact"          parts of a scene and its path; also support, load, material, stage
  help "prompt"           commands and keys of the prompt; also notebook
  help "examples"         the scene used by the examples of help
  help "solving"          a subject: patches, bodies, solving, results, methods, scenes, pictures, studies, scripts
  help(sg.shapes)         the functions in a table
  help(sg.shapes.block)   one function: arguments, units, defaults, an example
  help "refine"           all pages and scripts with a word, also for terms of other programs: help "boundary condition"
  help "gallery"          supplied scripts: published problems, studies
Any consistent units can be used; angles are in degrees; directions and indices count from 1.]],
  prompt = [[
At the prompt:
  ?sg.body, sg.body?      help on a name, a word, a variable, a field (?run.failed) or an argument (?sg.body.order)
  2 * x                   shows the value of an expression; _ is the last such value
  %time code              runs an expression or a statement and shows its wall-clock time and processor time
  %who                    lists the variables with their types
  %run file arguments     runs a script as from the command line, in a fresh state: it sees no variables of the prompt,
                          and modules next to it are read again. Then its global variables (not its local ones) are
                          those of the prompt, too, and _ is the first value that it returned
  !command                runs a command of the shell
  %help                   lists these commands
  Tab                     completes names, fields, methods, named arguments in name{ … }, texts and file names in quotes
                          and after %run and !
  Up, Down                return earlier statements, whole if they have several lines; inside such a block they move
                          from line to line (Ctrl-P, Ctrl-N: always to another statement). Enter runs the block
  Ctrl-C                  stops a solve after the current iteration: the model keeps its last accepted state, and _ is
                          the run; otherwise discards the statement, which Up returns. It does not end the prompt
  Ctrl-D, exit, quit      ends the prompt; within an unfinished statement, Ctrl-D discards the statement
  traceback()             shows the traceback of the last error
A statement may extend over several lines. Local variables are lost after their line: omit `local`. The history is saved
in ~/.local/state/signorini/history. NO_COLOR in the environment turns colors off. sg.scenes has models to begin with:
m, path = sg.scenes.ironing{}; m:run(path).]],
  notebook = [[
Notebooks: signorini --install-kernel makes this program a kernel of Jupyter, which then offers "Signorini" notebooks.
  the last expression     of a cell is shown; _ is the last such value
  pictures, charts        appear below the cell if they are its last value
  Tab, Shift-Tab          complete names and arguments, show the help page at the cursor
  interrupt               stops a run after the current iteration; _ is the run so far
  local x                 belongs to its cell; omit `local` for variables of the notebook
See share/doc/use/notebook.md.]],
  examples = [[
The examples use this scene, which can be typed or copied to the prompt:

]] .. scene,
  orders = [[
Order labels of discretizations, values of `order` in sg.body{ … }, for the directions along the contact face:
  Np          NURBS of degree p, continuity C^(p-1)
  Np.s        Np, then degree-elevated s times: degree p + s, still C^(p-1)
  Lp          Lagrange elements of degree p, C0; the geometry is interpolated at p equidistant parameters per element
  Nb-Nc       degree b in the bulk; the row of control points on the contact face k-refined to degree c
  Nb-Nc.s     the same, that row then degree-elevated s times
  Nb-Nc.sxr   the same for the first r rows from the contact face, such as N2-N2.2x2 (default: x1)
The face of a solid has two directions: one label applies to both; order = {"N2-N2.2", "N2"} gives one for each, the
direction of the lower xi first. Without a contact face, a list has one label per parametric direction.
`layer` of sg.body limits the layer to a part of the face, `layer_knots` adds knots to the contact rows only.
Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method (thesis, IIT Guwahati).]],
  units = [[
The program has no units: use consistent ones, in which force = stress x length². All results are in the same units.
  length   force   stress, E   penalty of a contact      energy   density of a body load
  mm       N       MPa         N/mm³ = MPa/mm            N mm     N/mm³
  m        N       Pa          N/m³                      J        N/m³
  nm       nN      GPa         nN/nm³                    nN nm    nN/nm³
In plane strain and plane stress forces, energies and stiffnesses are per unit of thickness; axisymmetric forces are
those of the whole circumference. Angles are in degrees. By default a penalty is 30 E/h, E of the softer body, h the
size of the slave's elements. `units` of sg.study and sg.table only label columns.]],
  ["quasi-static"] = [[
Solutions are quasi-static: sequences of equilibrium states without inertia. A stage is a part of the load path, and its
steps are increments of displacements and loads; the path matters with friction and bonds. Time occurs only where mu of
a contact depends on the slip rate, and in viscoelastic materials: stages then have a duration. Impact and waves are not
available. Where a path snaps through, no equilibrium near the last one exists: arc_length = true of
model:run follows the path through limit points, pseudo_transient = true jumps to the next stable state with an
artificial viscosity.]],
  geometry = [[
A patch is a NURBS curve, surface or volume, an immutable value.
  sg.shapes.*    ready-made patches: rectangle, half_annulus, quarter_annulus, block, …
  sg.nurbs.*     curve, surface, volume from knots and points; line, arc, circle, ruled, extrude, revolve, coons
  patch(xi)      a point; patch:face "south", patch:refine{ elements = {8, 3} } and more: help "patch"
Faces: west/east are the ends of xi1, south/north of xi2, front/back of xi3. Points run fastest in xi1.]],
}

return texts
