-- The same forces with every kernel that the processor has, and with every core type of OpenBLAS: contact with friction
-- in the plane and in space, on layers, Hertz's contact, ironing of two bodies. With an argument also those of another
-- program, such as one of another architecture that tests/set-up/aarch64 runs:
--   signorini tests/lua/reliability/kernels_test.lua ['<command of the other program>']

require "check"

local code = [[
local function show(name, number) print(("%s: %.17g"):format(name, number)) end
local function forces(name, run, dimension)
  for i = 1, dimension do
    for _, force in ipairs(run:column("grip.f" .. ("xyz"):sub(i, i))) do show(name, force) end
  end
end
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
  forces("drag in " .. dimension .. "D", model:run{ { steps = 3, grip = deep }, { steps = 5, grip = far } }, dimension)
end
local function hertz(body)
  local model, path = sg.scenes.hertz{ body = body, order = "N2-N2.1" }
  model:run(path)
  local resultant = model:contact_resultant "ground"
  for _, name in ipairs { "area", "max_pressure" } do show(body .. " " .. name, resultant[name]) end
end
local function ironing()
  local model, path = sg.scenes.ironing{ depth = 0.1, distance = 0.1, order = "N2-N2.1" }
  path[1].steps, path[2].steps = 3, 5
  forces("ironing", model:run(path), 2)
end
drag(2)
drag(3)
hertz "cylinder"
hertz "ball"
ironing()
]]

--- The forces, as list of { name of the scene, force }, and the largest of each scene.
local function forces(command)
  local source = check.file()
  core.write_file(source, 'local sg = require "signorini"\n' .. code)
  local list, largest = {}, {}
  for line in check.ended({ check.shell(("%s -q --threads 1 '%s'"):format(command, source)) }, 0):gmatch "[^\n]+" do
    local name, force = line:match "^(.+): (.+)$"
    list[#list + 1] = { assert(name, line), assert(tonumber(force), line) }
    largest[name] = math.max(largest[name] or 0, math.abs(force))
  end
  return list, largest
end

--- Whether the processor has an instruction set. Kernel plain: another architecture than x86-64.
local plain = core.versions.kernel == "plain"
local function has(name)
  return not plain and core.exists "/proc/cpuinfo"
    and core.read_file "/proc/cpuinfo":find("%f[%w]" .. name .. "%f[%W]") ~= nil
end

check.case("forces agree to 1e-9 of the largest", function()
  local this = ("'%s'"):format(arg[-1])
  local commands = {}
  local function with(variable) commands[#commands + 1] = ("env %s %s"):format(variable, this) end
  with(plain and "SIGNORINI_KERNEL=plain" or "SIGNORINI_KERNEL=sse2")
  if has "avx2" then with "SIGNORINI_KERNEL=avx2" end
  if has "avx512f" then with "SIGNORINI_KERNEL=avx512" end
  with(plain and "OPENBLAS_CORETYPE=ARMV8" or "OPENBLAS_CORETYPE=Nehalem")
  if has "avx2" then with "OPENBLAS_CORETYPE=Haswell" end
  if arg[1] then commands[#commands + 1] = arg[1] end
  local first, largest = forces(this)
  check.equal(#first, 2 * 8 + 3 * 8 + 2 * 2 + 2 * 8)
  for name, force in pairs(largest) do assert(force > 0.001, name) end
  for _, command in ipairs(commands) do
    local others, worst, names = forces(command), {}, {}
    check.equal(#others, #first)
    for i, other in ipairs(others) do
      local name, force = table.unpack(first[i])
      check.equal(other[1], name)
      local difference = math.abs(other[2] - force) / largest[name]
      check.at_most(("%s, %s"):format(command, name), difference, 1e-9)
      if not worst[name] then names[#names + 1] = name end
      worst[name] = math.max(worst[name] or 0, difference)
    end
    if command == arg[1] then
      for _, name in ipairs(names) do print(("%s: differs by %.1e of the largest value"):format(name, worst[name])) end
    end
  end
end)
