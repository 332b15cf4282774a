-- model:modes: free vibration modes and stability of the accepted state.

local core = require "signorini.core"
local format_table = require("signorini.output.table").text
local lists = require "signorini.call.lists"
local methods = require "signorini.call.methods"
local named = require "signorini.call.named"
local on_behalf_of = require "signorini.call.on_behalf_of"

local Mode = {}
Mode.__index = Mode
Mode.__name = "mode"
core.types.mode = Mode
named.strict_type(Mode, "mode", "imaginary frequency growth rigid")
methods.guard("mode", "")

local Modes = {}
Modes.__index = Modes
Modes.__name = "modes"
core.types.modes = Modes
function Modes:__len() return rawlen(self) end
named.strict_type(Modes, "modes", "complete stable")
methods.guard("modes", "")

--- From { value, imaginary, mode, rigid }: motions φ exp(s t) with s² = -κ, of which one of each pair ±s grows.
local function mode_of(found)
  local real, imaginary = found.rigid and 0 or found.value, found.imaginary
  local size = math.sqrt(real ^ 2 + imaginary ^ 2)
  local oscillates, grows = real > 0 or imaginary ~= 0 or found.rigid, real < 0 or imaginary ~= 0
  return setmetatable({ value = real, imaginary = imaginary ~= 0 and imaginary or nil, mode = found.mode,
    frequency = oscillates and math.sqrt((size + real) / 2) / (2 * math.pi) or nil,
    growth = grows and math.sqrt((size - real) / 2) or nil, rigid = found.rigid }, Mode)
end

local function motion_of(mode)
  if mode.rigid then return "rigid: " .. mode.rigid end
  if mode.growth then return mode.frequency and "grows, oscillating" or "grows" end
  return ""
end

function Mode:__tostring()
  local what = self.rigid and motion_of(self) or self.frequency and ("frequency %.6g"):format(self.frequency)
    or ("growth rate %.6g"):format(self.growth)
  return ("mode with value %.6g, %s"):format(self.value, what)
end

local function verdict(modes)
  if modes.stable == nil then return "whether the state is stable is undecided" end
  return modes.stable and "the state is stable" or "the state is unstable"
end

function Modes:__tostring()
  local rows = lists.map(self, function(mode)
    return { mode.value, mode.frequency or "", mode.growth or "", motion_of(mode) }
  end)
  for i, row in ipairs(rows) do table.insert(row, 1, i) end
  local lines = { format_table { columns = { "mode", "value", "frequency", "growth", "motion" }, rows = rows },
    verdict(self) }
  return table.concat(lists.joined(lines, self.warnings), "\n")
end

--- The method model:modes.
return function(model, options)
  local found, list = on_behalf_of("model:modes", "core.modes", core.modes, model, options.count)
  return setmetatable(lists.merged(found, lists.map(list, mode_of)), Modes)
end
