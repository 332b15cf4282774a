-- Pages: ready scenes.

local t = require "signorini.call.types"

--- The arguments that all scenes have.
local function order(default)
  return { "order", t.worded(t.either(t.text, t.list(t.text)), "a label or a list of labels"),
           "discretization of all bodies, help \"orders\"", default = default }
end
local function refinement(of)
  return { "refinement", t.integer(1, 64), "factor on the number of elements " .. (of or "in each direction"),
           default = 1 }
end
local function mu(default, of)
  return { "mu", t.non_negative, "Coulomb's coefficient of friction" .. (of or ""), default = default }
end

--- A page with its source as the last line. closed_form: names of the numbers of its third result, if it has one.
local function scene(page)
  page.may_be_empty = true
  page.returns = { t.object "model", t.list(t.named "stage") }
  if page.closed_form then page.returns[3] = t.record(page.closed_form, t.number) end
  page.more = page.more .. "\n" .. page.source
  return page
end

return {
  title = "Ready scenes", word = "scenes",
  scene { "sg.scenes.ironing", [[Returns a plane model of a half ring above a soft slab, and the path that presses it
down and drags it along: m, path = sg.scenes.ironing{}; m:run(path).]],
    named = { order "N2-N2.2", refinement(), mu(0.2),
              { "depth", t.range(0.01, 0.5), "by which it is pressed down", unit = "length", default = 0.23 },
              { "distance", t.range(0.01, 1.7), "by which it is dragged", unit = "length", default = 0.6 } },
    more = [[
Bodies die (E = 1000) and slab (E = 1, 3 × 1), supports bed and grip, contact interface. The path is a list of two
stages, press and slide, to be changed as needed: path[2].steps = 200.]],
    source = "Source: V. Agrawal, thesis, IIT Guwahati, 2020, 7.1; the supplied script ironing2d.lua has its variants.",
    example = [[
m, path = sg.scenes.ironing{ mu = 0.1 }
run = m:run(path)
sg.picture{ model = m, field = "uy", file = "ironing.png" }]] },
  scene { "sg.scenes.hertz", [[Returns a model of a hollow cylinder or ball on a rigid plane, the path that presses it
down by a force, and Hertz's closed form { a, p0, load }: half-width (radius) of the contact, peak pressure, force.]],
    named = { { "body", t.choice { "cylinder", "ball" }, "a cylinder (plane strain) or a ball (axisymmetric)",
                default = "cylinder" },
              order "N2-N2.2", refinement "along the arc, of the ball in both directions",
              { "load", t.positive, "force, of the cylinder per depth", otherwise = "0.002, of the ball 3.1416e-4",
                derived = function(values) return values.body == "ball" and math.pi * 1e-4 or 2e-3 end } },
    closed_form = "a p0 load",
    more = [[
Outer radius 1, E = 1, nu = 0.3; half of the section is modeled, x = 0 is the plane of symmetry or the axis. The contact
is ground. Hertz's half space neglects a/R: pressures agree to about 1 % for the cylinder and 2.5 % for the ball.]],
    source = "Source: K. L. Johnson, Contact Mechanics, Cambridge, 1985, 4.2; the supplied scripts hertz2d.lua and "
      .. "hertz_sphere.lua.",
    example = [[
m, path, hertz = sg.scenes.hertz{ body = "cylinder" }
m:run(path)
print(m:contact_resultant "ground".max_pressure / hertz.p0)
print(sg.profile_edges{ profile = m:profile "ground" }.to / hertz.a)]] },
  scene { "sg.scenes.rings", [[Returns a plane model of two half rings, a quarter of each by symmetry, and the path that
presses them together; they bend and slide.]],
    named = { order "N2-N2.2", refinement "along the arcs", mu(0.1),
              { "depth", t.range(0.1, 4), "by which the upper ring is pressed down", unit = "length", default = 4 } },
    more = "Bodies upper (E = 100) and lower (E = 300), supports bed, symmetry and grip, contact interface.",
    source = "Source: V. Agrawal, thesis, IIT Guwahati, 2020; the supplied script rings2d.lua.",
    example = [[
m, path = sg.scenes.rings{ depth = 1 }
m:run(path)]] },
  scene { "sg.scenes.block", [[Returns a 3D model of a block above a slab, half of both by symmetry, and the path that
presses it down and drags it along.]],
    named = { order "N2", refinement(), mu(0),
              { "depth", t.range(0.1, 2), "by which it is pressed down", unit = "length", default = 1 },
              { "distance", t.range(0.1, 12.5), "by which it is dragged", unit = "length", default = 1 } },
    more = [[
Bodies block (E = 10, 4 × 2 × 4) and slab (E = 1, 20 × 5 × 10), supports bed, grip and mirror, contact interface. The
sharp edges of the block plow through the slab.]],
    source = "Source: L. De Lorenzis, P. Wriggers, G. Zavarise, Comput. Mech. 49 (2012); the supplied script "
      .. "block_ironing3d.lua.",
    example = [[
m, path = sg.scenes.block{ depth = 0.5, distance = 0.5 }
m:run(path)]] },
  scene { "sg.scenes.bumper", [[Returns an axisymmetric model of a jounce bumper of rubber between two plates, and the
path that compresses it: its grooves close and its bore folds, so that it touches itself.]],
    named = { order "N2", refinement(), mu(0.3, " of the plates"),
              { "depth", t.range(0.6, 33), "by which it is compressed, in steps of 1 mm", unit = "mm", default = 24 },
              { "self_contact", t.flag, "false: it passes through itself", default = true } },
    more = [[
Body bumper (radii 10 and 30 mm, 60 mm high; c10 = 0.752 MPa, K = 400 MPa), supports plate and bed, contacts top, bottom
and folds (among). The bore touches itself from 12 mm on, the flanks of the grooves from 21 mm on.]],
    source = "Source: a shape such as those of car suspensions; the supplied script bumper.lua.",
    example = [[
m, path = sg.scenes.bumper{ depth = 18 }
run = m:run(path)
print(run:column "folds.area"[run.steps], -m:reaction "plate"[2])]] },
  scene { "sg.scenes.peeling", [[Returns a plane model of a strip that adheres to a rigid plane by van der Waals forces,
the path that rotates its end and so peels it, and { moment, work }: the moment of steady peeling of a thin strip and
the work of adhesion.]],
    named = { order "N2-N2.2", refinement(),
              { "bonded", t.range(20, 400), "length of the bond; the strip is 10 nm longer", unit = "nm",
                default = 50 },
              { "angle", t.range(1, 180), "by which the end is rotated", unit = "degrees", default = 46 } },
    closed_form = "moment work",
    more = [[
Body strip (E = 2 nN/nm², nu = 0.2, 10 nm high), supports edge and pin, contact film. The columns edge.angle and
edge.moment of the run show a plateau, within 1 % of the closed form, until the bond ends.]],
    source = "Source: R. A. Sauer, Int. J. Numer. Meth. Engng 87 (2011); the supplied script peeling2d.lua.",
    example = [[
m, path, steady = sg.scenes.peeling{ bonded = 20, angle = 20 }
run = m:run(path)
print(run:column "edge.moment"[run.steps] / steady.moment)]] },
  scene { "sg.scenes.patch_test", [[Returns a model of two blocks with meshes that do not match, the path that loads the
upper one by a pressure, and { pressure }, the contact pressure at every point.]],
    named = { { "dimension", t.integer(2, 3), "2: plane strain, 3: solids", default = 2 }, order "N2", refinement(),
              { "method", t.choice { "gpts", "mortar", "half_passes" }, "contact formulation, help \"contact\"",
                default = "gpts" } },
    closed_form = "pressure",
    more = "Bodies lower (E = 1) and upper (E = 2), load push, contact joint.",
    source = "Source: R. L. Taylor, P. Papadopoulos, in Nonlinear Computational Mechanics, Springer, 1991; the "
      .. "supplied script patch_test.lua.",
    example = [[
m, path, exact = sg.scenes.patch_test{ method = "mortar" }
m:run(path)
print(m:contact_resultant "joint".max_pressure / exact.pressure)]] },
}
