-- Solves generated scenes and judges what comes out: the outcome, finite results, equilibrium, and the comparison with
-- the same scene in another frame.

local build = require "robustness.build"
local frames = require "robustness.frame"
local oracles = require "robustness.oracles"

local checks = {}

local most_iterations = { plane = 120, space = 40 } -- of a run; more are stopped

-- ── Errors ───────────────────────────────────────────────────────────────────────────────────────────────────────────

-- What messages of internal errors contain.
local internal = { "attempt to ", "bad argument", "stack overflow", "std::", "bad_alloc", "vector::", "map::",
                   "basic_string", "not enough memory", "lua/signorini", "stack traceback", "number has no integer",
                   "invalid key", "Eigen", "assertion" }

--- What is wrong with an error message; nil if it names the line of these scripts and is not an internal error.
local function flaw_of_message(message)
  if type(message) ~= "string" then return "an error that is not a text" end
  local place, rest = message:match "^([^:\n]*%.lua:%d+): (.*)$"
  if not place then return "an error without the user's line" end
  if not place:find("robustness/", 1, true) then return "an error at a line that is not the user's" end
  for _, word in ipairs(internal) do
    if rest:find(word, 1, true) then return "an internal error" end
  end
end

-- ── Finite results ───────────────────────────────────────────────────────────────────────────────────────────────────

local function is_finite(value) return value == value and value ~= math.huge and value ~= -math.huge end

local fields = { "ux", "sxx", "von_mises", "I1" }

-- Where fields are evaluated: within the patch, in all corners and in the middle of edges.
local places = { plane = { { 0.3, 0.6 } }, space = { { 0.3, 0.6, 0.4 } } }
for i = 0, 1, 0.5 do
  for j = 0, 1, 0.5 do
    if i ~= 0.5 or j ~= 0.5 then table.insert(places.plane, { i, j }) end
    for k = 0, 1 do table.insert(places.space, { i, j, k }) end
  end
end

--- The first result of an accepted state that is not a finite number; nil if there is none.
local function infinite_result(model, run, scene, frame)
  for _, name in ipairs(run:columns()) do
    for _, value in ipairs(run:column(name)) do
      if not is_finite(value) then return "column " .. name end
    end
  end
  for _, value in ipairs(model:displacements()) do
    if not is_finite(value) then return "a displacement" end
  end
  for name, value in pairs(model:energy()) do
    if not is_finite(value) then return "energy " .. name end
  end
  for _, name in ipairs(model:contact_names()) do
    local profile = model:profile(name)
    for _, key in ipairs{ "x", "y", "X", "Y", "area", "pressure", "traction" } do
      for _, value in ipairs(profile[key]) do
        if not is_finite(value) then return ("profile %s.%s"):format(name, key) end
      end
    end
  end
  for _, name in ipairs(model:tie_names()) do
    for key, list in pairs(model:tie_profile(name)) do
      for _, value in ipairs(list) do
        if not is_finite(value) then return ("tie profile %s.%s"):format(name, key) end
      end
    end
  end
  for _, body in ipairs(scene.bodies) do
    for _, xi in ipairs(body.patch and places[scene.space and "space" or "plane"] or {}) do
      for _, field in ipairs(fields) do
        if not is_finite(model:sample(frame:name(body.name), field, xi)) then
          return ("field %s of %s at %s"):format(field, body.name, table.concat(xi, ", "))
        end
      end
    end
  end
end

-- Oddities whose details are not larger than the rounding error of coordinates of 1e6, or than that of normals there.
local tiny = { ["extreme aspect"] = true, ["extreme obstacle"] = true, ["narrow knot span"] = true,
               ["thin slab"] = true, ["points far away"] = true, ["huge gap"] = true }

--- Whether a scene has details that are tiny compared with its size.
function checks.has_tiny_parts(scene)
  for _, name in ipairs(scene.oddities) do
    if tiny[name] then return true end
  end
  return false
end

-- ── Contact ──────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A point of a contact by penalty at contact points that penetrates the master without a pressure; nil if none does.
local function missed_point(model, scene, frame)
  for _, contact in ipairs(scene.contacts) do
    local formulation, name = contact.law.formulation or "", frame:name(contact.name)
    local names = formulation == "gpts" and { name } or formulation == "half-passes" and { name, name .. ".master" }
    for _, one in ipairs(names or {}) do
      local law = model:contact_law(one)
      local profile = law.active and model:profile(one)
      local least = math.min(0, -law.offset) - 1e-7 * frame.length -- of points beyond the master's end
      for i, gap in ipairs(profile and profile.gap or {}) do
        if profile.state[i] == "open" and gap < least then
          return ("a point of contact %s is open, but its gap is %.3g"):format(contact.name, gap / frame.length)
        end
      end
    end
  end
