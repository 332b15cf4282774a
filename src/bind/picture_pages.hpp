#pragma once
// The help pages of sg.picture and sg.frame.

namespace signorini::bind {

constexpr const char* picture_page =
    R"(sg.picture{ model, file, field, fields, factor = 1, label, title, range, colormap = "viridis", size, scale = 1,
            crop, inset, transparent = false, bodies, deformed = true, undeformed = false, mesh = true,
            control_points = false, obstacles = true, mirror, camera = "iso", cut, marks, states, frames, columns,
            fps = 10, patch, names = true, unit, ruler = true,
            bar = true }
Draws the model's present state, or states that were kept, to a file, whole or not at all. Lengths are those of
the model, sizes are pixels.
file:        "x.png", "x.svg" or "x.pdf" (lines and texts are vectors, fields images); for several states also a
             series: "x-%04d.png", numbered from 1, or a film: "x.mp4" (H.264, needs the program ffmpeg) or "x.ogv"
             (Theora, needs no other program).
 What is shown
patch:       a patch, or a list of patches of one dimension, in the place of model, before they are bodies: grey;
             takes mesh, control_points, names, marks and all on paper.
names:       of a patch only: "west" … on its faces, ξ¹ ξ² ξ³ at arrows along its directions, and of several
             patches their numbers (true).
model:       whose present state is drawn; the model is as it was afterwards.
states:      run:states() in its place: a sheet with one colour bar, or a series of one frame and range of colours.
frames:      a list of what sg.frame kept, in the place of model: a sheet or a series as well.
bodies:      {"die"}, a list of names; by default all.
deformed:    true draws the present shape, false the reference shape.
undeformed:  true adds the reference shape: dashed outline, in space translucent behind the bodies (false).
mesh:        borders of elements (true).
control_points: control points with the net between them (false).
obstacles:   rigid obstacles, hatched, in space grey behind the bodies, of which they tint nothing, with an outline
             over them (true).
mirror:      "x", "y", "xy", in space also with "z": adds mirror images at 0 of these axes; by default none.
cut:         solids only: the half that is taken away. "y" that of greater y, "-y" that of smaller y, through the
             middle of the bodies; cut = { normal = "y", at = 0.5 } at y = 0.5 (length); cut = { normal = {…},
             point = {…} } the half that the normal points to. The cut face has the colours of the field inside. By
             default nothing is cut.
marks:       { { x = {x, y}, text = "J = -0.2" }, … }: rings with crosses at places (lengths) of the present state,
             the first ones first where there is little room for texts; places of a failed run will do. By default
             none.
 Colours
field:       ux uy u (length), Cauchy stresses sxx syy szz sxy, von_mises, pressure, I1 (tr sigma) (force per area),
             F11 F12 F21 F22 F33 (none); solids also uz sxz syz F13 … F32; and contact_pressure (force per current
             area) on the slave faces, in the plane as a band along them, linear between contact points. By default
             bodies are grey. Stresses are evaluated where they are drawn, from the exact deformation gradient: nothing
             is extrapolated or averaged, so that jumps between elements, where N1 and Lp have them, show.
fields:      {"sxx", "syy"}, in the place of field: side by side, each with a colour bar of its own.
factor:      multiplies the field (1).
label:       title of the colour bar; by default the field's name with its factor.
range:       {low, high} of the colours, in the unit of the field times factor; by default that of the values, but for
             0.5 % that lie far beyond the others.
bar:         the colour bar, with the lowest and the highest value at its ends (true).
colormap:    "viridis", "magma", "inferno", "plasma", "cividis", or "coolwarm" for values of both signs ("viridis").
 On paper
size:        {width, height} in pixels, exactly; or a number, the greatest width in pixels, with twice as much for the
             height: the picture then is no larger than what it shows. By default at most 1600 x 1000 pixels, sheets
             and fields 1600 x 2000. From 160 x 120 to 5000 x 5000. Numbers have 27 pixels at 1600, less below.
scale:       multiplies the pixels, of text and lines as well (1).
columns:     states, frames or fields in a row; by default so many as show them large.
title:       a line above the picture; by default none.
crop:        {xmin, xmax, ymin, ymax}, lengths: shows this part only; in space with zmin, zmax: shows the rectangle in
             which this box is seen, with all that stands before and behind it. By default all.
inset:       the same: this part is magnified in a box within the picture, in every state and field; by default none.
camera:      solids only: "iso" (from the front, the right and above), "front" (from -y, z upwards), "back", "left"
             (from -x), "right", "top" (from +z, y upwards), "bottom", or
             camera = { from = {direction to the eye}, up = {upwards} }; parallel projection ("iso", with cut
             from the side on which the cut face is seen).
unit:        of lengths, "mm": stands behind the axes' names and at the ruler; by default nothing.
ruler:       solids only: a line of a round length below the picture, true in directions across the line of sight
             (true).
transparent: no white ground; not in films (false).
fps:         pictures per second of a film, for .ogv a whole number (10).
Surfaces of solids are shaded a little: what faces the light has the colours of the bar.
Example: sg.picture{ model = model, field = "uy", file = "die.png" }
Example: sg.picture{ patch = sg.shapes.block{ size = {2, 1, 1} }, control_points = true, file = "patch.png" }
Example: sg.picture{ model = model, field = "syy", inset = {0.6, 0.9, 0.85, 1}, file = "close.png" }
Example: sg.picture{ states = run:states(), fields = {"ux", "uy"}, file = "press-%04d.png" }
Example: sg.picture{ states = run:states(), field = "uy", size = 800, fps = 5, file = "press.ogv" }
Example: sg.picture{ model = solid, field = "szz", cut = "-y", camera = { from = {1, -2, 1} }, file = "cut.png" })";

constexpr const char* frame_page =
    R"(sg.frame{ model, title, field, factor = 1, bodies, deformed = true, undeformed = false, mesh = true,
          control_points = false, obstacles = true, mirror, cut, marks, patch, names = true }
Keeps the model's present state for a picture of several, with a title above it; all others as in sg.picture.
Example: local frames = {}
         model:run(stages, { on_step = function(info)
           if info.step % 2 == 0 then frames[#frames + 1] = sg.frame{ model = model, field = "uy" } end
         end })
         sg.picture{ frames = frames, columns = 2, file = "states.png" })";

} // namespace signorini::bind
