-- ironing3d.lua: Table 7.11, symmetry and path independence of its forces, maximum depth, friction, files.

require "check"

local depth = require "problems.ironing3d.depth"
local friction = require "problems.ironing3d.friction"
local problem = require "problems.ironing3d.problem"

local study, folder = check.study("problems/ironing3d", "orders=N2", "fine=none", "radius=7.5", "gap=9.6")

check.case("Table 7.11: every entry", function()
  check.equal({ #study.dofs, study.differences }, { 8, 0 })
  check.equal({ study.dofs[1].slab.interface, study.dofs[8].indenter.bulk }, { 480, 2592 })
end)

check.case("forces are mirror images about the slab's middle", function()
  local case = study.sets[1].cases["N2 coarse"]
  check.equal({ case.run.failed, #case.x }, { false, 18 })
  check.within("middle", case.x[9], 50, 1e-9)
  for i = 1, 8 do
    check.within("Pz", case.Pz[9 - i], case.Pz[9 + i], 1e-8)
    check.within("Px", case.Px[9 - i], -case.Px[9 + i], 1e-8)
  end
  check.within("Px in the middle", case.Px[9], 0, 1e-8)
end)

check.case("oscillations on the coarse mesh at depth 0.8", function()
  local case = study.sets[1].cases["N2 coarse"]
  check.near({ case.dPz.raw_percent, case.dPx.raw_percent }, { 100, 100 }, 1e-9)
  check.within("dPz", case.dPz.raw, 0.12705, 1e-4)
  check.within("dPx", case.dPx.raw, 0.04909, 1e-4)
  check.equal(case.dPx.raw, math.max(table.unpack(case.run:column "grip.fx", 4)) -
    math.min(table.unpack(case.run:column "grip.fx", 4)))
end)

check.case("files: a run's columns, oscillations, two charts, a sheet of states", function()
  check.equal(#study.files, 5)
  local read = sg.csv.read(folder .. "/N2_coarse_R7.5_gap9.6.csv")
  check.equal(read:column "grip.fz", study.sets[1].cases["N2 coarse"].run:column "grip.fz")
  check.equal(sg.csv.read(folder .. "/oscillations_R7.5_gap9.6.csv"):column "dPz_printed_percent", { 100 })
  check.pictures(folder, { "forces_R7.5_gap9.6", "oscillations_R7.5_gap9.6", "states_R7.5_gap9.6" })
end)

check.case("without friction a state does not depend on the path", function()
  local case = { order = "N2", mesh = "sparse", radius = 7.5, depth = 2 }
  local function solve(from, distance)
    return problem.solve{ order = case.order, mesh = case.mesh, radius = case.radius, depth = case.depth, from = from,
                          distance = distance }
  end
  local slid, pressed = solve(44.3, 3), solve(47.3, 0)
  check.within("Pz", slid.Pz[10], pressed.pressed, 1e-8)
  check.within("Px", slid.Px[10], pressed.run:column "grip.fx"[10], 1e-8)
end)

check.case("the sparse mesh converges to the full depth", function()
  local case = depth.solve{ order = "N2", mesh = "sparse", radius = 7.5, from = 50 }
  check.equal({ case.run.failed, case.run.cutbacks, #case.states }, { false, 0, 52 })
  check.within("depth", case.states[52].depth, 10.4, 1e-12)
  check.within("Pz", case.states[52].Pz, 97.646, 1e-2)
end)

check.case("the mean drag over a pitch is mu times the pressing force, zero without friction", function()
  local function drag(mu)
    local case = friction.solve{ order = "N2", mesh = "sparse", radius = 7.5, depth = 2, mu = mu, distance = 15 }
    check.equal(case.run.failed, false)
    return case.ratio, case.model:contact_resultant "interface"
  end
  local ratio, state = drag(0.3)
  check.equal(state.slipping, state.active)
  check.within("Px/Pz", ratio, 0.2987, 1e-3)
  check.within("Px/Pz without friction", drag(0), 0, 1e-3)
end)

check.case("cost: a row per mesh and order, parts that add up", function()
  local result = check.study("problems/ironing3d", "variant=cost", "mesh=sparse", "layered=none")
  check.equal({ #result.cases, #result.layered, #result.files }, { 1, 0, 1 })
  local case = result.cases[1]
  check.equal(case.dofs, 720)
  check.within("time", case.bulk + case.contact + case.linear + case.rest, case.iteration, 1e-12)
end)

check.case("a layer on the strip that the indenter touches: fewer unknowns, the same oscillation to 5 %", function()
  local whole, strip, path = table.unpack(check.study("problems/ironing3d", "variant=layers", "orders=N2-N2.1",
    "mesh=sparse", "mu=0", "from=47.2", "down=2.7").cases)
  -- 9 + 2 + 9 functions along the slab's row, 3 + 2 + 3 across it; one element across is raised, three along
  check.equal({ whole.dofs.slab.total - strip.dofs.slab.total, strip.dofs.slab.total - path.dofs.slab.total },
    { 3 * 20 * 2, 3 * 6 * 6 })
  check.within("dPz", strip.dPz.raw, whole.dPz.raw, 0.05 * whole.dPz.raw)
  check.within("dPx", strip.dPx.raw, whole.dPx.raw, 0.05 * whole.dPx.raw)
end)

check.case("wrong arguments", function()
  check.refused("problems/ironing3d", {
    ["ordrs=N2"] = "unknown argument 'ordrs=N2'; did you mean 'orders'? known with variant=standard: cap=1",
    ["N2"] = "unknown argument 'N2'", ["radius=5"] = "radius must be numbers, 7.1 or more, got '5'",
    ["gap=11"] = "gap must be numbers, 0 or more and below 10.4, got '11'",
    ["variant=steep"] = "variant must be 'standard', 'cost', 'depth', 'friction' or 'layers', got 'steep'",
    ["slide=half"] = "slide must be 'window' or 'full', got 'half'",
    ["cap=0"] = "cap must be a whole number, 1 or more",
    ["variant=cost mesh=m1"] = "mesh must be values among 'sparse', 'coarse', 'middle' and 'fine', got 'm1'",
  })
end)
