-- Problems on which compare.lua compares formulations at equal error: scenes of studies/accuracy, whose settings are
-- formulations and penalties here. A problem has orders, meshes and settings, which are combined; results also contain
-- the numbers of steps and cuts.

local deviation = require "formulations.deviation"

--- A problem with the entries of another one, and its own; wrap(model, results) changes results.
local function derived(base, own)
  local scene = base.scene
  own.scene = function(o)
    local model, path, measure, options = scene(o)
    return model, path, function(run)
      local results = measure(run)
      results.steps, results.cuts = run.steps, run.cutbacks
      if own.wrap then own.wrap(model, results) end
      return results
    end, options
  end
  return setmetatable(own, { __index = base })
end

local ironing = derived(require "studies.accuracy.ironing", {
  orders = { "N2", "N2-N2.2" }, meshes = { "m1", "m2", "m3" },
  settings = { "default", "mortar equal", "mortar reduced", "multipliers", "half passes" },
})

-- Mortar contact has pressures per reference area. The area under the contact shrinks by (1 + nu)(1 − 2 nu) p/E, more
-- than the error of a formulation.
local hertz = derived(require "studies.accuracy.hertz", {
  orders = { "N2", "N2-N2.2" }, meshes = { "m1", "m2", "m3", "m4" },
  settings = { "default", "penalty × 10", "mortar equal", "mortar equal + penalty × 10", "multipliers" },
  wrap = function(model, results)
    local mortar = model:contact_law("ground").method == "mortar"
    results.profile.pressure = deviation.cauchy_pressures(model:profile "ground", mortar)
  end,
})

local cylinder = derived(require "studies.accuracy.cylinder", {
  title = "A stiff half pipe on a soft slab", orders = { "N2", "N2-N2.1" }, meshes = { "m1", "m2" },
  settings = { "default", "mortar equal", "multipliers", "reduced multipliers" },
})

return { ironing = ironing, hertz = hertz, cylinder = cylinder }
