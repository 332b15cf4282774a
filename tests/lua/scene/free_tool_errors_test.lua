-- Obstacles that supports free or rotate, and their loads: wrong input is an error that names the cure.

require "check"

local slab = scenes.body{ size = {2, 1}, elements = {4, 2}, contact = "north" }
local cube = scenes.body{ size = {1, 1, 1}, contact = "back" }
local disc = sg.rigid.cylinder{ center = {1, 1.5}, radius = 0.5 }
local plane = scenes.ceiling(1)
local ball = sg.rigid.sphere{ center = {0.5, 0.5, 1.5}, radius = 0.5 }

--- A model with these supports and loads besides a clamped slab; `keys`: others, and `tool` of the contact.
local function model(supports, loads, keys)
  keys = keys or {}
  local tool, body = keys.tool or disc, keys.body or slab
  local solid = body == cube
  supports.bed = { on = body:face(solid and "front" or "south"), fix = solid and "xyz" or keys.kind and "y" or "xy" }
  return sg.model{ bodies = { body = body }, supports = supports, loads = loads, kind = keys.kind,
                   contacts = { c = { slave = body:face(solid and "back" or "north"), master = tool, penalty = 10,
                                      friction = keys.friction } } }
end

local function refused(supports, loads, keys, ...) check.fails(function() model(supports, loads, keys) end, ...) end

check.case("loads on obstacles that do not follow them", function()
  refused({}, { F = { on = disc, force = {0, -1} } }, nil, "loads.F", "no support frees", 'free = "y"')
  refused({ t = { on = disc, drive = "y" } }, { F = { on = disc, force = {0, -1} } }, nil, "F", "no support frees")
  refused({ t = { on = disc, free = "y" } }, { M = { on = disc, moment = 1 } }, nil, "loads.M", 'angle = "free"')
  refused({ t = { on = disc, rotate = true } }, { M = { on = disc, moment = 1 } }, nil, "loads.M", 'angle = "free"')
  refused({}, { M = { on = slab:face "north", moment = 1 } }, nil, "loads.M", "moment", "obstacles")
  refused({ t = { on = disc, free = "y" } }, { F = { on = disc, force = {1} } }, nil, "loads.F", "force", "list of 2")
  refused({ t = { on = disc, free = "y" } }, { F = { on = disc, force = function() return {0, 0} end } }, nil, "F",
          "function")
  refused({ t = { on = disc, free = "y" } }, { F = { on = { disc, plane }, force = {0, -1} } }, nil, "F",
          "a load for each")
  refused({ t = { on = disc, free = "y" } }, { F = { on = disc, traction = {0, -1} } }, nil, "loads.F.on")
  refused({ t = { on = disc, free = "y", rotate = true, angle = "free" } }, { M = { on = disc, moment = {0, 1} } }, nil,
          "moment", "number")
end)

check.case("a tool that a force pulls away: no control point of the body is among the worst places", function()
  local pulled = model({ t = { on = disc, free = "y" } }, { w = { on = disc, force = { 0, 0.1 } } })
  local run = pulled:run { { steps = 1 } }
  check.holds(run.failure, "nothing holds the y of the obstacle that supports.t frees")
  check.equal({ #run.places, run.failure:find "Worst places" }, { 0, nil })
end)

check.case("components that are free and held", function()
  refused({ t = { on = disc, drive = "y", free = "y" } }, nil, nil, "frees y", "drives")
  refused({ t = { on = disc, free = "y" }, u = { on = disc, drive = "y" } }, nil, nil, "y", "drives", "frees")
  refused({ t = { on = disc, free = "y" }, u = { on = disc, free = "y" } }, nil, nil, "y", "frees")
  refused({ t = { on = { disc, plane }, free = "y" } }, nil, nil, "several obstacles", "a support for each")
  refused({ t = { on = disc, fix = "y", spring = {0, 1} } }, nil, nil, "spring", "y")
  refused({ t = { on = disc, drive = "y", spring = {1, 0} } }, nil, nil, "spring", 'free = "x"')
end)

check.case("rotations without a center or axis, or of what cannot rotate", function()
  refused({ t = { on = plane, rotate = true } }, nil, { tool = plane }, "center", "a point {x, y}")
  refused({ t = { on = disc, rotate = "z" } }, nil, nil, "rotate", "in the plane", "rotate = true")
  refused({ t = { on = ball, rotate = true } }, nil, { body = cube, tool = ball }, "rotate", "'x', 'y', 'z'")
  refused({ t = { on = disc, drive = "y", center = {0, 0} } }, nil, nil, "center", "rotate = true")
  refused({ t = { on = disc, free = "y", angle = "free" } }, nil, nil, "angle", "rotate = true")
  refused({ t = { on = disc, rotate = true, angle = "fixed" } }, nil, nil, "angle", "driven", "free")
  refused({ t = { on = disc, rotate = true, center = {0, 0, 0} } }, nil, nil, "center")
  refused({ t = { on = slab:face "west", rotate = true, center = {0, 0} } }, nil, nil, "center", "centroid")
  refused({ t = { on = { disc, slab:face "west" }, rotate = true } }, nil, nil, "obstacles and faces")
  refused({ t = { on = disc, rotate = true }, u = { on = disc, rotate = true } }, nil, nil, "rotates an obstacle")
  local sphere = sg.rigid.sphere{ center = {0, 1.5}, radius = 0.5 }
  refused({ t = { on = sphere, rotate = true } }, nil, { tool = sphere, kind = "axisymmetric" }, "axisymmetric")
  refused({ t = { on = sphere, free = "x" } }, nil, { tool = sphere, kind = "axisymmetric" }, "along the axis")
end)

check.case("what nothing holds", function()
  local smooth = { t = { on = disc, drive = "y", rotate = true, angle = "free" } }
  check.holds(model(smooth):warnings()[1], "supports.t", "no friction")
  local missing = model({ t = { on = disc, free = "xy" } }, { F = { on = disc, force = {0, 0.1} } })
  check.equal(missing:unconstrained_bodies(), { "t" })
  local run = missing:run({ { steps = 1 } }, sg.plain{})
  check.holds(run.failure, "nothing holds", "supports.t")
end)
