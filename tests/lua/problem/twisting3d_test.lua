-- twisting3d.lua, coarse: torques against μ∫pr dA and closed forms, levels, the energies' balance, its files.

require "check"

local turned, folder = check.study("problems/twisting3d", "parts=twist,punch", "orders=N2", "press=5", "twist=30")
local balance = check.study("problems/twisting3d", "parts=balance", "orders=N2", "press=5", "twist=1",
  "angle=2").balance

check.case("punches: every point slips round the axis; μ∫pr dA and the closed form of a uniform pressure, within 1 %",
  function()
    check.equal({ turned.punches[1].shape, turned.punches[2].shape }, { "square", "tube" })
    for _, punch in ipairs(turned.punches) do
      check.equal(punch.stick, 0)
      assert(punch.slip > 1000)
      check.near(punch.moment / punch.torque, 1, 0.01)
      check.near(punch.moment / punch.uniform, 1, 0.01)
      -- The punch's torque balances the tractions of the profile.
      check.near(punch.moment, punch.friction, 1e-10)
      -- Points slip along chords of 2° a step: their direction is off by half of it.
      check.near(punch.moment / punch.torque, math.cos(math.rad(1)), 5e-5)
    end
  end)

check.case("a tube of uniform pressure: the stiff column's force", function()
  -- The penalty's springs in a row with the column of height 1 and E = 10: 0.01 = p/100 + p/10 while strains are small.
  local area = math.pi * (1 - 0.5 ^ 2)
  check.near(turned.punches[2].force / area, 0.01 / (1 / 100 + 1 / 10), 0.005 * 0.0909)
end)

check.case("the hemisphere's torque rises, then levels at full slip at μ∫pr dA", function()
  local case = turned.cases[1]
  check.equal({ case.run.failed, #case.rows, case.reached }, { false, 35, 180 })
  for i = 7, 11 do assert(case.rows[i].moment > case.rows[i - 1].moment + 0.01, i) end
  for i = 1, 5 do check.near(case.rows[i].moment, 0, 1e-6) end
  assert(case.slips_from and case.slips_from < 120, case.slips_from)
  assert(case.rows[6].stick > case.rows[6].slip)
  check.near(case.swing, 0, 0.03)
  check.near(case.ratio, 1, 0.01)
end)

check.case("the results are unchanged", function()
  check.near(turned.cases[1].level, 0.3984, 0.0010)
  check.near(turned.cases[1].rows[35].force, 1.3100, 0.0030)
  check.near({ turned.punches[1].moment, turned.punches[2].moment }, { 0.139660, 0.083779 }, 1e-6)
end)

check.case("the energy error decreases with the steps", function()
  for i = 2, 3 do
    assert(math.abs(balance[i].imbalance) < 0.6 * math.abs(balance[i - 1].imbalance), balance[i].imbalance)
  end
  check.near(balance[3].imbalance, 0, 2e-3)
end)

check.case("curves, charts and pictures", function()
  check.near(sg.csv.read(folder .. "/N2_m1.csv"):column "moment"[35], turned.cases[1].rows[35].moment, 1e-9)
  check.pictures(folder, { "torque", "force", "states", "cut" })
end)

check.case("wrong arguments", function()
  check.refused("problems/twisting3d", {
    ["order=N2"] = "unknown argument 'order=N2'; did you mean 'orders'? known: angle=",
    ["parts=turn"] = "parts must be values among 'twist', 'punch' and 'balance', got 'turn'",
    ["meshes=m5"] = "meshes must be values among 'm1', 'm2', 'm3' and 'm4', got 'm5'",
    ["slave=die"] = "slave must be 'hemisphere' or 'cube', got 'die'",
    ["poles=top"] = "poles must be 'ends' or 'bottom', got 'top'",
    ["friction=never"] = "friction must be 'turn' or 'always', got 'never'",
    ["angle=0"] = "angle must be a positive number, got '0'",
    ["twist=x"] = "twist must be" })
end)
