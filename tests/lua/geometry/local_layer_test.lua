-- Layers in ranges of the contact face and knots of the contact rows only: counts, patch tests, Hertz's pressure with
-- fewer unknowns, files, wrong arguments.

require "check"
local formulations = require "formulations.rows"
local hertz = require "problems.hertz2d.problem"
local patch_test = require "problems.patch_test.problem"

local soft = sg.linear_elastic{ E = 1, nu = 0.3 }

local function slab(more)
  return scenes.body(lists.merged({ size = { 12, 1 }, elements = { 12, 2 }, order = "N2-N2.2", contact = "north",
    material = soft, thickness_degree = 1 }, more))
end

local function block(more)
  return scenes.body(lists.merged({ size = { 9, 6, 2 }, elements = { 9, 6, 2 }, order = "N2-N2.2", contact = "back",
    material = soft, thickness_degree = 1 }, more))
end

check.case("unknowns in closed form: 2 more functions per raised element, 1 more per knot", function()
  local row, bulk = 12 + 2, 2 * (12 + 2)
  local function total(more) return slab(more):dofs().total / 2 - bulk end
  check.equal(total(), row + 12 * 2)
  check.equal(total{ layer = { 0.25, 0.5 } }, row + 3 * 2)
  check.equal(total{ layer = { 0.26, 0.49 } }, row + 3 * 2) -- snapped outward
  check.equal(total{ layer = { 0.24, 0.51 } }, row + 5 * 2)
  check.equal(total{ layer = { 0, 1 } }, row + 12 * 2)
  check.equal(total{ layer = function(X) return X[1] > 3 and X[1] < 6 end }, row + 3 * 2)
  check.equal(total{ layer = function(X) return X[1] < 1 or X[1] > 10 end }, row + 3 * 2) -- two ranges
  check.equal(total{ order = "N2-N4", layer = { 0.25, 0.5 } }, row + 2)
  check.equal(total{ order = "N2-N3.1", layer = { 0.25, 0.5 } }, row + 1 + 3)
  check.equal(total{ order = "N2", layer = { 0.25, 0.5 }, layer_knots = 2 }, row + 3)
  check.equal(total{ order = "N2", layer_knots = 3 }, row + 2 * 12)
  check.equal(total{ order = "N2", layer_knots = { 0.1, 0.2 } }, row + 2)
  check.equal(total{ layer = { 0.25, 0.5 }, layer_knots = 2 }, row + 3 * 2 + 3 * 3)
  check.equal(total{ order = "N2-N2.2x2", layer = { 0.25, 0.5 } }, row + 2 * 3 * 2)
  check.equal(total{ contact = { "south", "north" }, layer = { 0.25, 0.5 } }, row + 2 * 3 * 2)
end)

check.case("in space a row is a product: the degree is raised in the strips of both directions", function()
  local bulk = 2 * 11 * 8
  local function total(more) return block(more):dofs().total / 3 - bulk end
  check.equal(total{ layer = { { 0, 1 }, { 0.4, 0.6 } } }, (11 + 18) * (8 + 4))
  check.equal(total{ layer = { { 0.4, 0.5 }, { 0.4, 0.6 } } }, (11 + 4) * (8 + 4))
  check.equal(total{ layer = function(X) return (X[1] - 4) ^ 2 + (X[2] - 3) ^ 2 < 1 end }, (11 + 4) * (8 + 4))
  check.equal(total{ layer = { { 0.4, 0.5 }, { 0.4, 0.6 } }, layer_knots = 2 }, (11 + 4 + 2 * 3) * (8 + 4 + 2 * 3))
  check.equal(total{ order = "N2", layer_knots = { 1, { 0.1, 0.25 } } }, 11 * 10)
  check.equal(total{ order = { "N2", "N2-N2.2" }, layer = { { 0, 0.2 }, { 0.4, 0.6 } } }, 11 * 12)
end)

check.case("patch tests pass to rounding error, with raised degrees and further knots on either block", function()
  for _, name in ipairs { "gpts", "equal-multipliers", "reduced" } do
    for _, dimension in ipairs { 2, 3 } do
      local upper = dimension == 2 and { 0.3, 0.6 } or { { 0.3, 0.6 }, { 0, 0.5 } }
      local lower = dimension == 2 and { 0, 0.5 } or { { 0, 0.5 }, { 0.5, 1 } }
      local model = patch_test.scene{ dimension = dimension, order = "N2-N2.2", lower = 2, upper = dimension == 2 and 6
        or 4, slave = "upper", layer = { upper = upper, lower = lower }, layer_knots = { upper = 2 },
        points = 5, formulation = formulations[name] }
      check.completed(model:run({ patch_test.stage }, sg.plain{}))
      check.at_most(("%s, %dD: pressure"):format(name, dimension),
        patch_test.pressure_error(model:profile "joint"), 1e-11)
    end
  end
end)

