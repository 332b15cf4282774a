-- Materials, contacts and controls of generated scenes.

local sg = require "signorini"
local formulations = require "formulations.rows"
local lists = require "signorini.call.lists"

-- Formulations with their frequencies
local drawn = { "gpts", "gpts", "equal", "equal-multipliers", "equal-multipliers", "reduced", "reduced-multipliers",
                "reduced-multipliers", "half-passes", "half-passes-equal", "half-passes-reduced" }

local laws = {}

-- ── Materials ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Constants of a law, as plain data; `stress`: its moduli.
function laws.draw_material(scene, roll, E)
  local law = roll.one_of{ "neo_hookean", "neo_hookean", "neo_hookean", "linear_elastic", "linear_elastic",
                           "mooney_rivlin", "yeoh", "ogden", "saint_venant_kirchhoff", "energy", "stretches", "fibers" }
  local nu = roll.uniform(0, 0.4)
  if scene:odd(0.15, "extreme Poisson's ratio") then nu = roll.one_of{ -0.99, -0.5, 0.49, 0.499, 0.4999, 0.499999 } end
  if scene:odd(0.15, "extreme stiffness") then E = E * roll.decades(1e-9, 1e9) end
  local material = { law = law, E = E, nu = nu }
  if law == "fibers" then
    local angle = roll.uniform(0, 180)
    local up = scene.space and roll.uniform(-1, 1) or nil
    material.fiber = { math.cos(math.rad(angle)), math.sin(math.rad(angle)), up }
    if scene:odd(0.1, "fiber of length zero") then material.fiber = scene.space and { 0, 0, 0 } or { 0, 0 } end
  end
  if scene:odd(0.03, "unstable law") then material.E, material.unstable = E, true end
  return material
end

function laws.material(data, frame)
  local E, nu = data.E * frame.stress, data.nu
  local mu, K = E / (2 * (1 + nu)), E / (3 * (1 - 2 * nu))
  if data.unstable and data.law ~= "neo_hookean" then mu = -mu end
  local makers = {
    mooney_rivlin = function() return sg.mooney_rivlin{ c10 = 0.4 * mu, c01 = 0.1 * mu, K = K } end,
    yeoh = function() return sg.yeoh{ c10 = 0.5 * mu, c20 = -0.01 * mu, c30 = 0.001 * mu, K = K } end,
    ogden = function() return sg.ogden{ mu = { 0.9 * mu, -0.1 * mu }, alpha = { 2, -2 }, K = K } end,
    energy = function()
      return sg.hyperelastic{ energy = function(I1, _, J)
        return 0.5 * mu * (I1 - 3) - mu * sg.log(J) + 0.5 * K * sg.log(J) ^ 2
      end }
    end,
    stretches = function()
      return sg.hyperelastic{ stretches = function(l1, l2, l3)
        local J = l1 * l2 * l3
        return mu / 3 * (l1 ^ 3 + l2 ^ 3 + l3 ^ 3 - 3) - 3 * mu / 3 * sg.log(J) + 0.5 * K * (J - 1) ^ 2
      end }
    end,
    fibers = function()
      return sg.hyperelastic{ fibers = { frame:direction(data.fiber) }, energy = function(I1, _, J, I4)
        return 0.5 * mu * (I1 - 3) - mu * sg.log(J) + 0.5 * K * sg.log(J) ^ 2 + 0.5 * mu * (I4 - 1) ^ 2
      end }
    end,
  }
  return (makers[data.law] or function() return sg[data.law]{ E = E, nu = nu } end)()
end

