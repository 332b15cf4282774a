-- Random walks through generated scenes (walk_scenes.lua, walk.lua). Many more, for minutes:
--   signorini tests/lua/reliability/walk_test.lua 1 2000

require "check"
local scenes = require "walk_scenes"
local walk = require "walk"

core.quiet = true
local first, last = tonumber(arg[1] or 1), tonumber(arg[2] or 16)

check.case("tangents are derivatives; what models keep from earlier states changes nothing", function()
  local states, smooth, accepted = 0, 0, 0
  for seed = first, last do
    local scene = scenes.describe(seed)
    local result = walk.run(scene, { fresh = true, tangent = true, reload = true })
    states, smooth, accepted = states + result.states, smooth + result.smooth, accepted + result.accepted
    if #result.found > 0 then error(scenes.text(scene) .. "\n  " .. table.concat(result.found, "\n  ")) end
  end
  local count = last - first + 1
  assert(states > 5 * count and smooth > 3 * count and accepted > 2 * count,
    ("%d states, %d of them smooth, %d accepted"):format(states, smooth, accepted))
end)

check.case("moved layers: slips start at the same feet, whether points were skipped before or not", function()
  local scene = scenes.describe(2137) -- half passes with reduced multipliers, friction
  local result = walk.run(scene, { fresh = true })
  if #result.found > 0 then error(scenes.text(scene) .. "\n  " .. table.concat(result.found, "\n  ")) end
end)

check.case("two threads give the bits of one", function()
  local before = core.threads
  for seed = first, first + (last - first) // 4 do
    local scene, bits = scenes.describe(seed), {}
    for threads = 1, 2 do
      core.set_threads(threads)
      bits[threads] = walk.run(scene, {}).history
    end
    if table.concat(bits[1]) ~= table.concat(bits[2]) then error(scenes.text(scene)) end
  end
  core.set_threads(before)
end)
