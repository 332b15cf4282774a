-- A random walk through states of a model, not all in equilibrium, and what must hold at each of them: the tangent is
-- the derivative of the residual, and both are those of another model of the same scene that has seen nothing but the
-- accepted states.

local core = require "signorini.core"
local sg = require "signorini"
local dice = require "generated.dice"
local product = require("tangents").product
local scenes = require "walk_scenes"

local walk = {}

-- ── Vectors and matrices ─────────────────────────────────────────────────────────────────────────────────────────────

local function largest(list)
  local most, place = 0, 0
  for i, value in ipairs(list) do
    if not (math.abs(value) <= most) then most, place = math.abs(value), i end
  end
  return most, place
end

--- a x + b y
local function combined(a, x, b, y)
  local sum = {}
  for i = 1, #x do sum[i] = a * x[i] + b * y[i] end
  return sum
end

--- The largest difference of the entries of two matrices, whose patterns may differ.
local function matrix_difference(one, other)
  local entries, most = {}, 0
  for k, value in ipairs(one.values) do entries[one.rows[k] * one.size + one.columns[k]] = value end
  for k, value in ipairs(other.values) do
    local key = other.rows[k] * other.size + other.columns[k]
    most = math.max(most, math.abs(value - (entries[key] or 0)))
    entries[key] = nil
  end
  for _, value in pairs(entries) do most = math.max(most, math.abs(value)) end
  return most
end

-- ── Checks of one state ──────────────────────────────────────────────────────────────────────────────────────────────

--- The residual at a distance from the present state, to which the model returns.
local function residual_at(model, distance, direction)
  model:move(combined(distance, direction, 0, direction))
  local residual = model:residual()
  model:move(combined(-distance, direction, 0, direction))
  return residual
end

local widths = { 1e-5, 2.5e-6 } -- of differences

--- The error of K v next to differences of the residual, relative to the largest entry of K v; nil at a kink, where the
--- differences to either side do not approach each other as the width decreases. Also returns the unknown.
local function tangent_error(model, residual, tangent, direction)
  local exact = product(tangent, direction)
  local scale = largest(exact)
  local central, apart = {}, {}
  for i, width in ipairs(widths) do
    local ahead, behind = residual_at(model, width, direction), residual_at(model, -width, direction)
    central[i] = combined(0.5 / width, ahead, -0.5 / width, behind)
    local bend = combined(1, ahead, 1, behind)
    apart[i] = largest(combined(1 / width, bend, -2 / width, residual))
  end
  local rounding = 1e-6 * scale
  if apart[2] > 0.4 * apart[1] + rounding then return nil end
  local spread = largest(combined(1, central[1], -1, central[2]))
  local error, place = largest(combined(1, central[2], -1, exact))
  return error > spread + rounding and error / scale or 0, place
end

-- ── The walk ─────────────────────────────────────────────────────────────────────────────────────────────────────────

local Walk = {}
Walk.__index = Walk

