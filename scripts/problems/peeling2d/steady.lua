-- The moment of steady peeling from the energy balance of a strip that is peeled by a moment alone.
--
-- When the front moves by one unit of length, one more unit of strip is bent to the curvature k and one unit of the
-- bond is opened. The state at the front is only shifted, for any law of adhesion. So the work of the moment on
-- the rotation is the energy stored plus the work of adhesion W (force per length):
--   M k = U(k) + W,   M = dU/dk,   U(k) energy of the bent strip per reference length.
-- U = EI k²/(2(1 − ν²)), I = h³/12, gives M²(1 − ν²)/(2EI) = W:
--   M = √(2 E I W/(1 − ν²)).
-- This neglects finite strains: the faces of this strip are stretched by h k/2 = 9 %. The exact U(k) is
-- found from the cross section, which remains plane, at the radius r(Y), with stretches λ_θ = k r and λ_r = r′.
-- Both neglect the ends (the rigid edge, the pin), adhesion on the peeled part, and the discretization: a discretized
-- strip is stiffer, and its moment oscillates about this mean.

local problem = require "problems.peeling2d.problem"

local steady = {}

--- W = ∫ |T| dr from r_eq to ∞ with T = A/(2π r₀³) [(r₀/r)⁹/45 − (r₀/r)³/3]:
---   W = A/(2π r₀²) [q²/6 − q⁸/360], q = r₀/r_eq = 15^(1/6), so W = 15^(1/3) A/(16π r₀²).
function steady.work_of_adhesion()
  return 15 ^ (1 / 3) * problem.hamaker / (16 * math.pi * problem.r0 ^ 2)
end

--- Moment of a thin strip at small strains, in E0 L0³.
function steady.thin_moment()
  local second_moment = problem.height ^ 3 / 12
  local square = 2 * problem.modulus * second_moment * steady.work_of_adhesion() / (1 - problem.poisson ^ 2)
  return math.sqrt(square) / problem.moment_unit
end

-- ── The bent section of neo-Hooke's material ─────────────────────────────────────────────────────────────────────────

local shear = problem.modulus / (2 * (1 + problem.poisson))
local lame = 2 * shear * problem.poisson / (1 - 2 * problem.poisson)

-- W = Λ/2 (ln J)² + μ/2 (λ_r² + λ_θ² − 2) − μ ln J, J = λ_r λ_θ, and P = ∂W/∂λ of either stretch
local function energy(stretch, other)
  local log = math.log(stretch * other)
  return lame / 2 * log ^ 2 + shear / 2 * (stretch ^ 2 + other ^ 2 - 2) - shear * log
end
local function stress(stretch, other)
  return shear * (stretch - 1 / stretch) + lame * math.log(stretch * other) / stretch
end

--- The stretch λ_r of which the stress is P, by Newton's method.
local function radial_stretch(P, other)
  local stretch = 1
  for _ = 1, 50 do
    local log = math.log(stretch * other)
    local slope = shear * (1 + 1 / stretch ^ 2) + lame * (1 - log) / stretch ^ 2
    local change = (P - stress(stretch, other)) / slope
    stretch = stretch + change
    if math.abs(change) < 1e-15 then return stretch end
  end
  return stretch
end

--- Integrates the section from one face, at the radius r, where P_r = 0, to the other:
---   r′ = λ_r,  P_r′ = k P_θ,  U′ = W,  M′ = P_θ r.
--- Returns P_r at the other face, U and M.
local function section(k, r)
  local pieces = 64
  local step, state = problem.height / pieces, { r, 0, 0, 0 }
  local function rates(s)
    local hoop = k * s[1]
    local radial = radial_stretch(s[2], hoop)
    local hoop_stress = stress(hoop, radial)
    return { radial, k * hoop_stress, energy(radial, hoop), hoop_stress * s[1] }
  end
  local function moved(rate, by)
    local s = {}
    for i = 1, 4 do s[i] = state[i] + by * rate[i] end
    return s
  end
  for _ = 1, pieces do -- classical Runge–Kutta method
    local a = rates(state)
    local b = rates(moved(a, step / 2))
    local c = rates(moved(b, step / 2))
    local d = rates(moved(c, step))
    for i = 1, 4 do state[i] = state[i] + step / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]) end
  end
  return state[2], state[3], state[4]
end

--- The zero of a function near two guesses, by the secant method.
local function zero(f, a, b)
  local fa, fb = f(a), f(b)
  for _ = 1, 50 do
    if math.abs(b - a) < 1e-14 * math.abs(b) or fb == fa then break end
    a, b, fa = b, b - fb * (b - a) / (fb - fa), fb
    fb = f(b)
  end
  return b
end

--- Energy per reference length and moment (nN) of a strip that is bent by the angle k per reference length (1/nm).
function steady.bend(k)
  local guess = 1 / k - problem.height / 2
  local r = zero(function(radius) return (section(k, radius)) end, guess, guess * (1 + 1e-4))
  local _, U, M = section(k, r)
  return U, M
end

--- Moment of steady peeling with the exact U(k), in E0 L0³, and the angle that one nm of peeled strip takes, in
--- degrees.
function steady.finite_moment()
  local work = steady.work_of_adhesion()
  local guess = 2 * work / (steady.thin_moment() * problem.moment_unit) -- M k = 2 W at small strains
  local k = zero(function(curvature)
    local U, M = steady.bend(curvature)
    return M * curvature - U - work
  end, guess, 1.01 * guess)
  local _, M = steady.bend(k)
  return M / problem.moment_unit, math.deg(k)
end

return steady
