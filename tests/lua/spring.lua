-- A model of one spring for testing the load path without mechanics: fx = 2 ux, fy = 3 uy, contact area = −uy; a
-- support that turns, with moment = 5 angle; and a load, a pressure.
-- `fails(ux, uy, model)` gives the reason why a step is not solved, or nothing; model.accepted is where it starts from.

local function spring(fails)
  local model = { accepted = { 0, 0 }, next = { 0, 0 }, calls = {}, spent = 0, needs = 3 }
  local targets, next_targets = { edge = { 0 }, gas = { 0 } }, {}
  local driven = { grip = { "x", "y" }, edge = { "angle" }, gas = { "pressure" } }
  local function note(what) model.calls[#model.calls + 1] = what end

  function model:support_names() return { "bed", "edge", "grip" } end
  function model:load_names() return { "gas" } end
  function model:driven_names() return { "edge", "grip", "gas" } end
  function model:body_names() return {} end
  function model:contact_names() return { "interface" } end
  function model:contact_law() return { enforcement = "penalty" } end
  function model:driven(name) return driven[name] or {} end
  function model:target(name)
    if name == "grip" then return { self.accepted[1], self.accepted[2] } end
    return targets[name] and { targets[name][1] } or {}
  end
  function model:set_target(name, target)
    if name == "grip" then self.next = { target[1], target[2] } else next_targets[name] = { target[1] } end
  end
  function model:solve_step(options)
    self.options, self.spent = options, self.spent + 1
    local reason = fails and fails(self.next[1], self.next[2], self)
    self.failure = reason
    return { converged = not reason, iterations = reason and options.iterations or self.needs,
             reason = reason or "converged", message = reason and "no luck" or "",
             residuals = { 1, 1e-3, reason and 1e-2 or 1e-12 }, energies = {} }
  end
  --- solve_step in as many calls as it has residuals.
  function model:iterate(options)
    self.under_way = self.under_way or { left = 3, result = self:solve_step(options) }
    local step = self.under_way
    step.left = step.left - 1
    if step.left == 0 then
      self.under_way = nil
      return step.result
    end
    return { converged = false, iterations = 3 - step.left, reason = "iterating", message = "", energies = {},
             residuals = table.move(step.result.residuals, 1, 3 - step.left, 1, {}) }
  end
  function model:accept()
    note "accept"
    self.accepted = self.next
    for name, target in pairs(next_targets) do targets[name] = target end
  end
  function model:rollback()
    note "rollback"
    self.next, self.under_way = self.accepted, nil
  end
  function model:diagnose()
    return { reason = self.failure, message = "no luck", cure = "be lucky", places = {}, unbalanced = {} }
  end
  function model:unconstrained_bodies() return {} end
  function model:free_motion() return {} end
  function model:warnings() return {} end
  function model:snapshot() return { self.accepted[1], self.accepted[2] } end
  function model:restore(saved) self.accepted, self.next = saved, saved end
  function model:last_length() return 0 end -- no length to look for a turning point with
  function model:reaction(name)
    local u, sign = self.accepted, name == "bed" and -1 or 1
    if name == "edge" then return { 0, 0, 5 * targets.edge[1] } end
    if name == "gas" then return { 0, -7 * targets.gas[1] } end
    return { 2 * sign * u[1], 3 * sign * u[2] }
  end
  function model:contact_resultant()
    return { fx = 0, fy = 0, area = -self.accepted[2], max_pressure = 1, max_penetration = 0, active = 1,
             unsettled = 0 }
  end
  function model:profile() return { gap = { 1 } } end
  function model:energy() return { stored = 0, contact = 0, friction = 0, work = 0, area_growth = 0, debonding = 0,
                                      wear = 0 } end
  function model:timings() return { bulk = self.spent * 1e-9, contact = 0, linear = 0 } end
  return model
end

return spring
