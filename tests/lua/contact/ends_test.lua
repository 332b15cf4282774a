-- Masters with sharp ends: how far an end acts depends on the slave's elements, not on the master's.

require "check"

--- P (1 − ν)/(4 G a w) of a rigid flat punch of radius 1 on a layer of thickness 1 that is bonded to a rigid base. The
--- punch is a line of `count` elements, or without it a plane on which only points within the radius act.
local function punched(count)
  local nu, G, depth, width = 0.3, 1, 0.01, 8
  local E = 2 * G * (1 + nu)
  local layer = scenes.body{ size = {width, 1}, elements = { 60, 15 }, contact = "north",
    grading = { { elements = 0.6, length = 0.25, at = "start" }, false },
    material = sg.linear_elastic{ E = E, nu = nu } }
  local line = sg.nurbs.line{ from = { 0, 1 }, to = { 1, 1 } }
  local punch = count and sg.rigid.surface(count > 1 and line:refine{ elements = { count } } or line)
    or scenes.ceiling(1)
  local model = scenes.model{ kind = "axisymmetric", bodies = { layer = layer },
    supports = { axis = { on = "west", symmetry = true }, base = { on = "south", fix = "xy" },
                 push = { on = punch, drive = "y" } },
    contacts = { c = { slave = "north", master = punch, penalty = 1000 * E,
                       where = not count and function(X) return X[1] <= 1 end or nil } } }
  local run = check.completed(model:run{ { steps = 1, push = { -depth } } })
  return -model:reaction "push".fy * (1 - nu) / (4 * G * depth), run
end

check.case("a flat rigid punch of one element", function()
  local kappa, run = punched(1)
  -- Hayes, Keer, Herrmann and Mockros (J. Biomech. 5, 1972): 2.480; these elements alone add 3 %, also without an end
  check.near(kappa, 2.480, 0.05 * 2.480)
  check.near(kappa, (punched()), 0.02 * kappa)
  for _, count in ipairs { 2, 7 } do check.near((punched(count)), kappa, 1e-6 * kappa) end
  check.equal(#run.warnings, 1)
  check.holds(run.warnings[1], "at the end of stage 'stage 1': contacts.c: ",
    " % of its force acts beyond an end of the master", "Hint: round its edge, or use smaller elements")
end)

--- Force of a slab on a block of half its width.
local function pressed(count, swap)
  local slab = scenes.body{ size = {10, 3}, corner = { -5, 0 }, elements = { 80, 6 }, contact = "south", E = 1000 }
  local block = scenes.body{ size = {2, 2}, corner = { -1, -2 }, elements = { count, 2 }, contact = "north", E = 1e5 }
  local slave, master = slab:face "south", block:face "north"
  if swap then slave, master = master, slave end
  local model = scenes.model{ bodies = { slab = slab, block = block },
    supports = { bed = { on = "block.south", fix = "xy" }, top = { on = "slab.north", fix = "x", drive = "y" } },
    contacts = { c = { slave = slave, master = master, penalty = 1e5 } } }
  local run = check.completed(model:run{ { steps = 1, top = { -0.02 } } })
  return math.abs(model:contact_resultant "c".fy), run
end

check.case("a narrow master: its number of elements does not matter", function()
  local fine, swapped = pressed(32), pressed(32, true) -- where the block is the slave, no end of a master acts
  check.near(fine, swapped, 0.01 * fine)
  for _, count in ipairs { 1, 2, 4, 8 } do check.near((pressed(count)), fine, 0.01 * fine) end
  local _, run = pressed(8)
  check.holds(run.warnings[1], " % of its force acts beyond an end", "Hint: let the face that ends be the slave, round")
  check.equal(select(2, pressed(8, true)).warnings, {})
end)

check.case("in space", function()
  local function force(count)
    local surface = sg.nurbs.ruled{ a = sg.nurbs.line{ from = { -1, 0, 0 }, to = { 1, 0, 0 } },
                                    b = sg.nurbs.line{ from = { -1, 1, 0 }, to = { 1, 1, 0 } } }
    local punch = sg.rigid.surface(surface:refine{ elements = { count, 1 } })
    local model = scenes.model{
      bodies = { slab = { size = { 4, 1, 1 }, corner = { -2, 0, 0 }, elements = { 24, 2, 3 }, contact = "front",
          thickness_degree = 1 } }, supports = { top = { on = "back", fix = "xyz" },
        sides = { on = { "south", "north" }, fix = "y" }, push = { on = punch, drive = "z" } },
      contacts = { c = { slave = "front", master = punch, penalty = 100 } } }
    check.equal(model:run{ { steps = 1, push = { 0.02 } } }.reason, "completed")
    return model:reaction "push".fz
  end
  local single = force(1)
  check.near(force(12), single, 1e-6 * single) -- elements as long as the slab's
  check.near(force(48), single, 0.02 * single)
end)
