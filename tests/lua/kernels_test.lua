-- The same forces with every kernel that the processor has, and with every core type of OpenBLAS: contact with friction
-- in the plane and in space, on layers.

local check = require "check"
local core = require "signorini.core"

local code = [[
local function drag(dimension)
  local plane = dimension == 2
  local size = plane and { width = 2, height = 0.5 } or { size = { 2, 1, 0.5 } }
  local shape = plane and sg.shapes.rectangle or sg.shapes.block
  local slab = sg.body{ patch = shape(size), elements = plane and { 6, 2 } or { 4, 2, 2 },
                        order = plane and "N2-N2.1" or { "N2-N2.1", "N2-N2.1" },
                        contact = plane and "north" or "back", material = sg.neo_hookean{ E = 1, nu = 0.3 } }
  local names = plane and "xy" or "xyz"
  local tool = plane and sg.rigid.cylinder{ center = { 0.8, 0.8 }, radius = 0.3 }
    or sg.rigid.sphere{ center = { 0.8, 0.5, 0.8 }, radius = 0.3 }
  local model = sg.model{
    bodies = { slab = slab },
    supports = { bed = { on = slab:face(plane and "south" or "front"), fix = names },
                 grip = { on = tool, drive = names } },
    contacts = { interface = { slave = slab:face(plane and "north" or "back"), master = tool, penalty = 100,
                               friction = { mu = 0.3, penalty = 100 } } } }
  local deep, far = plane and { 0, -0.05 } or { 0, 0, -0.05 }, plane and { 0.1, -0.05 } or { 0.1, 0, -0.05 }
  local run = model:run{ { steps = 3, grip = deep }, { steps = 5, grip = far } }
  for _, name in ipairs { "fx", "fy", not plane and "fz" or nil } do
    for _, force in ipairs(run:column("grip." .. name)) do print(("%.17g"):format(force)) end
  end
end
drag(2)
drag(3)
]]

--- The forces, and the largest of them.
local function forces(variables)
  local output, status = check.program({ "-q", "--threads", "1", "-e", code }, "", "env " .. variables)
  if status ~= 0 then error(output) end
  local list, largest = {}, 0
  for line in output:gmatch "[^\n]+" do
    list[#list + 1] = assert(tonumber(line), line)
    largest = math.max(largest, math.abs(list[#list]))
  end
  return list, largest
end

--- Whether the processor has an instruction set.
local function has(name)
  return core.exists "/proc/cpuinfo" and core.read_file "/proc/cpuinfo":find("%f[%w]" .. name .. "%f[%W]") ~= nil
end

check.case("forces agree to 1e-9 of the largest", function()
  local variables = { "SIGNORINI_KERNEL=sse2" }
  if has "avx2" then variables[#variables + 1] = "SIGNORINI_KERNEL=avx2" end
  if has "avx512f" then variables[#variables + 1] = "SIGNORINI_KERNEL=avx512" end
  variables[#variables + 1] = "OPENBLAS_CORETYPE=Nehalem"
  if has "avx2" then variables[#variables + 1] = "OPENBLAS_CORETYPE=Haswell" end
  local first, largest = forces ""
  check.equal(#first, 2 * 8 + 3 * 8)
  assert(largest > 0.01)
  for _, settings in ipairs(variables) do
    local others = forces(settings)
    check.equal(#others, #first)
    for i, force in ipairs(others) do check.at_most(settings, (force - first[i]) / largest, 1e-9) end
  end
end)

check.done()