end

-- ── Rounding errors ──────────────────────────────────────────────────────────────────────────────────────────────────

--- The rounding error of a row of the residual: ε |K| (|X| + |u|), in 3D four times that
--- (share/doc/reference/theory.md), with the largest coordinates of bodies and obstacles.
local function rounding_of_rows(model, scene, frame)
  local tangent, squares = model:tangent(), 0
  for k, row in ipairs(tangent.rows) do
    if row == tangent.columns[k] then squares = squares + tangent.values[k] ^ 2 end
  end
  local place, way, size = 0, 0, 2
  for _, name in ipairs(model:body_names()) do
    for _, point in ipairs(model:body(name):points()) do
      size = #point
      for _, x in ipairs(point) do place = math.max(place, math.abs(x)) end
    end
  end
  for _, obstacle in ipairs(scene.obstacles or {}) do
    for _, point in ipairs(obstacle.patch and obstacle.patch.points or { obstacle.center or obstacle.point }) do
      for _, x in ipairs(point) do place = math.max(place, math.abs(x) * frame.length) end
    end
  end
  for _, u in ipairs(model:displacements()) do way = math.max(way, math.abs(u)) end
  return (size == 2 and 1 or 4) * 0x1p-52 * math.sqrt(squares) * (place + way)
end

local function is_odd(scene, name)
  for _, one in ipairs(scene.oddities) do
    if one == name then return true end
  end
  return false
end

-- ── Equilibrium ──────────────────────────────────────────────────────────────────────────────────────────────────────

local force_names = { "fx", "fy", "fz" }

--- The magnitude of the sum of all external forces, and that of the largest; nil where the sum need not vanish.
local function imbalance(model, scene, frame)
  local supports = scene.supports -- corners and poles that two of them hold are part of both reactions
  if supports.all or supports.held_top and (supports.left or is_odd(scene, "collapsed side")) then return nil end
  local size, sum, most = scene.space and 3 or 2, { 0, 0, 0 }, 0
  local function add(force, sign)
    for i = 1, size do
      sum[i] = sum[i] + sign * force[force_names[i]]
      most = math.max(most, math.abs(force[force_names[i]]))
    end
  end
  local held = {} -- obstacles that have a support
  for name, support in pairs(scene.supports) do
    for _, on in ipairs(support.on) do
      if on.obstacle then held[on.obstacle] = true end
    end
    add(model:reaction(frame:name(name)), 1)
  end
  for name in pairs(scene.loads) do add(model:reaction(frame:name(name)), 1) end
  for _, contact in ipairs(scene.contacts) do
    local formulation, name = contact.law.formulation or "", frame:name(contact.name)
    if contact.law.points == "auto" then return nil end -- forces are those of the points chosen afterwards
    if contact.slave[1].obstacle then return nil end
    local force = model:contact_resultant(name)
    local obstacle = contact.master[1].obstacle
    if obstacle and not held[obstacle] then add(force, 1) end
    if formulation:find("half", 1, true) then
      add(force, 1)
      add(model:contact_resultant(name .. ".master"), 1)
    end
  end
  local axisymmetric = scene.kind == "axisymmetric"
  local rest = axisymmetric and math.abs(sum[2]) or math.max(math.abs(sum[1]), math.abs(sum[2]), math.abs(sum[3]))
  return rest, most
end

-- ── Runs ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

local function copy(from)
  local to = {}
  for key, value in pairs(from) do to[key] = value end
  return to
end

