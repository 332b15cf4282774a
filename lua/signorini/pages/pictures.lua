-- Pages: pictures of states and patches, sheets, films.

local core = require "signorini.core"
local merged = require("signorini.lists").merged
local t = require "signorini.types"
local chart_rows = require "signorini.pages.chart_rows"

local axes = t.choice { "x", "y", "z", "-x", "-y", "-z" }
local field, field_name, body_name = t.name(core.fields), t.name(core.fields, "name"), t.name(nil, "name")
local largest = 5000 -- pixels, OpenGL's limit

local size = t.either(t.integer(160, largest), t.list(t.integer(120, largest), 2))
local file = chart_rows.file

local function of_models(row) return merged(row, { excludes = { "patch", why = "it is for models" } }) end

local cut = t.either(axes, t.worded(t.named {
  { "normal", t.either(axes, t.space_point), "points to the half that is taken away" },
  { "at", t.number, "where the plane meets the normal's axis; with an axis as normal",
    otherwise = "the middle of the bodies", unit = "length" },
  { "point", t.space_point, "a point of the plane", otherwise = "the middle of the bodies", unit = "length" },
}, "a table { normal = …, at or point = … }"))

local camera = t.either(t.choice(core.cameras), t.worded(t.named {
  { "from", t.space_point, "direction from the model to the eye" },
  { "up", t.space_point, "direction that points upwards in the picture", otherwise = "z, seen along it y" },
}, "a table { from = …, up = … }"))

local mark = t.named {
  { "x", t.point, "place in the present state", unit = "length" },
  { "text", t.text, "a few words next to it", default = "" },
}
for _, key in ipairs { "kind", "body", "element", "point", "contact", "X", "value" } do -- the rest of run.places
  table.insert(mark.rows, { key, t.any, optional = true, hidden = true })
end
mark = t.worded(mark, "a mark { x = {…}, text = … }", "marks { x = {…}, text = … }")

local levels = t.worded(t.list(t.number, nil, 1), "a list of at least one value")
local contours = t.either(t.only(true), t.integer(1, 100), levels)

local function paper(most)
  return { "size", size, [[{width, height}, exactly; or the greatest width, with at most twice that height, as much as
what is shown needs]], otherwise = "at most " .. most, unit = "pixels" },
    { "scale", t.positive, "multiplies the size, of text and lines as well", default = 1 },
    { "transparent", t.flag, "no white background; not in films", default = false }
end
local size_alone, scale, transparent = paper "1600 x 1000, of several states or fields 1600 x 2000"

local columns = { "columns", t.integer(1, 100), "pictures in a row", otherwise = "as many as show them largest" }
local fps = { "fps", t.positive, "pictures per second of a film, for .ogv a whole number", default = 10 }
local entries = { "pictures", t.either(t.object "picture", t.list(t.object "picture")),
                  "pictures, or lists of them, in order" }

