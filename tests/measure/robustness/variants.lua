-- The same scene in other words: turned, moved, mirrored, in other units, with other directions of the patches, other
-- names, two threads, another linear solver, continued from a checkpoint, returned to a snapshot. Each variant must
-- have the same outcome and the same forces.

local checks = require "robustness.checks"
local dice = require "stability.generated.dice"
local frames = require "robustness.frame"

local variants = {}

-- ── Frames ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Whether a scene can be turned by any angle: no support holds single components.
local function turns_freely(scene)
  local size = scene.space and 3 or 2
  for _, support in pairs(scene.supports) do
    for _, key in ipairs{ "fix", "drive", "free" } do
      if support[key] and #support[key] < size then return false end
    end
    if support.symmetry or support.spring then return false end
  end
  return true
end

local quarter = { { { 0, -1 }, { 1, 0 } }, { { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 } } }

--- A rotation by an angle, in space about (1, 2, 3).
local function rotation(size, angle)
  local c, s = math.cos(math.rad(angle)), math.sin(math.rad(angle))
  if size == 2 then return { { c, -s }, { s, c } } end
  local n = { 1 / math.sqrt(14), 2 / math.sqrt(14), 3 / math.sqrt(14) }
  local matrix = {}
  for i = 1, 3 do
    matrix[i] = {}
    for j = 1, 3 do
      local k = 6 - i - j
      local sign = (j - i) % 3 == 1 and -1 or 1
      matrix[i][j] = (1 - c) * n[i] * n[j] + (i == j and c or sign * s * n[k])
    end
  end
  return matrix
end

local function turned(scene, roll)
  if scene.kind == "axisymmetric" then return nil end
  local size = scene.space and 3 or 2
  return { matrix = turns_freely(scene) and rotation(size, roll.uniform(0, 360)) or quarter[size - 1] }
end

local function moved(scene, _)
  if checks.has_tiny_parts(scene) then return nil end
  if scene.kind == "axisymmetric" then return { shift = { 0, -1e6 } } end
  return { shift = { 1e6, -0.7e6, scene.space and 0.4e6 or nil } }
end

