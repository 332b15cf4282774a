-- A model of one spring for testing the load path without mechanics: fx = 2 ux, fy = 3 uy, contact area = −uy.
-- `fails(ux, uy)` gives the reason why a step is not solved, or nothing.

local function spring(fails)
  local model = { accepted = { 0, 0 }, next = { 0, 0 }, calls = {}, spent = 0 }
  local function note(what) model.calls[#model.calls + 1] = what end

  function model:support_names() return { "bed", "grip" } end
  function model:contact_names() return { "interface" } end
  function model:driven(name) return name == "grip" and { "x", "y" } or {} end
  function model:target(name) return name == "grip" and { self.accepted[1], self.accepted[2] } or {} end
  function model:set_target(_, target) self.next = { target[1], target[2] } end
  function model:solve_step(options)
    self.options, self.spent = options, self.spent + 1
    local reason = fails and fails(self.next[1], self.next[2])
    return { converged = not reason, iterations = reason and options.iterations or 3, reason = reason or "converged",
             message = reason and "no luck" or "", residuals = { 1, 1e-3, reason and 1e-2 or 1e-12 }, energies = {} }
  end
  function model:accept()
    note "accept"
    self.accepted = self.next
  end
  function model:rollback()
    note "rollback"
    self.next = self.accepted
  end
  function model:reaction(name)
    local u, sign = self.accepted, name == "bed" and -1 or 1
    return { 2 * sign * u[1], 3 * sign * u[2] }
  end
  function model:contact_resultant()
    return { fx = 0, fy = 0, area = -self.accepted[2], max_pressure = 1, max_penetration = 0, active = 1 }
  end
  function model:timings() return { bulk = self.spent * 1e-9, contact = 0, linear = 0 } end
  return model
end

return spring