return {
  title = "Pictures and charts", word = "pictures",
  { "sg.picture", [[Returns a picture of a model's present state, of a state that a run has kept, or of patches, and
writes it where a file is named. It holds the state as it is now: what the model does later changes nothing.]],
    named = {
      "What is shown, one of these:",
      { "model", t.object "model", "shows its present state", optional = true },
      { "state", t.object "state", "an entry of run:states()", optional = true, excludes = { "states", "patch" } },
      { "patch", t.one_or_more(t.object "patch"),
        "patches of one dimension, before they are bodies: gray", optional = true, excludes = { "model" } },
      "How several make a picture, in short:",
      of_models { "states", t.list(t.object "state", nil, 1), [[run:states(), as sg.sheet shows a picture of each; or,
by the file's name, as sg.film does: "x-%04d.png", "x.ogv"]], optional = true },
      { "fields", t.list(field_name, nil, 1), "side by side, each with a color bar of its own, as in sg.sheet",
        optional = true, excludes = { "field", "patch", why = "it is in its place" } },
      merged(columns, { needs = { "states", "fields" } }), merged(fps, { needs = { "states" } }),
      "Colors:",
      of_models { "field", field, [[displacements ux uy u (length), Cauchy stresses sxx syy szz sxy, von_mises,
pressure, I1 (tr sigma; force per area), F11 F12 F21 F22 F33 (none); of solids also uz sxz syz F13 … F32;
contact_pressure (force per current area) on slave faces, in the plane as a band along them. Stresses are evaluated
where they are drawn, neither extrapolated nor averaged, so that jumps between elements show]], otherwise = "gray" },
      { "factor", t.number, "multiplies the field", default = 1, needs = { "field", "fields" } },
      { "label", t.text, "title of the color bar", otherwise = "the field's name with its factor",
        needs = { "field" }, excludes = { "fields", why = "each of which has a color bar of its own" } },
      { "range", t.interval, "lowest and highest value of the colors, in the unit of the field times factor",
        otherwise = "that of the values, but for 0.5 % that lie far beyond the others" },
      { "contours", contours, [[lines of equal values: true at the bar's numbers, a number for as many between the ends
of the range, or these values]], otherwise = "none", needs = { "field", "fields" } },
      { "bar", t.flag, "the color bar, with the lowest and the highest value at its ends", default = true },
      { "colormap", t.choice(core.colormaps), "'coolwarm' suits values of both signs", default = "viridis" },
      "What of it is drawn:",
      of_models { "bodies", t.list(body_name, nil, 1), "those with these names", otherwise = "all" },
      of_models { "deformed", t.flag, "the present shape; false: the reference shape", default = true },
      of_models { "undeformed", t.flag, "the reference shape as well, dashed, in space also translucent",
        default = false },
      { "mesh", t.flag, "borders of elements", default = true },
      { "control_points", t.flag, "control points with the net between them", default = false },
      of_models { "vectors", t.choice { "displacement", "traction" }, [[arrows: displacements at points of a grid, or
tractions (force per current area) at the contact points of slave faces, with a key below the picture]],
        otherwise = "none" },
      of_models { "obstacles", t.flag, "rigid obstacles", default = true },
      of_models { "mirror", t.choice { "x", "y", "z", "xy", "xz", "yz", "xyz" },
        [[adds mirror images at 0 of these axes, of bodies that cross the mirror those of their larger
part; z: solids]], otherwise = "none" },
      of_models { "cut", cut, [[Solids: the half that is taken away. "y": that of greater y, "-y": that of smaller y,
through the middle of the bodies. The cut face has the colors of the field inside]], otherwise = "nothing is cut" },
      { "marks", t.list(mark), "rings at places, first ones first where there is little room; run.places will do",
        optional = true },
      { "names", t.flag, "of a patch: its faces' names, ξ¹ ξ² ξ³ along its directions, and numbers of several patches",
        default = true, needs = { "patch" } },
      "On paper:",
      { "title", t.text, "line above the picture", otherwise = "none, of a kept state its title" },
      { "crop", t.numbers(), [[{xmin, xmax, ymin, ymax}: shows this part only; in space with zmin, zmax: the rectangle
in which this box is seen, with all that stands before and behind it]], otherwise = "all", unit = "length" },
      { "inset", t.numbers(), "the same: this part is magnified in a box within the picture",
        otherwise = "none", unit = "length" },
      { "camera", camera, [[Solids: the direction from which they are seen in parallel projection. "iso": from the
front, the right and above; "front": from -y, z upwards; "left": from -x; "top": from +z, y upwards]],
        otherwise = '"iso", with a cut from the side on which the cut face is seen' },
      { "unit", t.text, 'of lengths, such as "mm": behind the names of axes and at the ruler', otherwise = "none" },
      { "axes", t.list(t.text), [[names of the axes, one per direction: {"r in mm", "z in mm"}]],
        otherwise = "x, y and z, with unit" },
      { "ruler", t.flag, "solids: a line of a round length below the picture", otherwise = "true" },
      size_alone, scale, transparent, file,
    },
    more = [[Lines and texts are vectors in .svg and .pdf, fields and surfaces images. Surfaces of solids are shaded a
little: what faces the light has the colors of the bar.]],
    example = {
      [[sg.picture{ model = model, field = "uy", file = "die.png" }]],
      [[sg.picture{ model = model, field = "syy", contours = true, mesh = false, file = "levels.png" }]],
      [[sg.picture{ model = model, vectors = "displacement", axes = {"r in mm", "z in mm"}, file = "arrows.png" }]],
      [[sg.picture{ patch = sg.shapes.block{ size = {2, 1, 1} }, control_points = true, file = "patch.png" }]],
      [[sg.picture{ model = model, field = "syy", inset = {0.6, 0.9, 0.85, 1}, file = "close.png" }]],
      [[sg.picture{ states = run:states(), fields = {"ux", "uy"}, file = "press-%04d.png" }]],
      [[sg.picture{ model = solid, field = "szz", cut = "-y", camera = { from = {1, -2, 1} }, file = "cut.png" }]],
    } },
  { "sg.sheet", [[Returns several pictures as one, and writes it where a file is named. States of one field that are
drawn in one way (camera, crop, inset, unit, contours, vectors) share axes, scale and color bar; all others stand side
by side, each with its own. Charts and sheets may be among them. Titles of pictures stand above them; their sizes do not
count.]], entries = entries,
    named = {
      columns,
      { "title", t.text, "line above the sheet", optional = true },
      { "range", t.either(t.choice { "shared", "own" }, t.interval), [["shared": pictures with one title of the color
bar have one range of colors; "own": each has its own and a bar; {low, high}: that of all]], default = "shared" },
      (paper "1600 x 2000"), scale, transparent, file,
    },
    example = {
      [[local pictures = {}
model:run(stages, { on_step = function(info)
  if info.step % 2 == 0 then pictures[#pictures + 1] = sg.picture{ model = model, field = "uy" } end
end })
sg.sheet{ pictures, columns = 2, file = "states.png" }]],
      [[local whole = sg.picture{ model = solid, field = "szz" }
local cut = sg.picture{ model = solid, field = "szz", cut = "-y" }
sg.sheet{ whole, cut, title = "Vertical stress", file = "pair.png" }]],
    } },
  { "sg.film", [[Writes pictures one after the other, as a film or to numbered files. All have one scale, one layout and
one range of colors, unless they were given others: nothing jumps. They must show the same in the same arrangement.]],
    entries = entries,
    named = {
      { "file", t.text, [["x.mp4" (H.264, needs the program ffmpeg), "x.ogv" (Theora, needs no other program), or
"x-%04d.png", .svg, .pdf: files numbered from 1]] },
      fps,
      { "size", size, "as in sg.picture", otherwise = "that of the first picture", unit = "pixels" },
      scale, transparent,
    },
    example = [[local pictures = {}
for i, state in ipairs(run:states()) do pictures[i] = sg.picture{ state = state, field = "uy", size = 800 } end
sg.film{ pictures, fps = 5, file = "press.ogv" }]] },
  { "picture", [[What sg.picture, sg.sheet, sg.chart and sg.heatmap return: a figure that is complete, free of the
model. It is written by picture:write, and shown with others by sg.sheet and sg.film.]],
    example = [[print(sg.picture{ model = model, field = "uy" })]] },
  { "picture:write", "Writes the picture to a file, whole or not at all.",
    arguments = { { "file", t.text, "a name that ends with .png, .svg or .pdf" } },
    example = [[sg.picture{ model = model, field = "uy" }:write "die.pdf"]] },
}
