-- scripts/formulations/load_and_hold.lua and swapped_faces.lua, coarse: forces while nothing moves, halved steps, slave
-- and master swapped.

require "check"

local hold, hold_folder = check.study("formulations/load_and_hold", "orders=N2-N2.2", "steps=20,40",
  "formulations=gpts,equal,equal-multipliers,reduced,reduced-multipliers", "hold=50")
local swap, swap_folder = check.study("formulations/swapped_faces", "orders=N2-N2.2", "meshes=m1,m2",
  "formulations=gpts,reduced,half-passes")

check.case("mortar: no creep in 50 steps, and the same drag with half as many steps", function()
  for _, name in ipairs { "equal", "equal-multipliers", "reduced", "reduced-multipliers" } do
    local one = hold.series["N2-N2.2 " .. name]
    for _, case in ipairs(one) do
      check.at_most(name .. ": first step", case.first, 1e-8)
      check.at_most(name .. ": later", case.later, 1e-8)
      check.at_most(name .. ": moved", case.moved, 1e-8)
    end
    check.at_most(name .. ": steps", one[1].drag / one[2].drag - 1, 1e-6)
  end
end)

check.case("Gauss points: the residual of slip falls with the step, and one step removes it", function()
  local one = hold.series["N2-N2.2 gpts"]
  check.within_share("first order", one[1].first / one[2].first, 2, 0.2)
  for _, case in ipairs(one) do
    check.at_most("first step", case.first, 1e-4)
    check.at_most("later", case.later, 1e-8)
  end
end)

check.case("slave and master swapped: no difference for half passes, for the others less on the finer mesh", function()
  local function difference(mesh, name, force) return swap.cases[("N2-N2.2 %s %s"):format(mesh, name)][force] end
  for _, force in ipairs { "drag", "press" } do
    for _, mesh in ipairs { "m1", "m2" } do
      check.at_most("half passes", difference(mesh, "half-passes", force), 1e-8)
      check.equal(difference(mesh, "gpts", force) > 1e-4, true)
    end
    check.at_most("mortar", difference("m2", "reduced", force), 0.5 * difference("m1", "reduced", force))
  end
end)

check.case("files and wrong arguments", function()
  check.pictures(hold_folder, { "N2-N2.2_steps" })
  check.pictures(swap_folder, { "N2-N2.2" })
  for name, wrong in pairs { load_and_hold = { ["steps=1"] = "steps must be" },
                             swapped_faces = { ["meshes=m9"] = "meshes must be" } } do
    check.refused("formulations/" .. name, wrong)
  end
end)
