-- What is measured on two sheared blocks: stick zone, tangential traction, slip of the sticking points.

local deviation = require "formulations.deviation"
local problem = require "formulations.partial_slip.problem"

local measures = {}

--- The parameters of the points of the master's face that are opposite to a profile's points in the contact, with their
--- displacement; x of the face increases with the parameter.
function measures.opposite(model, profile)
  local function x_at(xi) return problem.width * (2 * xi - 1) + model:sample("lower", "ux", { xi, 1 }) end
  local list = {}
  for i, x in ipairs(profile.x) do
    if math.abs(x) <= problem.half_width then
      local low, high = 0, 1
      for _ = 1, 50 do
        local middle = (low + high) / 2
        if x_at(middle) < x then low = middle else high = middle end
      end
      list[#list + 1] = { point = i, xi = low, x = x, ux = model:sample("lower", "ux", { low, 1 }) }
    end
  end
  return list
end

--- Mean and largest slip of the points of `opposites` within |x| < part, since the state in which they were opposite.
local function slips(model, profile, opposites, part)
  local sum, count, largest = 0, 0, 0
  for _, one in ipairs(opposites) do
    if math.abs(one.x) < part then
      local slip = profile.x[one.point] - one.x - (model:sample("lower", "ux", { one.xi, 1 }) - one.ux)
      sum, count, largest = sum + slip, count + 1, math.max(largest, math.abs(slip))
    end
  end
  return math.abs(sum) / count, largest
end

--- The integral of |q| over the contact in a pressed state, over mu P; zero in the closed form.
function measures.pressed(model)
  local profile, p, q = model:profile "joint", 0, 0
  for i, area in ipairs(profile.area) do
    p, q = p + profile.pressure[i] * area, q + math.abs(profile.traction[i]) * area
  end
  return q / (problem.mu * p)
end

--- Compares a sheared state with the closed form: { ratio = Q/(mu P), c and expected, stick zone over a, s = x/a,
--- traction over mu p0, error, its L2 error, mean_slip and largest_slip over a }. `opposites`: of the pressed state.
function measures.compare(model, opposites)
  local profile = model:profile "joint"
  local p, q, from, to = 0, 0, math.huge, -math.huge
  for i, area in ipairs(profile.area) do
    p, q = p + profile.pressure[i] * area, q + profile.traction[i] * area
    if profile.state[i] == "stick" then from, to = math.min(from, profile.x[i]), math.max(to, profile.x[i]) end
  end
  local a, p0 = problem.hertz(p)
  local ratio = math.abs(q) / (problem.mu * p)
  local c, traction = problem.mindlin(math.min(ratio, 1))
  local state = { ratio = ratio, c = to > from and (to - from) / (2 * a) or 0, expected = c, s = {}, traction = {} }
  local sign = q < 0 and -1 or 1
  for i, x in ipairs(profile.x) do
    state.s[i], state.traction[i] = x / a, sign * profile.traction[i] / (problem.mu * p0)
  end
  state.error = deviation.l2(state.s, state.traction, traction, 1.3)
  state.mean_slip, state.largest_slip = slips(model, profile, opposites, 0.8 * c * a)
  state.mean_slip, state.largest_slip = state.mean_slip / a, state.largest_slip / a
  return state
end

return measures
