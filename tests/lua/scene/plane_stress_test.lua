-- Plane stress: a plate with a hole (Kirsch), thickness, energy, pictures, contact, wrong input.

require "check"

local width = 20 -- half of the plate's, in units of the hole's radius

--- A quarter of a plate with a hole in two bodies tied along the diagonal, under the stress `stress` along x.
local function plate(material, kind, stress)
  local function quarter(from, line, seam)
    local patch = sg.nurbs.ruled{
      a = sg.nurbs.curve{ degree = 1, knots = { 0, 0, 1, 1 }, points = line },
      b = sg.nurbs.arc{ center = { 0, 0 }, radius = 1, from = from, to = from + 45 },
    }
    return scenes.body{ patch = patch, elements = { 6, 16 }, order = "N3", contact = seam, thickness_degree = 3,
      material = material, grading = { false, { elements = 0.75, length = 0.1, at = "end" } } }
  end
  local lower = quarter(0, { { width, 0 }, { width, width } }, "south")
  local upper = quarter(45, { { width, width }, { 0, width } }, "south")
  local model = scenes.model{ bodies = { lower = lower, upper = upper }, kind = kind,
    supports = { below = { on = "lower.west", symmetry = true }, left = { on = "upper.east", symmetry = true } },
    ties = { diagonal = { slave = "lower.east", master = "upper.west" } },
    loads = { pull = { on = "lower.south", traction = { 0, 0 } } } }
  check.completed(model:run({ { steps = 2, pull = { stress, 0 } } }, { newton = { tolerance = 1e-12 } }))
  return model
end

check.case("a hole raises the stress threefold, and its edge moves by 3 S a/E", function()
  local stress, E, nu = 1e-3, 2, 0.3
  local soft = E / (2 * (1 + nu))
  local laws = { sg.linear_elastic{ E = E, nu = nu }, sg.neo_hookean{ E = E, nu = nu },
                 sg.mooney_rivlin{ c10 = 0.4 * soft, c01 = 0.1 * soft, K = E / (3 * (1 - 2 * nu)) } }
  for i, law in ipairs(laws) do
    local model = plate(law, "plane_stress", stress)
    check.within_share("greatest stress", model:sample("upper", "sxx", { 1, 1 }) / stress, 3, 0.01)
    check.within_share("stress at the other end", model:sample("lower", "syy", { 0, 1 }) / stress, -1, 0.03)
    check.within_share("displacement of the edge", model:sample("lower", "ux", { 0, 1 }) * E / stress, 3, 0.02)
    check.at_most("stress across", model:sample("upper", "szz", { 1, 1 }), 1e-12)
    local strain = model:sample("upper", "F33", { 1, 1 }) - 1
    check.within_share("strain across", strain, -nu * 3 * stress / E, i == 1 and 0.01 or 0.02)
  end
  -- In plane strain the edge moves less, by the factor 1 - nu^2.
  local model = plate(laws[1], "plane_strain", stress)
  check.within_share("plane strain", model:sample("lower", "ux", { 0, 1 }) * E / stress, 3 * (1 - nu^2), 0.02)
end)

local function strip(material, kind)
  return scenes.model{ bodies = { strip = { size = {2, 1}, elements = { 4, 2 }, material = material } }, kind = kind,
    supports = { held = { on = "west", fix = "x" }, corner = { on = "south-west", fix = "y" },
      grip = { on = "east", drive = "x" } } }
end

check.case("a strip in tension is a bar: energy, thickness, work", function()
  local E, nu, a = 2, 0.3, 1.2
  for i, law in ipairs { sg.linear_elastic{ E = E, nu = nu }, sg.neo_hookean{ E = E, nu = nu } } do
    local model = strip(law, "plane_stress")
    local run = model:run({ { steps = 40, grip = { 2 * (a - 1) } } }, { newton = { tolerance = 1e-13 } })
    -- The energy of the linear body is compared with its own work, at a strain beyond its law.
    check.equal({ run.failed, #run.warnings }, { false, i == 1 and 1 or 0 })
    local energy = model:energy()
    check.within_share("work", energy.work, energy.stored, 1e-3)
    local across = model:sample("strip", "F33", { 0.3, 0.6 })
    check.within("both lateral stretches", 1 + model:sample("strip", "uy", { 0.5, 1 })
      - model:sample("strip", "uy", { 0.5, 0 }), across, 1e-11)
    if tostring(law):find "linear" then
      check.within("force", model:reaction("grip")[1], E * (a - 1), 1e-12)
      check.within("stored", energy.stored, E * (a - 1)^2, 1e-12)
      check.within("across", across, 1 - nu * (a - 1), 1e-13)
    end
  end
end)

check.case("pictures, .vtu files, checkpoints and print know plane stress", function()
  local folder = check.folder()
  local model = strip(sg.neo_hookean{ E = 1, nu = 0.4 }, "plane_stress")
  model:run { { steps = 2, grip = { 0.5 } } }
  check.holds(tostring(model), "plane-stress model of strip")
  sg.picture{ model = model, fields = { "szz", "F33" }, file = folder .. "/strip.png" }
  check.pictures(folder, { "strip" })
  model:save(folder .. "/state.sgn")
  local back = sg.load(folder .. "/state.sgn")
  check.holds(tostring(back), "plane-stress")
  check.equal(back:sample("strip", "F33", { 0.5, 0.5 }), model:sample("strip", "F33", { 0.5, 0.5 }))
  check.equal(back:energy().stored, model:energy().stored)
end)

check.case("contact pressures of plates balance the force per undeformed thickness", function()
  local slab = scenes.body{ size = {2, 1}, elements = { 8, 4 }, contact = "north" }
  local disc = sg.rigid.cylinder{ center = { 1, 1.5 }, radius = 0.5 }
  local function model(kind)
    return scenes.model{ bodies = { slab = slab }, kind = kind,
      supports = { bed = { on = "south", fix = "xy" }, push = { on = disc, drive = "y" } },
      contacts = { touch = { slave = "north", master = disc, penalty = 100 } } }
  end
  local forces = {}
  for i, kind in ipairs { "plane_stress", "plane_strain" } do
    local scene = model(kind)
    check.completed(scene:run { { steps = 3, push = { -0.1 } } })
    check.near(scene:reaction("push")[2], scene:contact_resultant("touch").fy, 1e-12)
    forces[i] = -scene:reaction("push")[2]
  end
  -- A plate is softer.
  if not (forces[1] > 0.8 * forces[2] and forces[1] < forces[2]) then error(("%g, %g"):format(forces[1], forces[2])) end
end)

check.case("wrong kinds are errors", function()
  local body = scenes.body{ size = { 1, 1, 1 }, elements = { 1, 1, 1 }, order = "N1" }
  check.fails(function() sg.model{ bodies = { a = body }, kind = "plane_stress" } end, "kind is for plane models")
end)
