-- 3D ironing with a spherical indenter: what varying-order layers do to the oscillation of the contact forces, how deep
-- the indenter can go, what friction adds, what an iteration costs.
--
-- Problem: a block whose bottom is a spherical cap (the indenter) is pressed into a slab and dragged along it. The
--          coarser and the less smooth the two faces, the more its forces oscillate with the slab's element pitch.
--
--                  ______
--                 |      |  indenter: 10 × 10 × 11 with a cap of radius R below, its top driven:
--                  \____/   down by 10.4 minus the gap in steps of 0.2, along by 75 in steps of 0.3,
--        _____________________________________________   its centre from x = 12.5 to 87.5
--       |  slab: 100 × 30 × 22, bottom clamped        |
--       |_____________________________________________|
--
--          Neo-Hooke, E = 1, nu = 0.3 both; penalty 100; slave: indenter; 3(p + 1) contact points per direction.
--          Meshes: 5 × 5 × 3 and 18 × 6 × 4 elements (coarse), doubled (fine). The thesis prints neither R nor the gap
--          before touching: R = 25.5 and gap = 5 (depth 5.4) are our choice. Without friction a state does not depend
--          on the way to it, so slide=window presses where the amplitudes' window begins and slides through it only.
--          variant=friction: mu = 0.3, tangential penalty 100: the drag over the pressing force, the energy balance.
--          variant=depth: how deep the indenter goes before the path turns back, by R and label.
--          variant=cost: time of a Newton iteration on four meshes and of N2-N2.2.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, section 7.5, Tables 7.10 and 7.11, Figures 7.28 to 7.32;
--         the geometry after I. Temizer, P. Wriggers, T. J. R. Hughes, CMAME 200 (2011) 1100-1112.
-- Units: any consistent ones; the thesis names none.
-- Expected: the degrees of freedom of Table 7.11 exactly. Table 7.10 is not reproduced: at R = 25.5 N3 and N2-N3 leave
--           29.4/34.9 and 27.4/34.5 % of N2's dPz/dPx (27.5/33.1 and 26.8/33.1 printed), N2-N2.1 32.9/51.7 (6.6/14.4);
--           at R = 7.5 N2-N3 57.9/53.6, N2-N2.1 10.8/32.1. Friction: Px/Pz = 0.306 on average for mu = 0.3. Depth: N2 at
--           R = 25.5 meets a turning point at 8.43 (see share/doc/problems/ironing3d.md).
-- Run: signorini scripts/ironing3d.lua [labels=N2,N3,N4,N2-N3,N2-N4,N2-N2.1,N2-N2.2] [fine=N2] [radius=25.5] [gap=5]
--      [slide=window] [down=0.2] [cap=1] [linear=auto] [out=out/ironing3d]; radius and gap may be lists; fine: labels
--      at the doubled mesh, or none; slide=full takes the whole path; down: length of the steps while it is pressed;
--      cap: biquadratic spans per direction that the sphere is drawn with.
--      signorini scripts/ironing3d.lua variant=friction [labels=N2] [radius=7.5] [gap=5] [mu=0,0.3] [way=30]
--      [finer=1] [penalty=100]; way: dragged through the slab's middle; finer divides the steps; penalty: both of them.
--      signorini scripts/ironing3d.lua variant=depth [labels=N2] [radius=7.5,12,25.5] [from=50,47.3]; from: x of the
--      indenter's centre.
--      signorini scripts/ironing3d.lua variant=cost [labels=N2] [mesh=sparse,coarse,middle,fine] [layered=N2-N2.2]
--      Threads: signorini --threads 2 scripts/ironing3d.lua …

local sg = require "signorini"
local problem = require "ironing3d.problem"
local variants = {
  standard = require "ironing3d.oscillation", friction = require "ironing3d.friction",
  depth = require "ironing3d.depth", cost = require "ironing3d.cost",
}

