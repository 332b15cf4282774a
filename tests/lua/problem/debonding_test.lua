-- Double cantilever beams against the closed form of Rice's J integral: moment, growth, energies, oscillation.

require "check"

local E, nu, h, G = 70000, 0.3, 2, 0.3
local plane, inertia = E / (1 - nu^2), h^3 / 12
local exact = math.sqrt(G * plane * inertia)

check.case("steady moments M = sqrt(G E' h^3/12), work = energies, for both laws", function()
  local cases = check.study("problems/debonding", "elements=32", "steps=80").cases
  check.equal({ #cases, cases[1].law, cases[2].law }, { 2, "exponential", "bilinear" })
  for _, case in ipairs(cases) do
    check.within("moment", case.mean, 1, 0.002)
    check.within("balance", case.balance, 1, 0.001)
    check.at_most("oscillation", case.oscillation, 0.03)
    -- The crack grows by the rotation over the curvature M/(E' I), from 8 mm; the roots of the beams rotate, too.
    check.within("growth", 8 + case.debonded, math.rad(2.4) * plane * inertia / exact, 3.5)
  end
end)

check.case("moments oscillate less on finer meshes", function()
  local cases = check.study("problems/debonding", "elements=20,40", "laws=exponential").cases
  assert(cases[2].oscillation < 0.3 * cases[1].oscillation)
end)

check.case("wrong arguments are errors", function()
  check.refused("problems/debonding", {
    ["elements=2"] = "elements", ["laws=linear"] = "laws", ["strength=0"] = "strength",
    ["steps=1"] = "steps" })
end)