-- ── Contacts ─────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The constants of a contact; `stiffness`: E of the softer body.
function laws.draw_contact(scene, roll, rigid, stiffness)
  local contact = { penalty = roll.decades(5, 60) * stiffness, mu = math.max(0, roll.uniform(-0.3, 0.7)) }
  local special = roll.uniform(0, 1)
  if special < 0.06 then
    contact.adhesion = { hamaker = 5e-4 * stiffness, r0 = 0.1 }
  elseif special < 0.12 then
    contact.cohesive = { strength = 0.2 * stiffness, energy = 0.01 * stiffness, law = roll.one_of{ "exponential",
                         "bilinear" } }
  else
    local function suits(name) return not (formulations[name].two_faces and rigid) end
    contact.formulation = roll.one_of(lists.filter(drawn, suits))
  end
  if scene:odd(0.1, "extreme penalty") then contact.penalty = contact.penalty * roll.decades(1e-9, 1e9) end
  if scene:odd(0.1, "extreme friction") then contact.mu = roll.one_of{ 1.5, 5, 100 } end
  if scene:odd(0.1, "extreme friction penalty") then
    contact.friction_penalty = contact.penalty * roll.decades(1e-6, 1e6)
  end
  contact.points = roll.one_of{ false, false, "auto", 4 }
  if scene:odd(0.1, "unusual number of points") then contact.points = roll.one_of{ 1, 30 } end
  if contact.formulation == "gpts" then contact.per = roll.one_of{ false, false, "reference" } end
  if not contact.adhesion and not contact.cohesive then
    contact.offset = roll.one_of{ 0, 0, 0, 0.01, -0.01 }
    if scene:odd(0.1, "extreme offset") then contact.offset = roll.uniform(-1, 1) * roll.decades(0.1, 100) end
    if roll.uniform(0, 1) < 0.1 then contact.overlap = "interference" end
  end
  if roll.uniform(0, 1) < 0.05 then contact.active = false end
  if roll.uniform(0, 1) < 0.05 then contact.where = roll.uniform(-0.5, 0.5) end
  return contact
end

--- The table of sg.model; slave and master are those of the frame.
function laws.contact(data, slave, master, frame)
  local per_length = frame.stress / frame.length
  local contact = { slave = slave, master = master }
  if data.adhesion then
    contact.adhesion = { hamaker = data.adhesion.hamaker * frame.stress * frame.length ^ 3,
                         r0 = data.adhesion.r0 * frame.length }
    return contact
  end
  contact.penalty = data.penalty * per_length
  if data.mu > 0 then
    contact.friction = { mu = data.mu, penalty = (data.friction_penalty or data.penalty) * per_length }
  end
  contact.overlap, contact.per, contact.active = data.overlap, data.per or nil, data.active
  contact.offset = data.offset and data.offset * frame.length
  if data.where then contact.where = function(X) return frame:back(table.unpack(X))[1] < data.where end end
  if data.cohesive then
    contact.cohesive = { strength = data.cohesive.strength * frame.stress, law = data.cohesive.law,
                         energy = data.cohesive.energy * frame.stress * frame.length }
    if data.points ~= "auto" then contact.points = data.points or nil end
    return contact
  end
  local row = formulations[data.formulation]
  local at_points = row.keys.multipliers == nil and row.keys.method ~= "mortar"
  if data.points and (data.points ~= "auto" or at_points) then contact.points = data.points end
  contact = formulations.contact(row, contact, data.friction_penalty ~= nil)
  if frame.swapped and row.keys.method == "half_passes" then
    contact.slave, contact.master = contact.master, contact.slave
  end
  return contact
end

-- ── Controls ─────────────────────────────────────────────────────────────────────────────────────────────────────────

--- The options of model:run, as plain data.
function laws.draw_options(scene, roll)
  local options = {}
  local kind = roll.one_of{ "default", "default", "default", "plain", "single" }
  if kind == "plain" then
    options = sg.plain{}
  elseif kind == "single" then
    local pick = roll.integer(1, 11)
    if pick == 1 then options.arc_length = true
    elseif pick == 2 then options.predictor = roll.one_of{ "tangent", "constant", "linear" }
    elseif pick == 3 then options.newton = { line_search = roll.one_of{ "residual", "energy" } }
    elseif pick == 4 then options.newton = { freeze_active_set = true }
    elseif pick == 5 then options.newton = { active_set_changes = 3 }
    elseif pick == 6 then options.linear = roll.one_of{ "klu", "umfpack", "reuse", "condensed" }
    elseif pick == 7 then options.damping = true
    elseif pick == 8 then options.pseudo_transient = true
    elseif pick == 9 then options.penalty = { start = 0.1, steps = 3 }
    elseif pick == 10 then options.adapt = { every = 1, margin = 1 }
    else options.step = { adaptive = true, max = 0.5, min = 1 / 256, growth = 1.5 } end
  end
  if scene:odd(0.1, "few iterations") then options.newton = { iterations = roll.integer(1, 3) } end
  if scene:odd(0.1, "odd tolerance") then options.newton = { tolerance = roll.one_of{ 1e-16, 1e-3, 0.5, 1e5 } } end
  return options
end

return laws