local function mirrored(scene, _)
  if scene.space then return { matrix = { { -1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } } end
  if scene.kind == "axisymmetric" then return { matrix = { { 1, 0 }, { 0, -1 } } } end
  return { matrix = { { -1, 0 }, { 0, 1 } } }
end

local function reversed(scene, roll)
  local directions = {}
  for _, body in ipairs(scene.bodies) do
    local changes = { { { 1 }, { 2 } }, { { 1, 2 }, { 1 } }, { { 1, 2 }, { 2 } } }
    if scene.space then changes = { { { 1 }, { 2 } }, { { 2 }, { 3 } }, { { 1, 3 }, { 3 } }, { { 1, 2 }, { 3 } } } end
    local change = roll.one_of(changes)
    if body.patch then directions[body.name] = change end
  end
  return { directions = directions }
end

local function units(scene, roll)
  local pick = roll.integer(1, 3)
  return { length = pick ~= 2 and 10.0 ^ roll.integer(-9, 9) or nil,
           stress = pick ~= 1 and 10.0 ^ roll.integer(-9, 9) or nil }
end

local function swapped(scene, _)
  local formulation = scene.contacts[1] and scene.contacts[1].law.formulation
  if not (formulation and formulation:find("half", 1, true)) then return nil end
  return { swapped = true }
end

-- ── Runs ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

local function in_frame(options_of)
  return function(scene, roll)
    local options = options_of(scene, roll)
    return options and checks.solve(scene, frames.new(scene, options))
  end
end

local function with_threads(scene) return checks.solve(scene, nil, { threads = 2 }) end

local function with_other_solver(scene)
  return checks.solve(scene, nil, { linear = scene.options.linear == "umfpack" and "klu" or "umfpack" })
end

--- A run with checkpoints, killed by an error in a step and continued, and the same run without the kill.
local function resumed(scene, roll)
  local file = os.tmpname()
  local whole = checks.solve(scene, nil, { checkpoint = file })
  os.remove(file)
  if not whole.run or whole.run.steps < 2 then return whole, whole end
  local last = roll.integer(1, whole.run.steps - 1)
  checks.solve(scene, nil, { checkpoint = file, on_step = function(info)
    if info.step > last then error("killed", 0) end
  end })
  local rest = checks.solve(scene, nil, { checkpoint = file, resume = true })
  os.remove(file)
  return rest, whole
end

--- A run that writes a checkpoint after every step, which drops all that is known of past evaluations.
local function saved(scene)
  local file = os.tmpname()
  local account = checks.solve(scene, nil, { checkpoint = file })
  os.remove(file)
  return account
end

--- The stages after the first in a second run, after a detour: their end, a save, and back to a snapshot.
local function restored(scene)
  if #scene.stages < 2 then return nil end
  local function rest(detour)
    return function(model, stages, options)
      if model:run({ stages[1] }, options).failed then return stages end
      local later = table.move(stages, 2, #stages, 1, {})
      if detour then
        local snapshot, file = model:snapshot(), os.tmpname()
        model:run(later, options)
        model:save(file)
        os.remove(file)
        model:restore(snapshot)
      end
      return later
    end
  end
  return checks.solve(scene, nil, nil, rest(true)), checks.solve(scene, nil, nil, rest(false))
end

--- All variants: name, run(scene, roll) → an account, or nil where there is no such variant, and what it is compared
--- with (default: the scene itself); tolerance of forces, relative to the largest.
variants.all = {
  { name = "again", tolerance = 0, run = function(scene) return checks.solve(scene) end },
  { name = "turned", tolerance = 1e-6, run = in_frame(turned) },
  { name = "moved", tolerance = 1e-3, run = in_frame(moved) },
  { name = "mirrored", tolerance = 1e-6, run = in_frame(mirrored) },
  { name = "units", tolerance = 1e-6, run = in_frame(units) },
  { name = "reversed", tolerance = 1e-6, run = in_frame(reversed) },
  { name = "renamed", tolerance = 1e-6, run = in_frame(function() return { renamed = true } end) },
  { name = "swapped", tolerance = 1e-6, run = in_frame(swapped) },
  { name = "threads", tolerance = 0, run = with_threads },
  { name = "solver", tolerance = 1e-6, run = with_other_solver },
  { name = "resumed", tolerance = 0, run = resumed },
  { name = "restored", tolerance = 1e-6, run = restored },
  { name = "saved", tolerance = 1e-6, run = saved },
}
variants.names = {}
for i, variant in ipairs(variants.all) do variants.names[i], variants[variant.name] = variant.name, variant end

-- Forces of contacts with points = "auto" have this accuracy, relative to the largest.
local auto_points = 1e-4

--- Compares a scene, whose account is given, with a variant: what differs, in words, and its kind ("outcome", "reason",
--- "forces" or "found"), or nil; also the variant's account.
function variants.compare(scene, account, name)
  local variant = variants[name]
  local other, own = variant.run(scene, dice(scene.seed + 7919))
  if not other then return nil end
  own = own or account
  if other.reason == "stopped" then return nil end -- too many iterations to be compared
  local loose = scene.options.newton and scene.options.newton.tolerance or 0
  local tolerance = variant.tolerance > 0 and math.max(variant.tolerance, 1e3 * loose) or 0
  for _, contact in ipairs(scene.contacts) do -- rounding errors may add or remove points
    if tolerance > 0 and contact.law.points == "auto" then tolerance = math.max(tolerance, auto_points) end
  end
  local text, kind = checks.difference(own, other, tolerance)
  if not text and #other.found > #own.found then text, kind = table.concat(other.found, "; "), "found" end
  return text, kind, other
end

return variants
