-- Width of a contact, in elements, from which its peak pressure is right.
--
-- Problem: a rigid cylinder (line) or sphere (point, axisymmetric) of radius 400 is pressed into a thick linear elastic
--          block, E = 1, nu = 0.3, with elements of length 1 along its face. The depth increases until the contact is
--          11 elements wide. The cylinder's axis is above a border of elements, a quarter or a half of an element
--          next to it. At each depth the peak pressure is compared with Hertz's for the computed force.
--          Columns: the largest width at which the peak is off by 10 % or more, in elements that touch, and the mean
--          over an element by 10 %; the energy in penalty springs as part of all energy, 2/3 of the error of the force
--          under a sphere, where the contact is 2.5 and 5 elements wide.
-- Source: K. L. Johnson, Contact Mechanics, Cambridge University Press, 1985, chapters 4.2 (line and point contact).
-- Units: lengths in elements, pressures relative to E; penalties in E over the element's length.
-- Expected: at Gauss points about 7 sqrt(penalty/30) elements with N2 to N4, a third of it with N2-N2.2; with mortar
--           averages of "equal" 6 to 8 elements under a cylinder, of "reduced" 3 to 6, at any penalty.
-- Run: signorini -q contact_width.lua [orders=N1,N2,N3,N4,N2-N2.2] [penalties=10,30,100,300]
--      [formulations=gpts,equal,reduced] [problems=line,point] [depths=30]

local sg = require "signorini"

local options = sg.arguments{
  orders = { "N1", "N2", "N3", "N4", "N2-N2.2" }, penalties = { { 10.0, 30.0, 100.0, 300.0 }, above = 0 },
  formulations = { { "gpts", "equal", "reduced" }, choices = { "gpts", "equal", "reduced" } },
  problems = { { "line", "point" }, choices = { "line", "point" } }, depths = 30,
}
local E, nu, radius, depth = 1, 0.3, 400, 32
local plane_modulus = E / (1 - nu^2)
local widest, off = 5.5, 0.1 -- half-width, and the error that counts

local function scene(problem, order, contact, shift)
  local point = problem == "point"
  local width = point and 32 or 48
  local block = sg.body{
    patch = sg.shapes.rectangle{ width = width, height = depth, corner = {0, -depth} }, elements = { width, 12 },
    grading = { false, { elements = 0.7, length = 0.25, at = "end" } }, order = order, contact = "north",
    material = sg.linear_elastic{ E = E, nu = nu },
  }
  local tool = point and sg.rigid.sphere{ center = {0, radius}, radius = radius }
    or sg.rigid.cylinder{ center = {width / 2 + shift, radius}, radius = radius }
  contact.slave, contact.master = block:face "north", tool
  local model = sg.model{
    kind = point and "axisymmetric" or "plane_strain", bodies = { block = block }, contacts = { touch = contact },
    supports = { bed = { on = block:face "south", fix = "xy" }, push = { on = tool, drive = "y" },
                 axis = point and { on = block:face "west", symmetry = true } or nil },
  }
  return model, point
end

--- Approach of a half-width; under a cylinder about that of a block of this depth (Johnson, 4.2).
local function approach(point, a)
  return point and a^2 / radius or a^2 / (2 * radius) * (2 * math.log(2 * depth / a) - 1)
end

--- Width in elements and peak relative to Hertz's.
local function measured(model, point)
  local force, now, width = -model:reaction("push").fy, model:contact_resultant "touch", 0
  local profile = model:profile "touch"
  for i, pressure in ipairs(profile.pressure) do
    if profile.state[i] ~= "open" and pressure > 0 then
      width = width + profile.area[i] * (point and 2 / (2 * math.pi * profile.x[i]) or 1)
    end
  end
  local peak = point and (6 * force * plane_modulus^2 / (math.pi^3 * radius^2)) ^ (1 / 3)
    or math.sqrt(force * plane_modulus / (math.pi * radius))
  local energy = model:energy()
  return width, now.max_pressure / peak - 1, now.mean_pressure / peak - 1,
    energy.contact / (energy.contact + energy.stored)
end

--- The largest widths with a wrong peak and mean, and the shares of energy near two widths, over places of the tool.
local function limits(problem, order, contact)
  local found = { peak = 0, mean = 0, share = {} }
  for _, shift in ipairs(problem == "line" and { 0, 0.25, 0.5 } or { 0 }) do
    local model, point = scene(problem, order, contact, shift)
    for i = 1, options.depths do
      local run = model:run{ { steps = 1, push = -approach(point, 0.15 + (widest - 0.15) * i / options.depths) } }
      if run.failed then break end
      local width, peak, mean, share = measured(model, point)
      if math.abs(peak) > off then found.peak = math.max(found.peak, width) end
      if math.abs(mean) > off then found.mean = math.max(found.mean, width) end
      for k, at in ipairs { 2.5, 5 } do
        if width >= at and not found.share[k] then found.share[k] = share end
      end
    end
  end
  return found
end

local rows = {}
for _, problem in ipairs(options.problems) do
  for _, order in ipairs(options.orders) do
    for _, formulation in ipairs(options.formulations) do
      for _, penalty in ipairs(order == "N1" and formulation == "reduced" and {} or options.penalties) do
        local mortar = formulation ~= "gpts"
        local found = limits(problem, order, { penalty = penalty, method = mortar and "mortar" or "gpts",
                                               multipliers = mortar and formulation or nil })
        rows[#rows + 1] = { problem, order, formulation, penalty, found.peak, found.mean,
                            100 * (found.share[1] or 0 / 0), 100 * (found.share[2] or 0 / 0) }
      end
    end
  end
end
print(sg.table{
  columns = { "problem", "order", "formulation", "penalty", "peak off to", "mean off to", "% at 2.5", "% at 5" },
  rows = rows, formats = { "%s", "%s", "%s", "%g", "%.1f", "%.1f", "%.1f", "%.1f" },
})
return { rows = rows }
