-- Pages: pictures of states and patches, sheets, films.

local core = require "signorini.core"
local lists = require "signorini.call.lists"
local filter, merged = lists.filter, lists.merged
local patch_types = require "signorini.call.patch_types"
local t = require "signorini.call.types"
local chart_rows = require "signorini.pages.chart_rows"

local axes = t.choice { "x", "y", "z", "-x", "-y", "-z" }
local field, field_name, body_name = t.name(core.fields), t.name(core.fields, "name"), t.name(nil, "name")
local largest = 5000 -- pixels

local size = t.either(t.integer(160, largest), t.list(t.integer(120, largest), 2))
local file = chart_rows.file

local function of_models(row) return merged(row, { excludes = { "patch", why = "it is for models" } }) end

local cut = t.either(axes, t.worded(t.named {
  { "normal", t.either(axes, t.space_point), "direction of the removed half" },
  { "at", t.number, "coordinate of the plane, if normal is an axis",
    otherwise = "the middle of the bodies", unit = "length" },
  { "point", t.space_point, "a point of the plane", otherwise = "the middle of the bodies", unit = "length" },
}, "a table { normal = …, at or point = … }"))

local camera = t.either(t.choice(core.cameras), t.worded(t.named {
  { "from", t.space_point, "direction from the model to the eye" },
  { "up", t.space_point, "upward direction in the picture", otherwise = "z; y if seen along z" },
}, "a table { from = …, up = … }"))

local mark = t.named {
  { "x", t.point, "place in the current state", unit = "length" },
  { "text", t.text, "short text next to it", default = "" },
}
for _, key in ipairs { "kind", "body", "element", "point", "contact", "X", "value" } do -- the rest of run.places
  table.insert(mark.rows, { key, t.any, optional = true, hidden = true })
end
mark = t.worded(mark, "a mark { x = {…}, text = … }", "marks { x = {…}, text = … }")

local levels = t.worded(t.list(t.number, nil, 1), "a list of at least one value")
local contours = t.either(t.only(true), t.integer(1, 100), levels)

local function paper(most)
  return { "size", size, [[{width, height}, exactly; or the largest width: the height is as needed, at most twice the
width]], otherwise = "at most " .. most, unit = "pixels" },
    { "scale", t.positive, "multiplies the size, including text and lines", default = 1 },
    { "transparent", t.flag, "transparent background; not in films", default = false }
end
local size_alone, scale, transparent = paper "1600 x 1000, for several states or fields 1600 x 2000"

local columns = { "columns", t.integer(1, 100), "pictures in a row", otherwise = "chosen for the largest pictures" }
local fps = { "fps", t.positive, "frames per second of a film", default = 10 }

