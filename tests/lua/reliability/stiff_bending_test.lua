-- Elements of degree 1 in bending: the warning states the part of the stiffness that is too much; without bending there
-- is none.

require "check"

local function warned(run)
  for _, text in ipairs(run.warnings) do
    local percent = text:match "elements of degree 1 cannot: (%S+) %%"
    if percent then return tonumber(percent) end
  end
end

--- A cantilever of height 1 under a force at its tip: deflection over that of beam theory, and the warning's percents.
local function cantilever(length, options)
  local material = (options.material or sg.linear_elastic){ E = 1e6, nu = options.nu or 0 }
  local body = scenes.body{ size = {length, 1}, elements = options.elements or { 10, 1 }, order = options.order or "N1",
    thickness_degree = options.thickness_degree, contact = options.thickness_degree and "north" or nil,
    material = material }
  local model = scenes.model{ bodies = { b = body }, supports = { wall = { on = "west", fix = "xy" } },
                          loads = { tip = { on = "east", traction = { 0, 0 } } } }
  local force = -1e-3
  local run = check.completed(model:run({ { steps = 1, tip = { 0, force } } }, sg.plain{}))
  local beam = force * length ^ 3 / (3 * 1e6 / (1 - (options.nu or 0) ^ 2) / 12)
  return model:sample("b", "uy", { 1, 0.5 }) / beam, warned(run)
end

check.case("the part of the stiffness that is too much is that of the warning", function()
  -- Elements of length h = L/10: 1 + (G/E) h² of the exact stiffness, but for the shear of short beams
  for _, length in ipairs { 20, 100, 1000 } do
    for _, material in ipairs { sg.linear_elastic, sg.neo_hookean } do
      local deflection, percent = cantilever(length, { material = material })
      check.within("deflection", deflection, 1 / (1 + 0.5 * (length / 10) ^ 2), 0.03)
      check.within("percent", percent, 100 * (1 - deflection), 3)
    end
  end
  -- Poisson's effect: one linear element across the thickness is stiff by its modulus of confined compression
  local deflection, percent = cantilever(40, { elements = { 10, 1 }, order = "N2", thickness_degree = 1, nu = 0.3 })
  check.within("percent", percent, 100 * (1 - deflection), 3)
  check.within("percent", percent, 100 * (0.3 / 0.7) ^ 2, 3)
end)

check.case("degree 2 and short elements of degree 1 are right, without a warning", function()
  for _, options in ipairs { { order = "N2" }, { order = "N2", nu = 0.3 }, { elements = { 80, 4 } } } do
    local deflection, percent = cantilever(20, options)
    check.within("deflection", deflection, 1, 0.06)
    check.equal(percent, nil)
  end
end)

check.case("bodies that are compressed, stretched or rotated do not bend", function()
  for _, solid in ipairs { false, true } do
    local patch = solid and sg.shapes.block{ size = { 2, 1, 1 } } or sg.shapes.rectangle{ width = 2, height = 1 }
    for _, nu in ipairs { 0, 0.3, 0.4 } do
      local body = scenes.body{ patch = patch, elements = solid and { 4, 2, 2 } or { 4, 2 }, order = "N1", nu = nu }
      local all = solid and "xyz" or "xy"
      local model = scenes.model{ bodies = { b = body }, supports = { wall = { on = "west", fix = all },
                              pull = { on = "east", drive = all } } }
      for _, x in ipairs { -0.1, 0.2 } do
        check.equal(warned(model:run({ { steps = 2, pull = solid and { x, 0, 0 } or { x, 0 } } }, sg.plain{})), nil)
      end
    end
  end
  local turned = scenes.model{ bodies = { b = { size = {2, 1}, elements = { 4, 2 }, order = "N1" } },
    supports = { turn = { on = "west", fix = "xy", rotate = true } } }
  check.equal(warned(turned:run({ { steps = 4, turn = 90 } }, sg.plain{})), nil)
end)
