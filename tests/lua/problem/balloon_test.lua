-- The inflated ball of scripts/problems/balloon.lua against the exact pressures beyond the limit point.

require "check"

check.case("pressures are those of the incompressible ball, and pass their greatest value", function()
  local laws = check.study("problems/balloon").laws
  for _, law in ipairs(laws) do
    check.at_most(law.name, law.error, 2e-3)
    local greatest, last = law.pressure[law.limit], law.pressure[#law.pressure]
    if not (law.limit < 10 and last < greatest) then error(law.name .. " has no limit point") end
  end
  -- neo-Hooke: dp/da = 0 at a = 1.603 for the radii 1 and 1.5; Mooney-Rivlin falls, then rises.
  check.within("radius at the limit", laws[1].radius[laws[1].limit], 1.603, 0.1)
  local least = math.huge
  for i = laws[2].limit, #laws[2].pressure do least = math.min(least, laws[2].pressure[i]) end
  if not (least < 0.95 * laws[2].pressure[laws[2].limit] and laws[2].pressure[#laws[2].pressure] > 1.02 * least) then
    error "Mooney-Rivlin does not rise again"
  end
end)

check.case("wrong arguments are errors", function()
  check.refused("problems/balloon", { ["outer=1"] = "outer", ["K=-1"] = "K", ["largest=0.5"] = "largest" })
end)
