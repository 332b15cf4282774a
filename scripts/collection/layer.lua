-- Closed forms of layers, as integral equations that are solved to six digits.

local sg = require "signorini"

local layer = {}

--- Solves a dense system by elimination with pivots; changes both arguments.
local function solve(matrix, right)
  local n = #right
  for k = 1, n do
    local pivot = k
    for i = k + 1, n do
      if math.abs(matrix[i][k]) > math.abs(matrix[pivot][k]) then pivot = i end
    end
    matrix[k], matrix[pivot], right[k], right[pivot] = matrix[pivot], matrix[k], right[pivot], right[k]
    for i = k + 1, n do
      local factor = matrix[i][k] / matrix[k][k]
      for j = k, n do matrix[i][j] = matrix[i][j] - factor * matrix[k][j] end
      right[i] = right[i] - factor * right[k]
    end
  end
  for k = n, 1, -1 do
    for j = k + 1, n do right[k] = right[k] - matrix[k][j] * right[j] end
    right[k] = right[k] / matrix[k][k]
  end
  return right
end

--- Points and weights of n intervals of Gauss's rule with three points on [0, length].
local function gauss(n, length)
  local x, w, h = {}, {}, length / n
  for i = 0, n - 1 do
    for k, part in ipairs { 0.5 - math.sqrt(0.15), 0.5, 0.5 + math.sqrt(0.15) } do
      x[#x + 1], w[#w + 1] = (i + part) * h, (k == 2 and 4 or 2.5) / 9 * h
    end
  end
  return x, w
end

--- κ = P (1 - ν)/(4 G a w) of a rigid flat punch of radius a on a layer of thickness a that is bonded to a rigid base,
--- without friction. The layer has the normal compliance (1 - ν) L(k)/(G k) at the wave number k; with the pressure
--- p̂(k) = ∫ φ(t) cos kt dt over [0, a], φ solves φ(x) + 1/π ∫ φ(t) ∫ (L - 1) (cos k(x - t) + cos k(x + t)) dk dt = 1,
--- and κ = ∫ φ dt/a (I. N. Sneddon, Fourier Transforms, 1951, and N. N. Lebedev, Y. S. Ufliand, PMM 22, 1958).
function layer.punch(nu)
  local x, w = gauss(6, 1)
  local k, wk = gauss(100, 30)
  local matrix, right, deviation, sum = {}, {}, {}, 0
  for m, value in ipairs(k) do
    local e = math.exp(-2 * value)
    local L = ((3 - 4 * nu) * (1 - e ^ 2) / 2 - 2 * value * e)
      / ((3 - 4 * nu) * (1 + e ^ 2) / 2 + (2 * value ^ 2 + 5 - 12 * nu + 8 * nu ^ 2) * e)
    deviation[m] = (L - 1) * wk[m]
  end
  for i = 1, #x do
    matrix[i], right[i] = {}, 1
    for j = 1, #x do
      local kernel = 0
      for m, value in ipairs(k) do
        kernel = kernel + deviation[m] * 2 * math.cos(value * x[i]) * math.cos(value * x[j])
      end
      matrix[i][j] = (i == j and 1 or 0) + kernel * w[j] / math.pi
    end
  end
  for i, value in ipairs(solve(matrix, right)) do sum = sum + value * w[i] end
  return sum
end

--- Half-width over thickness of the contact of a layer that a line load presses, without friction, onto a half-plane of
--- the same material: slopes of both faces are equal in the contact. At the wave number k the layer has the compliance
--- A = (sinh k cosh k + k)/(sinh² k - k²) under pressures on this face and B = (sinh k + k cosh k)/(sinh² k - k²) under
--- those on the other one, relative to the half-plane's. The pressure is √(1 - s²) g(s), s = x/a; g is found at
--- Chebyshev points (F. Erdogan, G. D. Gupta, Q. Appl. Math. 29, 1972), and a from the balance of forces.
function layer.receding()
  local n = 24
  local k, wk = gauss(400, 40)
  local A, B = {}, {}
  for m, value in ipairs(k) do
    local s, c = sg.sinh(value), sg.cosh(value)
    A[m], B[m] = (s * c + value) / (s ^ 2 - value ^ 2), (s + value * c) / (s ^ 2 - value ^ 2)
  end
  --- The difference of slopes at the outermost point, when all others and the balance of forces are fulfilled.
  local function defect(a)
    local matrix, right = {}, {}
    for j = 1, n // 2 do
      local x = math.cos((2 * j - 1) * math.pi / (2 * (n + 1)))
      matrix[j], right[j] = {}, 0
      for m, value in ipairs(k) do right[j] = right[j] + B[m] * math.sin(value * a * x) * wk[m] / math.pi end
      for i = 1, n // 2 do
        local angle = i * math.pi / (n + 1)
        local s, weight, kernel = math.cos(angle), math.pi * math.sin(angle) ^ 2 / (n + 1), 0
        for m, value in ipairs(k) do
          kernel = kernel + (A[m] - 1) * 2 * math.cos(value * a * s) * math.sin(value * a * x) * wk[m]
        end
        matrix[j][i] = weight * (a * kernel / math.pi + 2 / math.pi * (1 / (x - s) + 1 / (x + s)))
      end
    end
    local row, target = matrix[1], right[1]
    matrix[1], right[1] = {}, 1 / a
    for i = 1, n // 2 do matrix[1][i] = 2 * math.pi * math.sin(i * math.pi / (n + 1)) ^ 2 / (n + 1) end
    local sum = -target
    for i, g in ipairs(solve(matrix, right)) do sum = sum + row[i] * g end
    return sum
  end
  local low, high = 1.25, 1.4
  local sign = defect(low) > 0
  for _ = 1, 20 do
    local middle = (low + high) / 2
    if (defect(middle) > 0) == sign then low = middle else high = middle end
  end
  return (low + high) / 2
end

return layer