--- The rows of sg.picture for model:show and others: without the keys of a string of words, and what refers to them.
local function rows_without(all, words)
  local left_out = {}
  for key in words:gmatch "%S+" do left_out[key] = true end
  local function others(keys)
    local kept = filter(keys or {}, function(key) return not left_out[key] end)
    kept.why = keys and keys.why
    return #kept > 0 and kept or nil
  end
  local rows = {}
  for _, row in ipairs(all) do
    if type(row) == "string" then
      if type(rows[#rows]) == "string" then rows[#rows] = nil end -- a heading without rows
      rows[#rows + 1] = row
    elseif not left_out[row[1]] then
      local kept = merged(row)
      kept.needs, kept.excludes = others(row.needs), others(row.excludes)
      rows[#rows + 1] = kept
    end
  end
  return rows
end

local entries = { "pictures", t.either(t.object "picture", t.list(t.object "picture")),
                  "pictures, or lists of them, in order" }

local list = {
  title = "Pictures and charts", word = "pictures",
  { "sg.picture", [[Returns a picture of a model's current state, of a state stored by a run, or of patches, and writes
it to `file` if given. Later changes of the model do not affect the picture. Most used: model, field,
range, cut, crop, file.]],
    named = {
      "Contents, one of these, or states below:",
      { "model", t.object "model", "shows its current state", optional = true },
      { "state", t.object "state", "an entry of run:states()", optional = true, excludes = { "states", "patch" } },
      { "patch", patch_types.one_or_several,
        "patches in gray, all in the plane or all in 3D", optional = true, excludes = { "model" } },
      "Several states or fields:",
      of_models { "states", t.list(t.object "state", nil, 1), [[run:states(): one picture each, as in sg.sheet; or,
depending on the file's name ("x-%04d.png", "x.mp4"), as in sg.film]], optional = true },
      { "fields", t.list(field_name, nil, 1), "fields side by side, each with its own color bar, as in sg.sheet",
        optional = true, excludes = { "field", "patch", why = "it replaces it" } },
      merged(columns, { needs = { "states", "fields" } }), merged(fps, { needs = { "states" } }),
      "Colors:",
      of_models { "field", field, [[displacements ux uy u (length); Cauchy stresses (force per area) sxx syy szz sxy,
von_mises, pressure (-tr sigma/3), I1 (tr sigma: the first invariant of the stress, not of C); deformation gradient (no
unit) F11 F12 F21 F22 F33; for solids also uz sxz syz F13 … F32; contact_pressure (force per current area) on slave
faces, damage (of bonds, 0 to 1) on those of cohesive contacts, mu (coefficient of friction) and slip (since the touch,
a length) on those of contacts with friction or wear, worn (depth, a length) on those with wear, in the plane as a band
along them; where they do not exist bodies are gray. Stresses are evaluated at the points drawn, neither extrapolated
nor averaged, so that jumps between elements are visible]], otherwise = "gray" },
      { "factor", t.number, "multiplies the field", default = 1, needs = { "field", "fields" } },
      { "label", t.text, "title of the color bar", otherwise = "the field's name with its factor",
        needs = { "field" }, excludes = { "fields", why = "each of which has its own color bar" } },
      { "range", t.interval, "lowest and highest value of the colors, in the unit of the field times factor",
        otherwise = "that of the values, without the lowest and highest ones, up to 0.5 % of the points drawn" },
      { "contours", contours, [[contour lines: true: at the ticks of the color bar; a number: so many levels within the
range; or a list of levels]], otherwise = "none", needs = { "field", "fields" } },
      { "bar", t.flag, "color bar of the range, with the field's extremes at its ends", default = true },
      { "colormap", t.choice(core.colormaps), "'coolwarm' suits values of both signs", default = "viridis" },
      "Parts drawn:",
      of_models { "bodies", t.list(body_name, nil, 1), "names of the bodies", otherwise = "all" },
      of_models { "gray", t.list(body_name, nil, 1), "bodies without the field, such as stiff ones",
                  otherwise = "none", needs = { "field", "fields" } },
      of_models { "deformed", t.flag, "current shape; false: reference shape", default = true },
      of_models { "undeformed", t.flag, "also the reference shape, dashed, in 3D also translucent", default = false },
      of_models { "mode", t.object "mode", [[an entry of model:modes, by which the state is displaced; fields are those
of the displaced state]], optional = true },
      of_models { "amplitude", t.number, "longest displacement of a control point by the mode", unit = "length",
                  otherwise = "a tenth of the size of the bodies", needs = { "mode" } },
      { "mesh", t.flag, "element boundaries", default = true },
      { "control_points", t.flag, "control points and control net", default = false },
      of_models { "vectors", t.choice { "displacement", "traction" }, [[arrows: displacements at points of a grid, or
tractions (force per current area, mortar: reference area) at the contact points of slave faces, with a scale below the
picture]], otherwise = "none" },
      of_models { "obstacles", t.flag, "rigid obstacles", default = true },
      of_models { "mirror", t.choice { "x", "y", "z", "xy", "xz", "yz", "xyz" },
        [[adds the mirror image about the plane x = 0, y = 0 or z = 0 (solids), for "xy" about both; of a body that
crosses the plane the larger part is mirrored]], otherwise = "none" },
      of_models { "cut", cut, [[Solids: the half to remove. "y": larger y, "-y": smaller y, cut through the middle of
the bodies. The cut face shows the field]], otherwise = "no cut" },
      { "marks", t.list(mark), "rings at places, such as run.places; the first ones have priority where space is short",
        optional = true },
      { "names", t.flag, "patches: names of faces, ξ¹ ξ² ξ³ along the directions, numbers of several patches",
        default = true, needs = { "patch" } },
      "Layout and file:",
      { "title", t.text, "title above the picture", otherwise = "that of a stored state" },
      { "crop", t.numbers(), [[{xmin, xmax, ymin, ymax}: shows only this part; in 3D with zmin, zmax: the rectangle
around this box as seen, with everything in front of and behind it]], otherwise = "all", unit = "length" },
      { "inset", t.numbers(), "part in the same form, magnified in a box within the picture",
        otherwise = "none", unit = "length" },
      { "camera", camera, [[Solids: the direction from which they are seen in parallel projection. "iso": from the
front, the right and above; "front": from -y, z upwards; "left": from -x; "top": from +z, y upwards. These
are directions of view, not names of faces]],
        otherwise = '"iso", with a cut from the side on which the cut face is seen' },
      { "unit", t.text, 'unit of length such as "mm", shown at the axes and the ruler', otherwise = "none" },
      { "axes", t.list(t.text), [[names of the axes, one per direction: {"r in mm", "z in mm"}]],
        otherwise = "x, y and z, with unit" },
      { "ruler", t.flag, "solids: a scale bar below the picture", otherwise = "true" },
      size_alone, scale, transparent, file,
    },
    more = [[In .svg and .pdf, lines and texts are vectors, fields and surfaces are images. Surfaces of solids are
slightly shaded, gray ones more: those that face the light have the colors of the bar.]],
    returns = t.object "picture", example = {
      [[sg.picture{ model = model, field = "uy", file = "die.png" }]],
      [[sg.picture{ model = model, field = "syy", contours = true, mesh = false, file = "levels.png" }]],
      [[sg.picture{ model = model, vectors = "displacement", axes = {"r in mm", "z in mm"}, file = "arrows.png" }]],
      [[sg.picture{ patch = sg.shapes.block{ size = {2, 1, 1} }, control_points = true, file = "patch.png" }]],
      [[sg.picture{ model = model, field = "syy", inset = {0.6, 0.9, 0.85, 1}, file = "close.png" }]],
      [[sg.picture{ states = run:states(), fields = {"ux", "uy"}, file = "press-%04d.png" }]],
      [[sg.picture{ model = solid, field = "szz", cut = "-y", camera = { from = {1, -2, 1} }, file = "cut.png" }]],
    } },
  { "sg.sheet", [[Returns several pictures as one, and writes it to `file` if given. States of one field with the same
camera, crop, inset, unit, contours and vectors share axes, scale and color bar; all others are placed side by side,
each with its own. Charts and sheets may be among them. Titles of pictures are shown above them; their sizes are
ignored.]], entries = entries,
    named = {
      columns,
      { "title", t.text, "title above the sheet", optional = true },
      { "range", t.either(t.choice { "shared", "own" }, t.interval), [["shared": pictures with the same title of the
color bar share a range of colors; "own": each has its own range and bar; {low, high}: range of
all]], default = "shared" },
      (paper "1600 x 2000"), scale, transparent, file,
    },
    returns = t.object "picture", example = {
      [[local pictures = {}
model:run(stages, { on_step = function(info)
  if info.step % 2 == 0 then pictures[#pictures + 1] = sg.picture{ model = model, field = "uy" } end
end })
sg.sheet{ pictures, columns = 2, file = "states.png" }]],
      [[local whole = sg.picture{ model = solid, field = "szz" }
local cut = sg.picture{ model = solid, field = "szz", cut = "-y" }
sg.sheet{ whole, cut, title = "Vertical stress", file = "pair.png" }]],
    } },
  { "sg.film", [[Writes pictures one after the other, as a film or to numbered files. All have the same scale, layout
and range of colors, unless given otherwise. They must have the same contents and arrangement.]],
    entries = entries,
    named = {
      { "file", t.text, [["x.mp4" (H.264, needs the program ffmpeg), or "x-%04d.png", .svg, .pdf: files
numbered from 1]] },
      fps,
      { "size", size, "as in sg.picture", otherwise = "that of the first picture", unit = "pixels" },
      scale, transparent,
    },
    example = [[local pictures = {}
for i, state in ipairs(run:states()) do pictures[i] = sg.picture{ state = state, field = "uy", size = 800 } end
sg.film{ pictures, file = "press-%02d.png" }]] },
  { "picture", [[The result of sg.picture, sg.sheet, sg.chart and sg.heatmap: a complete figure, independent of the
model. picture:write writes it; sg.sheet and sg.film combine it with others.]],
    example = [[print(sg.picture{ model = model, field = "uy" })]] },
  { "picture:write", "Writes the picture to a file, atomically.",
    arguments = { { "file", t.text, "file name that ends with .png, .svg or .pdf" } },
    example = [[sg.picture{ model = model, field = "uy" }:write "die.pdf"]] },
}

local picture = list[1].named
return lists.merged(list, lists.joined(list, {
  { "picture:show", [[Shows the picture in the terminal, in the size of the window. It is an error if the output is not
a terminal and the picture was made without `file`. At the prompt, a picture without `file` that is the result of a line
is shown as well. The option --pictures chooses how.]],
    example = [[sg.chart{ file = "square.png", x = {1, 2, 3}, { y = {1, 4, 9} } }:show()]] },
  { "model:show", [[Shows the model's current state in the terminal, as sg.picture draws it, and writes it to `file` if
given. Without a terminal `file` is needed.]],
    named = rows_without(picture, "model state patch states fps names"), head = "model:show{ … }",
    may_be_empty = true, as_given = true,
    example = [[model:show{ field = "uy", file = "die.png" }]] },
  { "state:show", "Shows a state stored by a run in the terminal, and writes it to `file` if given: as model:show.",
    named = "model:show", may_be_empty = true, as_given = true,
    example = [[run:states()[2]:show{ field = "uy", file = "state.png" }]] },
  { "patch:show", [[Shows a patch in the terminal, as sg.picture draws it, and writes it to `file` if given. Without a
terminal `file` is needed.]],
    named = rows_without(picture, [[model state mode amplitude patch states fields columns fps field factor label range
contours bar colormap bodies deformed undeformed vectors obstacles mirror cut]]), head = "patch:show{ … }",
    may_be_empty = true, as_given = true,
    example = [[patch:show{ control_points = true, file = "patch.png" }]] },
}))
