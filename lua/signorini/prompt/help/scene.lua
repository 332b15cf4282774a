-- A half ring is pressed into a slab.
function press(order, mesh)
  local die = sg.body{
    patch = sg.shapes.half_annulus{ inner = 0.3, outer = 0.5, center = {0.75, 1.5} },
    elements = {6 * mesh, mesh}, order = order, contact = "south", thickness_degree = 1,
    material = sg.neo_hookean{ E = 1000, nu = 0.3 },
  }
  local slab = sg.body{
    patch = sg.shapes.rectangle{ width = 3, height = 1 },
    elements = {8 * mesh, 2 * mesh}, order = order, contact = "north", thickness_degree = 1,
    material = sg.neo_hookean{ E = 1, nu = 0.3 },
  }
  local model = sg.model{
    bodies = { die = die, slab = slab },
    supports = { bed = { on = slab:face "south", fix = "xy" },
                 grip = { on = {die:face "west", die:face "east"}, drive = "xy" } },
    contacts = { interface = { slave = die:face "south", master = slab:face "north", penalty = 100 } },
  }
  return model, { { name = "press", steps = 4, grip = {0, -0.1} } }
end

-- A coating is tied to a block.
block = sg.body{ patch = sg.shapes.rectangle{ width = 2, height = 1 }, elements = {4, 2}, order = "N2",
                 material = sg.linear_elastic{ E = 1, nu = 0.3 } }
coating = sg.body{ patch = sg.shapes.rectangle{ width = 2, height = 0.1, corner = {0, 1} }, elements = {6, 1},
                   order = "N2", material = sg.linear_elastic{ E = 10, nu = 0.3 } }
coated = sg.model{
  bodies = { block = block, coating = coating },
  supports = { bed = { on = block:face "south", fix = "xy" }, grip = { on = coating:face "north", drive = "xy" } },
  ties = { seam = { slave = coating:face "south", master = block:face "north" } },
}
coated:run{ { name = "shear", steps = 1, grip = {0.01, 0} } }

-- Two patches are joined to a beam.
left = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1 }, elements = {2, 2}, order = "N2",
                material = sg.neo_hookean{ E = 1, nu = 0.3 } }
right = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 1, corner = {1, 0} }, elements = {2, 2},
                 order = "N2", material = sg.neo_hookean{ E = 1, nu = 0.3 } }

model, stages = press("N2-N2.2", 1)
die, slab = model:body "die", model:body "slab"
patch = sg.shapes.rectangle{ width = 3, height = 1 }
run = model:run(stages)
files = sg.files "out/press"
modes = model:modes{ count = 2 }
mode = modes[1]
finer = press("N2-N2.2", 2)
finer:run(stages)

-- Bodies of two patches.
pair = sg.body{ patch = { sg.shapes.rectangle{ width = 1, height = 1 },
                          sg.shapes.rectangle{ width = 1, height = 1, corner = {1, 0} },
                          boundaries = { top = { "1.north", "2.north" } } },
                elements = {2, 2}, order = "N2", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
cubes = sg.body{ patch = { sg.shapes.block{ size = {1, 1, 1} },
                           sg.shapes.block{ size = {1, 1, 1}, corner = {1, 0, 0} } },
                 elements = {1, 1, 1}, order = "N2", material = sg.neo_hookean{ E = 1, nu = 0.3 } }

-- A cube is compressed.
cube = sg.body{ patch = sg.shapes.block{ size = {1, 1, 1} }, elements = {2, 2, 2}, order = "N2",
                material = sg.neo_hookean{ E = 1, nu = 0.3 } }
solid = sg.model{
  bodies = { cube = cube },
  supports = { bed = { on = cube:face "front", fix = "xyz" },
               top = { on = cube:face "back", drive = "z", fix = "xy" } },
}
solid:run{ { name = "press", steps = 1, top = {-0.2} } }

-- The ring with two discretizations on two meshes; the reference force, of a fine mesh, is 0.0768.
function force_of(case)
  local model, stages = press(case.order, case.mesh)
  local force = -model:run(stages):column "grip.fy"[4]
  return { force = force, error = math.abs(force / 0.0768 - 1) }
end
study = sg.study{ name = "press", cases = sg.grid{ order = {"N2", "N2-N2.2"}, mesh = {1, 2} }, run = force_of }
study:execute{ jobs = 2 }
comparison = sg.work_precision(study, { error = "error" })

map = sg.convergence_map{
  x = { name = "order", values = {"N2", "N2-N2.2"} }, y = { name = "steps", values = {1, 4} }, jobs = 2,
  scene = function(order) return (press(order, 1)) end,
  path = function(_, _, steps) return { { name = "press", steps = steps, grip = {0, -0.1} } } end,
}

-- How the force changes with the depth.
function press_to(q)
  return press("N2", 1), { { name = "press", steps = 4, grip = {0, -q.depth} } }
end
gradients = sg.gradients{ scene = press_to, at = { depth = 0.1 } }
fit = sg.fit{ scene = press_to, start = { depth = 0.1 },
  data = { { y = "grip.fy", points = { {2, -0.01}, {4, -0.02} } } } }
optimum = sg.optimize{ scene = press_to, start = { depth = 0.1 }, bounds = { depth = {0.09, 0.1} }, least = "grip.fy" }
