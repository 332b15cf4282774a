-- Layers that follow the contact: the option adapt of model:run. Before steps the elements of the contact faces are
-- looked at, by lines: one per direction along a contact face of a body with a layer. Where a line must change, the
-- bodies get other rows of control points (core.follow, src/model/adapt/adaptation.hpp), and the run continues with
-- them. Accepted states, which are stored, saved and shown, are thus always in equilibrium.

local core = require "signorini.core"
local lists = require "signorini.call.lists"
local on_behalf_of = require "signorini.call.on_behalf_of"

local adapt = {}

-- How often the layers of a model have moved, and how often they had when a run was made.
local moves, at_run = setmetatable({}, { __mode = "k" }), setmetatable({}, { __mode = "k" })

function adapt.begin(run, model) at_run[run] = moves[model] or 0 end

--- True if layers have moved since the run was made: then the model has other control points than the run's states.
function adapt.has_moved_since(run, model) return (moves[model] or 0) ~= at_run[run] end

-- ── Elements of a line ───────────────────────────────────────────────────────────────────────────────────────────────

--- Where the layer is needed: the first and the last element of each range of neighboring elements in contact. With a
--- tolerance only elements count whose jump of tractions is larger, or a fourth of it where the layer is already: the
--- layer itself makes the jump smaller.
local function zones(line, tolerance)
  local found = {}
  for e, jump in ipairs(line.jump) do
    local least = tolerance and (line.raised[e] and tolerance / 4 or tolerance) or 0
    if jump > 0 and jump >= least then
      local last = found[#found]
      if last and last.to == e - 1 then last.to = e else found[#found + 1] = { from = e, to = e } end
    end
  end
  return found
end

--- The zone of the last time that is nearest to a zone.
local function nearest(zone, before)
  local best, distance
  for _, other in ipairs(before or {}) do
    local far = math.abs(other.from + other.to - zone.from - zone.to)
    if not distance or far < distance then best, distance = other, far end
  end
  return best or zone
end

--- The elements within `behind` of the zones, and within `ahead` of them where a zone has moved since the last time, by
--- which it will move again.
local function around(count, found, before, behind, ahead)
  local near = {}
  for e = 1, count do near[e] = false end
  for _, zone in ipairs(found) do
    local other = nearest(zone, before)
    local left, right = zone.from - other.from, zone.to - other.to
    local from = zone.from - (left < 0 and ahead - left or behind)
    local to = zone.to + (right > 0 and ahead + right or behind)
    for e = math.max(from, 1), math.min(to, count) do near[e] = true end
  end
  return near
end

local function count_true(flags) return #lists.filter(flags, function(flag) return flag end) end

--- The elements in which a line needs the layer, or nil if the present ones suffice. They change if elements are
--- missing, then ahead of the motion by twice the margin, or if there are half as many again as needed.
local function wanted(line, found, before, margin)
  if #found == 0 then return nil end
  local count = #line.jump
  local needed = around(count, found, before, margin, margin)
  local target = around(count, found, before, margin, 2 * margin)
  local missing = false
  for e = 1, count do missing = missing or needed[e] and not line.raised[e] end
  if missing or count_true(line.raised) > 1.5 * count_true(target) then return target end
end

-- ── Before steps ─────────────────────────────────────────────────────────────────────────────────────────────────────

local Adapt = {}
Adapt.__index = Adapt

--- "slab.north.1", for the data of a run.
local function name_of(line) return ("%s.%s.%d"):format(line.body, line.face, line.direction) end

local function energy(model)
  local now = model:energy()
  return now.stored + now.contact
end

--- Moves the layers and records this.
function Adapt:follow(model, run, raised, lines)
  local began, before = core.now(), energy(model)
  core.interrupted_run = run -- for the prompt, where Ctrl-C ends the construction of bodies
  local moved = on_behalf_of("model:run", "core.follow", core.follow, model, raised)
  core.interrupted_run = nil
  if not moved then return end
  if run.neighbors then run.neighbors:move_layers(raised) end
  moves[model] = (moves[model] or 0) + 1
  local elements = {}
  for i, line in ipairs(lines) do elements[name_of(line)] = count_true(raised[i]) end
  run.adaptations[#run.adaptations + 1] = {
    step = run.steps, unknowns = model:solver().unknowns, elements = elements, energy_before = before,
    energy_after = energy(model), wall = core.now() - began,
  }
  run:account("wall", core.now() - began)
  if self.verbose then require("signorini.run.verbose").adaptation(run.adaptations[#run.adaptations]) end
end

--- Before a step. What it remembers is in the run, which checkpoints save.
function Adapt:step(model, run)
  if run.steps % self.every ~= 0 then return end
  local lines, before, raised, changes = core.layer_lines(model, self.tolerance ~= nil), run.contact_zones, {}, false
  run.contact_zones = {}
  for i, line in ipairs(lines) do
    local name, found = name_of(line), zones(line, self.tolerance)
    run.contact_zones[name] = found
    local target = wanted(line, found, before[name], self.margin)
    raised[i], changes = target or line.raised, changes or target ~= nil
  end
  if changes then self:follow(model, run, raised, lines) end
end

-- ── Options ──────────────────────────────────────────────────────────────────────────────────────────────────────────

local none = {}
function none:step() end

--- What the option `adapt` requests: an object with step(). Raises an error if the model's layers cannot follow.
function adapt.options(model, options)
  local asked = options.adapt
  if not asked then return none end
  on_behalf_of("model:run", "core.check_following", core.check_following, model)
  return setmetatable({ every = asked.every, margin = asked.margin, tolerance = asked.tolerance,
                        verbose = options.verbose }, Adapt)
end

return adapt