--- Solves a scene in a frame (default: its own). Returns an account: outcome ("refused", "completed", "ended"), detail
--- (the message, or the reason of the end), found (what must not be), forces (of all supports and contacts after each
--- step, in the scene's units and directions). `more`: further options of model:run; `before`: what is done with the
--- model and the options before; returns the stages of the run.
function checks.solve(scene, frame, more, before)
  frame = frame or frames.new(scene)
  local account = { found = {} }
  local function find(what, ...) account.found[#account.found + 1] = what:format(...) end
  local model, stages, run
  local ok, message = pcall(function() model, stages = build.model(scene, frame) end)
  if ok then
    local options, iterations = copy(scene.options), 0
    local limit = most_iterations[scene.space and "space" or "plane"] * (scene.patience or 1)
    options.threads = 1
    for key, value in pairs(more or {}) do options[key] = value end
    options.on_iteration = function()
      iterations = iterations + 1
      if iterations > limit then return "stop" end
    end
    ok, message = pcall(function()
      if before then stages = before(model, stages, options) end
      run = model:run(stages, options)
    end)
    account.iterations = iterations
  end
  if not ok then
    account.outcome, account.detail = "refused", message
    local flaw = flaw_of_message(message)
    if flaw then find("%s: %s", flaw, tostring(message)) end
    if account.iterations and account.iterations > 0 then find("an error after the first step: %s", message) end
    return account
  end
  account.reason = run.reason
  account.outcome = run.reason == "completed" and "completed" or "ended"
  account.detail = run.failed and (run.cause or run.reason) or run.reason
  account.steps, account.run, account.model = run.steps, run, model
  if scene.must == "complete" and run.reason ~= "completed" then find("it must complete: %s", account.detail) end
  local infinite = infinite_result(model, run, scene, frame)
  if infinite then find("%s is not finite", infinite) end
  if not frame.shift and not checks.has_tiny_parts(scene) then
    local missed = missed_point(model, scene, frame)
    if missed then find("%s", missed) end
  end
  local flaws = oracles.flaws(model, run, scene, frame)
  table.move(flaws, 1, #flaws, #account.found + 1, account.found)
  local rest, most = imbalance(model, scene, frame)
  -- A sum of n rows is wrong by √n times their error, and residuals within ten times the level have converged. The
  -- tangent comes last: forces are those of the last evaluation, which starts slips at the accepted state.
  account.rounding = 10 * math.sqrt(#model:displacements()) * rounding_of_rows(model, scene, frame)
  checks.forces(account, run, scene, frame)
  local told = oracles.has_warning(run.warnings, "rounding errors of forces")
  if account.outcome == "completed" and not infinite and not told then
    local tolerance = scene.options.newton and scene.options.newton.tolerance or 1e-10
    local unit = frame:force()
    if rest and rest > math.max(1e-8 * most, 100 * tolerance * account.most * unit) + account.rounding then
      find("external forces do not cancel: %.3g of %.3g", rest / unit, most / unit)
    end
  end
  return account
end

--- Forces of all steps, in the units and directions of the scene, and the energies at the end.
function checks.forces(account, run, scene, frame)
  local size, forces, most = scene.space and 3 or 2, {}, 0
  local unit = frame:force()
  local names = {}
  for name in pairs(scene.supports) do names[#names + 1] = name end
  table.sort(names)
  -- With slave and master exchanged a contact has the name of the other pass.
  for _, contact in ipairs(frame.swapped and {} or scene.contacts) do names[#names + 1] = contact.name end
  for _, name in ipairs(names) do
    local columns = {}
    for i = 1, size do columns[i] = run:column(("%s.%s"):format(frame:name(name), force_names[i])) end
    for step = 1, #columns[1] do
      for j = 1, size do
        local sum = 0
        for i = 1, size do sum = sum + frame.matrix[i][j] * columns[i][step] end
        if scene.kind == "axisymmetric" and j == 1 then sum = 0 end
        forces[#forces + 1] = sum / unit
        most = math.max(most, math.abs(sum / unit))
      end
    end
  end
  account.forces, account.most, account.noise = forces, most, account.rounding / unit
end

-- ── Comparison ───────────────────────────────────────────────────────────────────────────────────────────────────────

--- How two accounts differ; nil if they agree. `tolerance`: of forces, relative to the largest; 0: same bits.
function checks.difference(one, other, tolerance)
  local text = ("%s (%s), then %s (%s)"):format(one.outcome, one.detail, other.outcome, other.detail)
  if one.outcome ~= other.outcome then return text, "outcome" end
  if one.outcome == "refused" then return nil end
  if one.detail ~= other.detail then return text, "reason" end
  if one.steps ~= other.steps then return ("%d steps, then %d"):format(one.steps, other.steps), "outcome" end
  local most = 0
  for i = 1, math.min(#one.forces, #other.forces) do
    local difference = math.abs(one.forces[i] - other.forces[i])
    if not (difference <= most) then most = difference end
  end
  local noise = tolerance > 0 and 10 * math.max(one.noise, other.noise) or 0
  if not (most <= tolerance * math.max(one.most, other.most) + noise) then
    return ("forces differ by %.2g of %.3g, rounding %.2g"):format(most, one.most, noise), "forces"
  end
end

return checks