-- ── Arguments ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The arguments of each variant with their defaults.
local defaults = {
  standard = { labels = "N2,N3,N4,N2-N3,N2-N4,N2-N2.1,N2-N2.2", fine = "N2", radius = "25.5", gap = "5",
               cap = "1", slide = "window", down = "0.2", linear = "auto", out = "out/ironing3d" },
  friction = { labels = "N2", radius = "7.5", gap = "5", mu = "0,0.3", way = "30", finer = "1", penalty = "100",
               cap = "1", linear = "auto", out = "out/ironing3d_friction" },
  depth = { labels = "N2", radius = "7.5,12,25.5", from = "50,47.3", cap = "1", down = "0.2",
            linear = "auto", out = "out/ironing3d_depth" },
  cost = { labels = "N2", mesh = "sparse,coarse,middle,fine", layered = "N2-N2.2", linear = "auto",
           out = "out/ironing3d_cost" },
}

local function split(text)
  local parts = {}
  for part in text:gmatch "[^,]+" do
    if part ~= "none" then parts[#parts + 1] = part end
  end
  return parts
end

local function reject(name, expected, got) error(("%s must be %s, got '%s'"):format(name, expected, got), 0) end

--- A list of numbers of at least `least`, and less than `below` where that is given.
local function numbers(name, text, least, below)
  local expected = below and ("from %g to less than %g"):format(least, below) or ("of at least %g"):format(least)
  local list = split(text)
  for i, part in ipairs(list) do
    list[i] = tonumber(part)
    if not list[i] or list[i] < least or below and list[i] >= below then reject(name, "numbers " .. expected, text) end
  end
  return list
end

--- A whole number of at least 1.
local function whole(name, text)
  local number = math.tointeger(text)
  if not number or number < 1 then reject(name, "a whole number of at least 1", text) end
  return number
end

local function read_arguments(words)
  local given = {}
  for _, word in ipairs(words) do
    local key, value = word:match "^(%w+)=(.+)$"
    if not key then error(("unknown argument '%s'; arguments look like labels=N2"):format(word), 0) end
    given[key] = value
  end
  local variant = given.variant or "standard"
  if not defaults[variant] then reject("variant", "standard, friction, depth or cost", variant) end
  given.variant = nil
  local known = {}
  for key, value in pairs(defaults[variant]) do known[#known + 1] = key .. "=" .. value end
  table.sort(known)
  for key, value in pairs(given) do
    if not defaults[variant][key] then
      error(("unknown argument '%s=%s'; known: variant=%s, %s")
        :format(key, value, variant, table.concat(known, ", ")), 0)
    end
  end
  local o = setmetatable(given, { __index = defaults[variant] })
  local meshes = split(o.mesh or "coarse")
  for _, mesh in ipairs(meshes) do
    if not problem.meshes[mesh] then
      reject("mesh", "one or more of " .. table.concat(problem.mesh_names, ", "), o.mesh)
    end
  end
  if o.slide and o.slide ~= "window" and o.slide ~= "full" then reject("slide", "window or full", o.slide) end
  return {
    variant = variant, labels = split(o.labels), fine = split(o.fine or ""), layered = split(o.layered or ""),
    meshes = meshes, slide = o.slide, linear = o.linear, out = o.out,
    radii = numbers("radius", o.radius or "25.5", 7.1), gaps = numbers("gap", o.gap or "5", 0, problem.published_depth),
    from = numbers("from", o.from or "50", 5, 95), cap = whole("cap", o.cap or "1"),
    down = numbers("down", o.down or "0.2", 0.01)[1], mu = numbers("mu", o.mu or "0", 0),
    way = numbers("way", o.way or "30", 0.3, 76)[1], finer = numbers("finer", o.finer or "1", 0.25)[1],
    penalty = numbers("penalty", o.penalty or "100", 1e-6)[1],
  }
end

-- ── Files ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A list of what was written: path(name) adds to it; draw(name, need, body) adds the file of a chart that body(file)
--- has drawn, or says what it would have needed.
local function open_files(folder)
  sg.mkdir(folder)
  local files = {}
  function files.path(name)
    files[#files + 1] = folder .. "/" .. name
    return files[#files]
  end
  function files.draw(name, need, body)
    if body(folder .. "/" .. name) then files.path(name) else print(name .. " is left out: it needs " .. need) end
  end
  return files
end

-- ── The study ────────────────────────────────────────────────────────────────────────────────────────────────────────

local options = read_arguments(select("#", ...) > 0 and { ... } or arg)
local files = open_files(options.out)
local result = variants[options.variant].run(options, files)
print("\nWritten: " .. table.concat(files, "\n         "))
result.files = files
return result
