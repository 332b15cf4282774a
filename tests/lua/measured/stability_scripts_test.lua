-- scripts/stability, coarse: cells that converge with plain Newton, none of which fails with controls; results and
-- files.

require "check"

local function study(name, ...) return check.study("stability/" .. name, ...) end

--- Names of the outcomes, row by row from the first y on.
local function outcomes(map)
  local names = {}
  for i, cell in ipairs(map.cells) do names[i] = cell.outcome end
  return names
end

local function check_controls(maps, converged)
  check.equal(maps.comparison.lost, {})
  check.equal({ maps.robust:converged() }, { converged, #maps.plain.cells })
  for _, map in ipairs { maps.plain, maps.robust } do
    for _, cell in ipairs(map.cells) do
      if cell.outcome == "error" or cell.outcome == "crashed" then error(cell.report) end
    end
  end
end

local function check_files(result, count)
  check.equal(#result.files, count)
  for _, name in ipairs(result.files) do
    local file = assert(io.open(name, "rb"), name)
    check.equal(file:seek "end" > 150, true)
    file:close()
  end
end

check.case("deep ironing: with p + 1 points long steps fail, and shorter ones carry them through", function()
  local result = study("deep_ironing", "points=p+1", "orders=N2,N4", "coarser=2,16", "places=none")
  local maps = result.maps["p+1"]
  check.equal(maps.plain:converged() <= 1, true) -- which of them converges depends on the first guesses
  check_controls(maps, 4)
  local press = maps.robust:cell("N4", 2).results.press
  check.near({ press, maps.robust:cell("N4", 16).results.press }, { 0.7801, 0.7797 }, 1e-4)
  check_files(result, 5)
end)

check.case("deep ironing: a picture shows where N4 cycles", function()
  local result = study("deep_ironing", "points=p+1", "orders=N4", "coarser=2", "places=N4")
  check.equal(outcomes(result.maps["p+1"].plain), { "cycling" })
  check.equal({ result.failed.reason, result.failed.steps < 23 }, { "cycling", true }) -- while the die is pressed
  local place = result.failed.places[1]
  check.equal({ place.kind, place.contact }, { "contact point", "interface" })
  check.holds(place.text, "slip")
  check.equal(result.files[6]:match "[^/]*$", "places.png")
  check_files(result, 6)
end)

check.case("Hertz over the penalty: a high one makes the pressure oscillate, a layer less so", function()
  local result = study("penalty_hertz", "orders=N2,N2-N2.2", "penalties=1e2,1e4,1e6", "mesh=m2")
  local plain, robust = result.maps.plain, result.maps.robust
  check.equal(outcomes(plain), { "completed", "completed", "completed", "completed", "completed", "cycling" })
  check_controls(result.maps, 6)
  local function oscillation(order, penalty) return plain:cell(order, penalty).results.oscillation end
  check.near({ oscillation("N2", 1e2), oscillation("N2", 1e4), oscillation("N2-N2.2", 1e4) },
    { 0.00325, 0.1230, 0.0144 }, 5e-4)
  check.near(robust:cell("N2", 1e4).results.penetration, 3.23e-6, 1e-8)
  check_files(result, 7)
end)

check.case("peeling: rotation control fails at a turning point on the coarse mesh, arc length does not", function()
  local result = study("peeling", "meshes=m0", "orders=N2,N2-N2.1", "angle=40", "pitch=0.4")
  check.equal(outcomes(result.maps.rotation.plain), { "turning_point", "completed" })
  check.near(result.maps.rotation.plain:cell("N2", "m0").reached, 0.65, 0.02)
  check.equal(outcomes(result.maps.arc.plain), { "completed", "completed" })
  check_controls(result.maps.rotation, 2)
  check_controls(result.maps.arc, 2)
  check_files(result, 10)
end)

check.case("ironing back and forth: drag changes its sign; long steps fail while the die is pressed", function()
  local result = study("friction_steps", "orders=N2", "coarser=4,16", "friction=0,0.8")
  local plain = result.maps.N2.plain
  check.equal({ plain:converged() }, { 2, 4 })
  check.near(plain:cell(16, 0.8).reached, 0.37, 0.02)
  local results = plain:cell(4, 0.8).results
  check.near({ results["drag forward"], results["drag back"] }, { 0.812, -0.812 }, 1e-3)
  check_controls(result.maps.N2, 4)
  check_files(result, 5)
end)

check.case("locking: the force of L1 is too high the nearer nu comes to 0.5, that of N4 or of projected volume is not",
  function()
    local result = study("locking", "orders=L1,N2,N2:1,N4", "nu=0.45,0.499", "elements=4", "reference=8",
      "volumetric=pointwise,projected")
    for _, maps in pairs(result.maps) do check_controls(maps, 8) end
    check.equal({ result.reference:converged() }, { 2, 2 })
    local function off(order, nu, volumetric)
      return result.maps[volumetric or "pointwise"].robust:cell(order, nu).results.error
    end
    check.near({ off("L1", 0.45), off("L1", 0.499), off("N2", 0.45) }, { 0.2125, 1.537, 0.0085 }, 1e-3)
    check.near({ off("N4", 0.45), off("N4", 0.499) }, { 0.0047, 0.0104 }, 1e-3)
    check.near({ off("N2", 0.499), off("N2:1", 0.499) }, { 0.1328, 0.2209 }, 1e-3)
    local function projected(order) return off(order, 0.499, "projected") end
    check.near({ projected "L1", projected "N2", projected "N2:1" }, { 0.1066, 0.0133, 0.0062 }, 1e-3)
    check_files(result, 13)
  end)

check.case("first contact: an unconstrained body is singular before it touches; damping converges", function()
  local result = study("first_touch", "under=plane,slab,tool", "friction=0.3", "gaps=-1e-3,1e-3", "loads=1e-3")
  for _, key in ipairs { "plane_mu0.3", "slab_mu0.3", "tool_mu0.3" } do
    local plain = result.maps[key].plain
    check.equal(outcomes(plain), { "completed", "singular" })
    check_controls(result.maps[key], 2)
    local robust = result.maps[key].robust
    local function carried(map, gap) return map:cell(gap, 1e-3).results.carried end
    check.near({ carried(plain, -1e-3), carried(robust, 1e-3) }, { 1e-3, 1e-3 }, 1e-9)
    check.equal(robust:cell(1e-3, 1e-3).fallback_steps, 1)
  end
  check_files(result, 15)
end)

check.case("ironing under a constant force: deep steps stop plain Newton, controls carry P", function()
  local result = study("pressed_tool", "friction=0.2", "forces=0.02,0.4", "lengths=0.2")
  local map = result.maps["mu0.2"]
  check.equal(outcomes(map.plain), { "completed", "inverted" })
  check_controls(map, 2)
  for _, force in ipairs { 0.02, 0.4 } do
    check.near({ map.robust:cell(force, 0.2).results.carried }, { -force }, 1e-8)
  end
  local distant = study("pressed_tool", "friction=0.2", "forces=0.1", "lengths=0.2", "gap=0.05").maps["mu0.2"]
  check.equal({ distant.plain.cells[1].outcome, distant.robust.cells[1].outcome }, { "singular", "completed" })
  check_files(result, 5)
end)

check.case("cost: controls take no more iterations where nothing fails; the predictor saves a fourth", function()
  local result = study("cost", "orders=N2,N2-N2.2", "hertz=N2,N4", "coarser=2", "repeats=1")
  check.equal(#result.costs, 6)
  for _, cost in ipairs(result.costs) do
    check.equal({ cost.failed, cost.ratio <= 1.05 }, { false, true })
  end
  check.near({ result.costs[1].ratio, result.costs[2].ratio }, { 0.746, 0.70 }, 0.03)
  for _, guess in ipairs(result.guesses) do check.near(guess.saved, 28, 4) end
  check_files(result, 1)
end)

check.case("single controls: for an unconstrained body cutting alone fails, fallbacks converge", function()
  local words = { "under=plane", "friction=0", "gaps=1e-3", "loads=1e-3" }
  local function outcome(way)
    return study("first_touch", "with=" .. way, table.unpack(words)).maps.plane_mu0.robust.cells[1].outcome
  end
  check.equal({ outcome "cutting", outcome "fallback" }, { "minimum_step", "completed" })
end)

check.case("formulation=: mortar converges with penalties that over-constrain Gauss points, in all scenes", function()
  local maps = study("penalty_hertz", "formulation=equal", "orders=N2,N2-N2.2", "penalties=1e4,1e6", "mesh=m2").maps
  check.equal({ maps.plain:converged() }, { 4, 4 })
  check_controls(maps, 4)
  -- With Gauss points 0.0144 at 1e4, and N2-N2.2 cycles at 1e6 (above).
  check.at_most("oscillation", maps.plain:cell("N2-N2.2", 1e6).results.oscillation, 0.03)
  local ironing = study("friction_steps", "formulation=reduced", "orders=N2", "coarser=4", "friction=0.4").maps.N2
  check.within_share("drag", ironing.plain:cell(4, 0.4).results["drag forward"], 0.43, 0.05) -- Gauss points: 0.43
  study("deep_ironing", "formulation=half-passes", "points=p+1", "orders=N2", "coarser=8", "places=none")
  local touch = study("first_touch", "formulation=half-passes", "under=slab", "friction=0.3", "gaps=-1e-3",
    "loads=1e-3")
  check.near(touch.maps["slab_mu0.3"].plain:cell(-1e-3, 1e-3).results.carried, 1e-3, 1e-5)
end)

check.case("recovered cells: mortar converges with a penalty that makes Gauss points cycle", function()
  local result = check.study("formulations/recovered_cells", "coarse=yes", "maps=penalty_hertz",
    "formulations=equal,half-passes")
  check.equal(#result.rows, 1) -- half passes need a face as master
  local row = result.rows["penalty_hertz equal"]
  check.equal({ row.cells, row.gpts, row.converged, row.recovered, row.lost, row.controls }, { 2, 1, 2, 1, 0, 2 })
end)

check.case("a second call continues with the cells on request", function()
  local words = { "orders=N2", "penalties=1e2", "mesh=m1" }
  local first, folder = study("penalty_hertz", table.unpack(words))
  local wall = first.maps.plain.cells[1].wall
  words[4], words[5] = "keep=yes", "out=" .. folder
  check.equal(study("penalty_hertz", table.unpack(words)).maps.plain.cells[1].wall, wall)
end)

check.case("wrong arguments", function()
  check.fails(function() study("penalty_hertz", "penalties=0,1") end, "penalties must be positive numbers, got '0'")
  check.fails(function() study("penalty_hertz", "mesh=m7") end, "mesh must be 'm1', 'm2'")
  check.fails(function() study("deep_ironing", "points=p") end, "points must be values among 'p+1'")
  check.fails(function() study("locking", "mu=0.3") end, "unknown argument 'mu=0.3'", "reference=24")
  check.fails(function() study("first_touch", "gaps=wide") end, "gaps must be numbers")
  check.fails(function() study("deep_ironing", "points=p+1", "orders=N2", "coarser=16", "places=M2") end, "got 'M2'")
  check.fails(function() study("locking", "with=luck") end,
    "with must be 'robust', 'cutting', 'fallback' or 'prediction'")
  check.fails(function() study("first_touch", "formulation=half-passes") end, "needs under=slab")
  check.fails(function() study("penalty_hertz", "formulation=mortar") end, "formulation must be 'gpts'")
  check.fails(function() study("peeling", "keep=maybe") end, "keep must be yes or no")
end)
