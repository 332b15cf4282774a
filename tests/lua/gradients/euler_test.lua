-- Derivatives in generated scenes of all kinds: forces scale with the unit of stress, dF/d(unit) = F (Euler).

local check, sg, lists = require "check", require "signorini", require "signorini.call.lists"
local walk_scenes = require "walk_scenes"

local function scene_of(seed)
  return function(q)
    local scene = walk_scenes.describe(seed)
    scene.unit = q.unit
    local model, target = walk_scenes.build(scene)
    local stages = lists.map({ 1, 2 }, function(k)
      local to = scene.walk[k]
      return { name = "part " .. k, steps = 2, grip = target(to.x, math.abs(to.depth), to.angle) }
    end)
    return model, stages, { newton = { tolerance = 1e-12 } }
  end
end

-- Scenes whose faces touch: every formulation, model, load and obstacle is among them.
for _, seed in ipairs { 1, 2, 4, 5, 7, 11, 12, 13, 17, 20, 23, 27, 29, 34, 41, 42, 43 } do
  check.case(walk_scenes.text(walk_scenes.describe(seed)), function()
    local found = sg.gradients { scene = scene_of(seed), at = { unit = 1 } }
    local largest, most = 0, 0
    for _, name in ipairs(found.results) do
      if name:find "%.f[xyz]$" then
        local slopes = found:column(name, "unit")
        for row, value in ipairs(found.run:column(name)) do
          largest, most = math.max(largest, math.abs(value)), math.max(most, math.abs(slopes[row] - value))
        end
      end
    end
    check.equal({ found.run.reason, largest > 1e-6 }, { "completed", true })
    check.at_most("difference", most / largest, 1e-7)
    check.at_most("residual", found.residual, 1e-7)
  end)
end
