-- Ready elastic laws as energies.

local sg = require("signorini.core").sg
local make = require("signorini.scene.formula").elastic_law

local laws = {}

-- The change of volume, K/4 (J^2 - 1 - 2 ln J): its pressure grows without limit for J -> 0 and J -> infinity.
local function volumetric(K, J) return K / 4 * (J ^ 2 - 1 - 2 * sg.log(J)) end

function laws.mooney_rivlin(p)
  return make("sg.mooney_rivlin", "Mooney-Rivlin", function(I1, I2, J)
    return p.c10 * (J ^ (-2 / 3) * I1 - 3) + p.c01 * (J ^ (-4 / 3) * I2 - 3) + volumetric(p.K, J)
  end)
end

function laws.yeoh(p)
  return make("sg.yeoh", "Yeoh", function(I1, _, J)
    local x = J ^ (-2 / 3) * I1 - 3
    return p.c10 * x + p.c20 * x ^ 2 + p.c30 * x ^ 3 + volumetric(p.K, J)
  end)
end

function laws.ogden(p)
  return make("sg.ogden", "Ogden", nil, function(l1, l2, l3)
    local J = l1 * l2 * l3
    local sum = volumetric(p.K, J)
    for i, mu in ipairs(p.mu) do
      local alpha = p.alpha[i]
      sum = sum + mu / alpha * (J ^ (-alpha / 3) * (l1 ^ alpha + l2 ^ alpha + l3 ^ alpha) - 3)
    end
    return sum
  end)
end

-- With E = (C - I)/2: tr E = (I1 - 3)/2, tr E^2 = (I1^2 - 2 I2 - 2 I1 + 3)/4.
function laws.saint_venant_kirchhoff(p)
  local mu = p.E / (2 * (1 + p.nu))
  local lambda = 2 * mu * p.nu / (1 - 2 * p.nu)
  return make("sg.saint_venant_kirchhoff", "Saint Venant-Kirchhoff", function(I1, I2)
    return lambda / 8 * (I1 - 3) ^ 2 + mu / 4 * (I1 ^ 2 - 2 * I2 - 2 * I1 + 3)
  end)
end

return laws
