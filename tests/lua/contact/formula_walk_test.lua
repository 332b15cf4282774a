-- A block walks through touch, stick, slip, reversal and release with each formula of an interface: every step
-- converges in the few iterations of quadratic convergence. With sg.plain{}, full Newton steps alone, a reversal under
-- friction by rate at contact points can cycle between states.

require "check"

core.quiet = true

local frictions = {
  number = 0.3,
  pressure = function(p) return 0.1 + 0.2 * sg.exp(-p) end,
  rate = function(_, v) return 0.2 + 0.1 * v / (v + 0.05) end,
  slip = function(_, _, slip) return 0.3 + 0.5 * slip end,
  place = function(_, _, _, X) return 0.2 + 0.1 * X end,
  static = { static = 0.35, kinetic = 0.3, over = 0.05 },
}
local pressures = {
  penalty = { penalty = 1e3 },
  square = { pressure = function(g) return 2e5 * sg.max(0, 0.005 - g) ^ 2 end, clearance = 0.005 },
  layer = { pressure = function(g, X) return -1e3 * (1 + 0.3 * X) * g end },
}

local function walk(contact)
  local body = sg.body{ patch = sg.shapes.rectangle{ width = 1, height = 0.5, corner = { 0, 0.008 } },
                        elements = {4, 2}, order = "N2", contact = "south",
                        material = sg.neo_hookean{ E = 100, nu = 0.3 } }
  contact.slave, contact.master = body:face "south", scenes.floor(0)
  local model = sg.model{ bodies = { block = body }, supports = { top = { on = body:face "north", drive = "xy" } },
                          contacts = { floor = contact } }
  return check.completed(model:run{ { name = "touch", steps = 2, top = { 0, -0.02 }, duration = 1 },
                                    { name = "stick", steps = 1, top = { 5e-4, -0.02 }, duration = 1 },
                                    { name = "slip", steps = 4, top = { 0.06, -0.022 }, duration = 2 },
                                    { name = "reversal", steps = 4, top = { -0.03, -0.02 }, duration = 2 },
                                    { name = "release", steps = 2, top = { -0.03, 0.01 }, duration = 1 } })
end

for law, keys in pairs(pressures) do
  for friction, mu in pairs(frictions) do
    for _, method in ipairs { "gpts", "mortar" } do
      check.case(("pressure %s, friction by %s, %s"):format(law, friction, method), function()
        local contact = { method = method, friction = { mu = mu, penalty = 1e3 } }
        for key, value in pairs(keys) do contact[key] = value end
        local run = walk(contact)
        check.equal(#run:column "iterations", 13)
        for _, iterations in ipairs(run:column "iterations") do check.at_most("iterations", iterations, 10) end
      end)
    end
  end
end