function Walk:report(what, ...)
  self.found[#self.found + 1] = ("step %d, trial %d: "):format(self.step, self.trial) .. what:format(...)
end

--- Where an unknown is.
function Walk:place(model, i)
  local u = model:unknowns()[i]
  return u and ("%s %s %s"):format(u.body or u.support, u.point or "", u.component) or ("multiplier %d"):format(i)
end

--- What moves all free unknowns of the upper body by (x, -depth), with noise on all of them.
function Walk:jump(model, x, depth, noise)
  local scene, change, names = self.scene, {}, model:unknowns()
  local by = scene.space and { x = x, y = 0.3 * x, z = -depth } or { x = x, y = -depth }
  for i = 1, #model:displacements() do
    local u = names[i]
    local follows = u and (u.body == "body" or u.support)
    change[i] = (follows and by[u.component] or 0) + noise * self.roll.uniform(-1, 1)
  end
  return change
end

--- Compares residual and tangent with those of the model that has seen less.
function Walk:compare(residual, tangent, change)
  local other = self.other
  other:set_target("grip", self.model_target)
  other:move(change)
  local here, there = other:residual(), other:tangent()
  local stiffness = largest(tangent.values)
  local force, place = largest(combined(1, residual, -1, here))
  if not (force <= self.tolerance * stiffness) then
    self:report("the residual differs from that of a fresh model by %.2g of the stiffness at %s", force / stiffness,
      self:place(other, place))
  end
  local matrix = matrix_difference(tangent, there)
  if not (matrix <= 1e2 * self.tolerance * stiffness) then
    self:report("the tangent differs from that of a fresh model by %.2g", matrix / stiffness)
  end
  other:rollback()
end

--- Trial states around the accepted one.
function Walk:try()
  local model, roll, scene = self.model, self.roll, self.scene
  local reach = scene.space and 0.15 or 0.4
  local x, depth = roll.uniform(-reach, reach), roll.uniform(-0.05, 0.05)
  local at = self.at
  self.model_target = self.target(at.x + x, at.depth + depth, at.angle + roll.uniform(-3, 3))
  model:set_target("grip", self.model_target)
  local sum
  for trial = 1, self.trials do
    self.trial = trial
    local change = self:jump(model, x, depth, roll.decades(1e-4, 1e-2))
    x, depth = roll.uniform(-0.3, 0.3) * reach, roll.uniform(-0.02, 0.02)
    model:move(change)
    sum = sum and combined(1, sum, 1, change) or change
    local ok, residual = pcall(model.residual, model)
    if not ok then break end -- an inverted element
    local tangent = model:tangent()
    self:log(residual, tangent.values)
    self.states = self.states + 1
    if self.other then self:compare(residual, tangent, sum) end
    if self.checks_tangent then
      local direction = {}
      for i = 1, #residual do direction[i] = roll.uniform(-1, 1) end
      local error, unknown = tangent_error(model, residual, tangent, direction)
      self.smooth = self.smooth + (error and 1 or 0)
      if error and error > 0 then
        self:report("the tangent is not the derivative of the residual: %.2g at %s", error, self:place(model, unknown))
      end
    end
  end
  model:rollback()
end

function Walk:log(...)
  for _, list in ipairs{ ... } do self.history[#self.history + 1] = core.pack(list) end
end

--- Constants that a path changes.
function Walk:change(model, what)
  local scene = self.scene
  local law = scene.law ~= "adhesion" and scene.law ~= "cohesive"
  if what == "factor" and law then return model:set_penalty_factor(1.5) end
  if not law then return end
  if what == "penalty" then model:set_contact("touch", { penalty = 1.3 * model:contact_law("touch").penalty }) end
  if what == "offset" then model:set_contact("touch", { offset = model:contact_law("touch").offset + 0.005 }) end
  if what == "mu" and scene.mu > 0 then model:set_contact("touch", { friction = { mu = 0.5 * scene.mu } }) end
  if what == "off" then model:set_contact("touch", { active = not model:contact_law("touch").active }) end
end

--- Solves a step of the path; where it fails, a smaller one. Returns whether one was accepted.
function Walk:advance(goal)
  local model, at = self.model, self.at
  for _, part in ipairs{ 1, 0.5, 0.25 } do
    local to = {}
    for key, value in pairs(at) do to[key] = value + part * (goal[key] - value) end
    local target = self.target(to.x, to.depth, to.angle)
    for _, one in ipairs(self.other and { model, self.other } or { model }) do
      one:set_target("grip", target)
      self:change(one, goal.change)
    end
    local result = model:solve_step(self.solver)
    if result.converged then
      if self.other and not self:follow() then return false end
      model:accept()
      self.at = to
      return true
    end
    model:rollback()
    if self.other then self.other:rollback() end
  end
  return false
end

--- Brings the other model to the converged state: with friction by a step of its own, since first touches are foreseen
--- at the guess of a step, which a move is not.
function Walk:follow()
  local model, other = self.model, self.other
  if self.scene.mu > 0 then
    if not other:solve_step(self.solver).converged then return false end
    other:accept()
    return true
  end
  local ok, message = pcall(function()
    other:move(combined(1, model:displacements(), -1, other:displacements()))
    other:accept()
  end)
  if not ok then self:report("a fresh model is not in equilibrium: %s", message) end
  return ok
end

--- Accepted states: equal results, and equilibrium.
function Walk:check_accepted()
  local model, other, scene = self.model, self.other, self.scene
  self.trial = 0
  self:log(model:displacements(), { table.unpack(model:reaction "bed") })
  local force = {}
  for _, name in ipairs(model:contact_names()) do
    local one = model:contact_resultant(name)
    if scene.law:find("half", 1, true) then force = nil end
    for i, c in ipairs(scene.space and { "fx", "fy", "fz" } or { "fx", "fy" }) do
      if force then force[i] = (force[i] or 0) + one[c] end
    end
  end
  local grip = model:reaction "grip"
  local down = scene.space and 3 or 2
  -- With points that change after a step, contact forces are those of the new points.
  local kept = scene.points ~= "auto" or scene.law:find("equal", 1, true) or scene.law:find("reduced", 1, true)
  if force and kept and not scene.rigid and not scene.revolved then
    local sign = scene.slave == "body" and 1 or -1
    local swapped = scene.law:find("swapped", 1, true) and -1 or 1
    local rest = grip[down] + swapped * sign * force[down]
    if math.abs(rest) > 1e-7 then self:report("the upper body is not in equilibrium: %.2g", rest) end
  end
  if not other then return end
  local a, b = model:energy(), other:energy()
  for name, value in pairs(a) do
    if math.abs(value - b[name]) > 1e3 * self.tolerance * (1 + math.abs(value)) then
      self:report("energy %s: %.12g, of a fresh model %.12g", name, value, b[name])
    end
  end
end

--- Layers at random places.
function Walk:move_layers()
  local lines = core.layer_lines(self.model, false)
  if #lines == 0 or self.scene.layer ~= "whole" then return end
  local raised = {}
  for i, line in ipairs(lines) do
    raised[i] = {}
    for e = 1, #line.raised do raised[i][e] = self.roll.uniform(0, 1) < 0.5 end
  end
  for _, one in ipairs(self.other and { self.model, self.other } or { self.model }) do
    local ok, message = pcall(core.follow, one, raised)
    if not ok then return nil, message end
  end
  self.moved = true
end

--- Saves the model; a loaded one has the same bits from then on.
function Walk:reload()
  local file = os.tmpname()
  self.model:save(file)
  if self.other then self.other:save(file .. "b") end
  local loaded = sg.load(file)
  os.remove(file)
  os.remove(file .. "b")
  local target = self.target(self.at.x + 0.01, self.at.depth + 0.01, self.at.angle)
  local now, results = self.model:displacements(), {}
  for i, model in ipairs{ self.model, loaded } do
    model:set_target("grip", target)
    model:move(combined(0, now, 0, now))
    local ok, residual = pcall(model.residual, model)
    if ok then
      results[i] = core.pack(residual) .. core.pack(model:tangent().values)
      local step = model:solve_step(self.solver)
      results[i] = results[i] .. core.pack(model:displacements()) .. core.pack(step.residuals)
    end
    model:rollback()
  end
  if results[1] ~= results[2] then self:report("a loaded model differs in bits") end
end

--- The residual a little farther along the path, from the accepted state, to which the model returns.
function Walk:glance()
  local model, at = self.model, self.remembered.at
  model:set_target("grip", self.target(at.x, at.depth + 0.04, at.angle))
  model:move(combined(0, self.remembered.now, 0, self.remembered.now))
  local ok, residual = pcall(model.residual, model)
  model:rollback()
  return ok and residual or nil
end

--- Remembers an accepted state.
function Walk:remember()
  self.remembered = { snapshot = self.model:snapshot(), at = self.at, now = self.model:displacements() }
  self.remembered.residual = self:glance()
end

--- Returns to it, and back again.
function Walk:recall()
  local remembered, model = self.remembered, self.model
  if not remembered or not remembered.residual or self.moved then return end
  local now = model:snapshot()
  model:restore(remembered.snapshot)
  local residual = self:glance()
  model:restore(now)
  local difference = residual and largest(combined(1, residual, -1, remembered.residual)) or 1
  local scale = largest(remembered.residual)
  if not (difference <= 1e-9 * scale + 1e-12) then
    self:report("the residual after a snapshot differs by %.2g of it", difference / scale)
  end
end

--- Walks through a scene. `options`: fresh (compare with a fresh model), tangent (compare with differences), trials per
--- step. Returns { found (deviations), states, smooth (compared tangents), history (bits) }.
function walk.run(scene, options)
  local model, target = scenes.build(scene)
  local self = setmetatable({
    scene = scene, model = model, target = target, roll = dice(scene.seed + 1000000), found = {}, history = {},
    states = 0, smooth = 0, step = 0, trial = 0, trials = options.trials or 2, checks_tangent = options.tangent,
    other = options.fresh and scenes.build(scene), at = { x = 0, depth = 0, angle = 0 },
    solver = { iterations = 40 }, tolerance = 1e-10, accepted = 0,
  }, Walk)
  for step, move in ipairs(scene.walk) do
    self.step = step
    self:try()
    local goal = { x = self.at.x + move.x, angle = self.at.angle + move.angle, change = move.change,
                   depth = scene.lift + move.depth }
    if not self:advance(goal) then break end
    self.accepted = self.accepted + 1
    self:check_accepted()
    if step == 1 then self:remember() end
    if step == 2 then self:move_layers() end
    if step == 3 and options.reload then
      self:reload()
      self:recall()
    end
  end
  self:try()
  return self
end

return walk