check.case("Hertz's pressure as accurate as with the full layer, with fewer unknowns", function()
  local a = hertz.hertz(2 * hertz.half_load * hertz.outer)
  local function solve(order, mesh, layer)
    local model, stage, ring = hertz.scene{ order = order, mesh = mesh, load = "force", layer = layer }
    stage.steps = 2
    assert(not model:run({ stage }, sg.plain{}).failed)
    return model:profile "ground", ring:dofs().total
  end
  local finest = solve("N2-N2.2", "m4")
  local function error_of(profile)
    return sg.profile_error{ profile = profile, reference = finest, normalize = "max",
                             coordinate = function(point) return point.x / a end }
  end
  local plain, bulk = solve("N2", "m2")
  local full, all = solve("N2-N2.2", "m2")
  local part, some = solve("N2-N2.2", "m2", function(X) return X[1] < 1.2 * a end)
  assert(some - bulk < 0.6 * (all - bulk), some)
  check.near(error_of(part) / error_of(full), 1, 0.02)
  assert(error_of(part) < 0.5 * error_of(plain))
end)

check.case("files hold the row; print shows its degrees", function()
  local body = slab{ layer = { 0.25, 0.5 }, layer_knots = 2 }
  check.holds(tostring(body), "15 x 2 elements", "2 x 1, then 2..4 x 1")
  local model = scenes.model{ bodies = { slab = body }, supports = { bed = { on = "south", fix = "xy" },
                                                                 lid = { on = "north", drive = "xy" } } }
  check.completed(model:run({ { name = "press", steps = 1, lid = { 0, -0.1 } } }, {}))
  local folder = check.folder()
  model:save(folder .. "/state.sgn")
  local read = sg.load(folder .. "/state.sgn")
  for _, xi in ipairs { { 0.1, 1 }, { 0.3, 0.9 }, { 0.5, 0.7 }, { 0.77, 1 } } do
    check.equal(read:sample("slab", "syy", xi), model:sample("slab", "syy", xi))
  end
  check.equal(read:body "slab":points(), body:points())
  sg.vtu{ model = model, file = folder .. "/slab.vtu" }
  sg.picture{ model = model, file = folder .. "/slab.png", field = "syy", control_points = true }
  check.pictures(folder, { "slab" })
end)

check.case("wrong ranges, knots and labels", function()
  local function wrong(values, ...) check.fails(function() slab(values) end, "sg.body", ...) end
  wrong({ layer = { 0.5, 1.5 } }, "layer must be in 0 … 1, the parameters along the contact face, got {0.5, 1.5}")
  wrong({ layer = { 0.5, 0.5 } }, "layer must be increasing")
  wrong({ layer = { 0.6, 0.5 } }, "layer must be increasing")
  wrong({ layer = { { 0, 0.5 }, { 0, 1 } } }, "layer")
  wrong({ order = "N2", layer = { 0, 0.5 } }, "order 'N2' has no layer", "N2-N2.2, or layer_knots")
  wrong({ layer = function() return nil end }, "layer must return true or false, got nothing", "return a comparison")
  wrong({ layer = function(X) return X[2] < 0 end }, "layer must return true somewhere on contact face 'north'",
    "between (", " and (")
  wrong({ layer_knots = 0 }, "layer_knots")
  wrong({ layer_knots = { 0.25 } }, "layer_knots must be inside elements, but 0.25 is a border of two already")
  wrong({ layer_knots = { 0.26, 0.26 } }, "layer_knots must differ, got 0.26 twice")
  wrong({ layer_knots = { 1.26 } }, "layer_knots must be in 0 … 1")
  wrong({ order = "L2", layer_knots = 2 }, "layer_knots need B-splines in all rows, but order is 'L2'")
  check.fails(function()
    scenes.body{ layer = { 0, 0.5 }, layer_knots = 2, material = soft }
  end, "layer has no effect without contact", 'contact = "south"')
  check.fails(function() block{ layer = { 0, 0.5 } } end,
    "layer[1] must be a list of 2 increasing numbers {low, high}, got the number 0")
  check.fails(function() block{ layer = { { 0, 0.5 }, { 0.5, 2 } } } end, "layer[2] must be in 0 … 1")
end)
