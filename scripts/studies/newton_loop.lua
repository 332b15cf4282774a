-- A user-defined Newton loop: low-level methods that do what model:run does with sg.plain{}.
--
-- Problem: 2D frictional ironing, section 7.1 of the thesis (ironing2d.lua has the sketch), N2-N2.2 at mesh m1.
-- Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method for Isogeometric Analysis of
--         Contact Problems, PhD thesis, IIT Guwahati, 2020, Algorithm 1.
-- Units: any consistent units, such as mm and N/mm².
-- Expected: the same numbers as model:run with plain Newton, to the last bit.
-- Run: signorini newton_loop.lua [steps=46] [slides=250]; number of the published steps to run in each stage.

local sg = require "signorini"
local problem = require "problems.ironing2d.problem"

local options = sg.arguments{ steps = 46, slides = 250 }
local set_up = problem.variants.standard
local presses, slides = options.steps, options.slides
local depth = set_up.depth * (presses / set_up.press_steps)
local stages = {
  { name = "press", steps = presses, grip = { 0, -depth } },
  { name = "slide", steps = slides, grip = { set_up.distance * (slides / set_up.slide_steps), -depth } },
}

-- ── The loop ─────────────────────────────────────────────────────────────────────────────────────────────────────────

local model = problem.scene(set_up, "N2-N2.2", problem.elements "m1")
local forces, iterations = { x = {}, y = {} }, 0

for _, stage in ipairs(stages) do
  local start = model:target "grip"
  for number = 1, stage.steps do
    local part, target = number / stage.steps, {}
    for i, goal in ipairs(stage.grip) do target[i] = part == 1 and goal or start[i] + (goal - start[i]) * part end
    model:set_target("grip", target)

    local newton
    repeat newton = model:iterate{ tolerance = 1e-10, iterations = 25 } until newton.reason ~= "iterating"
    iterations = iterations + newton.iterations

    if not newton.converged then
      local diagnosis = model:diagnose()
      model:rollback()
      error(("step %d of '%s': %s. %s"):format(number, stage.name, diagnosis.message, diagnosis.cure), 0)
    end
    model:accept()
    local force = model:reaction "grip"
    forces.x[#forces.x + 1], forces.y[#forces.y + 1] = force[1], force[2]
  end
end

-- ── The same by model:run ────────────────────────────────────────────────────────────────────────────────────────────

local run = problem.scene(set_up, "N2-N2.2", problem.elements "m1"):run(stages, sg.plain{})
local differences = 0
for i = 1, run.steps do
  if run:column "grip.fx"[i] ~= forces.x[i] or run:column "grip.fy"[i] ~= forces.y[i] then
    differences = differences + 1
  end
end
print(("%d steps, %d iterations by the loop, %d by model:run; steps whose forces differ in any bit: %d")
  :format(run.steps, iterations, run.iterations, differences))

return { forces = forces, iterations = iterations, run = run, differences = differences }
