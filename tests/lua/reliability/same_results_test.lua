-- What does not decide the results of a run: the direction of the slave face, and what a solver still knows of former
-- steps (theory.md, "Mirrored, turned and resumed runs").

require "check"

core.quiet = true
package.path = core.home .. "/scripts/stability/?.lua;" .. package.path
local sg = require "signorini"
local scenes = require "generated.scenes"

check.case("friction is the same in a run that drops its factorizations after every step", function()
  local file = check.file()
  for _, case in ipairs { { "plane", 48 }, { "plane", 93 }, { "space", 11 } } do
    local scene = scenes.describe(table.unpack(case))
    local _, account = scenes.solve(scene, sg.robust{ linear = "reuse" })
    local _, saved = scenes.solve(scene, sg.robust{ linear = "reuse", checkpoint = file })
    check.equal({ account.ending, saved.ending }, { "completed", "completed" })
    check.at_most(("%s %d"):format(table.unpack(case)), scenes.difference(account, saved), 1e-9)
  end
end)

check.case("steps that are cut are the same with slave faces in the other direction", function()
  for _, seed in ipairs { 12, 31 } do
    local scene = scenes.describe("plane", seed)
    scene.law = { method = "mortar", enforcement = "multipliers" }
    scene.steps = { press = scene.steps.press // 3, drag = scene.steps.drag // 3 }
    local _, account = scenes.solve(scene, sg.robust{ linear = "klu" })
    local _, image = scenes.solve(scene, sg.robust{ linear = "klu" }, true)
    check.equal({ account.ending, account.iterations, account.cutbacks },
      { "completed", image.iterations, image.cutbacks })
    check.at_most("seed " .. seed, scenes.difference(account, image), 1e-9)
  end
end)
