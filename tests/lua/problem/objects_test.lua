-- The scenes of scripts/objects against closed forms.

require "check"

local function results(name, ...) return (check.study("objects/" .. name, ...)) end

check.case("bushing: the stiffness of plane elasticity and, almost, of Adkins and Gent, without warnings", function()
  local bushing = results("bushing", "elements=6", "steps=4", "most=0.2")
  check.within_share("plane elasticity", bushing.stiffness, bushing.exact, 2e-3)
  check.within_share("incompressible", bushing.exact, bushing.published, 0.02)
  check.equal(#bushing.warnings, 0)
end)

check.case("O-ring: Johnson's cylinder between plates", function()
  local ring = results("o_ring", "steps=5", "orders=N2")
  for i, compression in ipairs(ring.compression) do
    if compression < 0.16 then check.within("compression", ring.johnson[i] / compression, 1, 0.05) end
    check.within("pressure", ring.pressure[i] / ring.johnson_pressure[i], 1, 0.05)
  end
  -- Lindley's relation is a quarter below at C = 0.1 to 0.2.
  check.within("Lindley", ring.lindley[3] / ring.force[3], 0.77, 0.03)
end)

check.case("snap-fit hook: beam theory, and free of force before and after", function()
  local hook = results "snap_fit"
  check.within("insertion", hook.push / hook.push_beam, 1, 0.15)
  check.within("retention", hook.pull / hook.pull_beam, 1, 0.15)
  check.at_most("retention of a plain beam", hook.pull / hook.pull_plain, 0.7)
  local steps = #hook.force // 2
  for _, step in ipairs{ 1, steps, #hook.force } do check.at_most("force", hook.force[step], 1e-6) end
end)

check.case("ball of seven patches: a quarter of its section, which tends to Hertz's solution", function()
  local found = results("ball", "elements=4")
  check.within("force", found.ball.force / found.quarter.force, 1, 0.015)
  check.within("pressure", found.ball.peak / found.quarter.peak, 1, 0.05)
  -- A quarter of the radius of contact.
  check.within("Hertz", (found.rigid.force - 1) / (found.small.force - 1), 4, 1)
  -- On two elements the layer matters: without it the peak is 1.8 times that of the section.
  local layered = results("ball", "order=N4-N4.1", "elements=2", "depth=1", "reference=8")
  check.within("force", layered.ball.force / layered.quarter.force, 1, 0.015)
  check.within("pressure", layered.ball.peak / layered.quarter.peak, 1, 0.1)
end)

check.case("shrink fit: Lamé's pressure, and the force to pull the hub off", function()
  local fit = results("shrink_fit", "elements=8", "steps=10")
  check.within("pressure", fit.pressure / fit.lame, 1, 0.005)
  check.within("force", fit.most / fit.closed_force, 1, 0.01)
  assert(fit.force[2] < 0.8 * fit.most and fit.force[#fit.force] < 0.4 * fit.most)
end)

check.case("peeling a film: the force of Rivlin and Kendall, and the balance of energy", function()
  local peel = results("peel_film", "steps=40")
  check.within_share("force", peel.steady, peel.closed, 0.01)
  check.within("balance", peel.balance, 1, 0.005)
  assert(peel.peeled[#peel.peeled] > 5)
end)

check.case("belt: the capstan equation for a thick belt, on a driven pulley and on a fixed cylinder", function()
  local belt = results("belt", "elements=32", "steps=8")
  check.within_share("driven", belt.ratio, belt.thick, 0.005)
  check.within_share("fixed", belt.ratio_over, belt.thick, 0.015)
  check.within_share("moment", belt.moment, belt.balance, 5e-3)
  -- A thinner belt is closer to the capstan equation.
  local thin = results("belt", "elements=32", "steps=8", "h=0.25")
  check.within("half the difference", math.log(thin.thin / thin.ratio) / math.log(belt.thin / belt.ratio), 0.5, 0.15)
end)

check.case("ironing under a constant force: equilibrium, and a rigid tool as a stiff die", function()
  local ironing = results("pressed_tool", "refinement=1", "steps=25")
  for step = 5, #ironing.rigid.drag do
    check.within("force", ironing.rigid.normal[step], -0.15, 1e-8)
    -- Before all points slip, the guides of the die give way a little.
    if step >= 7 then check.within("drag", ironing.rigid.drag[step], ironing.die.drag[step], 0.005 * 0.2 * 0.15) end
    check.within_share("sinking", ironing.rigid.height[step], ironing.die.height[step], 0.005)
  end
end)

check.case("roller: no drag in the mean, and an advance by the radius per radian as the contact narrows", function()
  for _, found in ipairs(results("roller", "elements=48")) do
    check.at_most("drag", found.mean, 1e-3)
    check.within("creep", (found.advance - 0.5) / found.width, 0.085, 0.02)
  end
end)

check.case("rolling tire: the rolling radius, no resistance, and friction that limits the traction", function()
  local tire = results("rolling_tire", "elements=48", "steps=30", "angle=60")
  assert(tire.loaded < tire.rolling and tire.rolling < tire.free)
  check.within("rolling radius", tire.rolling / 292.8, 1, 0.005) -- of 120 × 4 elements, N3
  check.within("moment", tire.moment, 0, 1e-3)
  for _, traction in ipairs(tire.traction) do check.at_most("traction", math.abs(traction), tire.mu + 1e-6) end
  check.within("braked", tire.traction[1], -tire.mu, 0.01 * tire.mu)
  check.within("driven", tire.traction[#tire.traction], tire.mu, 0.01 * tire.mu)
end)

check.case("brake pad: mu at each speed, and a peak below static friction where it falls over a short slip", function()
  local pad = results("brake_pad", "elements=8", "steps=40", "over=0.5,0.05", "speeds=0.1,1")
  check.within("friction by speed", pad.worst, 0, 1e-9)
  assert(pad.rows[1][2] > 0.36 and pad.rows[1][2] < 0.4 and pad.rows[2][2] < 0.3)
  for _, row in ipairs(pad.rows) do check.within("friction at the end", row[3], row[4], 2e-3) end
end)

check.case("mixed-mode bending: energies per new area are those of the mode mix", function()
  for _, row in ipairs(results("mixed_mode_bending", "elements=40", "ratios=-1,0.4", "steps=24").rows) do
    check.within("share of shear", row[2], row[3], 0.02)
    check.within("dissipated", row[6], 1, 0.01)
    check.within("released", row[7], 1, 0.03)
    check.within("energies", row[8], 1, 2e-3)
  end
end)

check.case("rough joint: springs in series", function()
  for _, row in ipairs(results("rough_joint", "elements=2", "steps=5").rows) do
    check.within("pressure", row[2] / row[3], 1, 1e-9)
    check.within("largest difference", row[5], 0, 1e-9)
  end
end)

check.case("worn pin: Archard's scars of a cylinder and a sphere", function()
  for _, row in ipairs(results("worn_pin", "elements=24", "solid=6", "steps=16").rows) do
    check.within("by depth", row[3] / row[2], 1, 0.015)
    check.within("volume", row[6], 0, 2.5)
  end
end)

check.case("bumper: folds in contact carry a load that rises, and none before they touch", function()
  local bumper = results("bumper", "refinement=1", "steps=12", "most=0.4")
  for i = 1, 6 do check.within_share("before the contact", bumper.without[i], bumper.force[i], 1e-6) end
  assert(bumper.force[12] > 1.8 * bumper.without[12])
  check.within("balance", bumper.balance, 1, 0.01)
  check.within("action and reaction", bumper.imbalance, 0, 1e-8)
end)

check.case("C-shape: beam theory, then ends that touch and arms that lie on each other", function()
  local shape = results("cshape", "elements=12", "steps=40")
  check.within_share("beam theory", shape.force[1], shape.beam, 0.1)
  check.within("ends before they touch", shape.ends[8], 0, 1e-9)
  assert(shape.ends[20] > 0.03 and shape.ends[40] > 0.5 and shape.force[40] > 2 * shape.force[35])
  check.within("balance", shape.balance, 1, 0.04)
  check.within("action and reaction", shape.imbalance, 0, 1e-8)
end)

check.case("rolled strip: the moment of an arc, then a coil that touches itself with friction", function()
  local strip = results("rolled_strip", "elements=30", "angle=450", "steps=18")
  check.within("beam theory", strip.worst, 0, 0.005)
  check.within("contact of the arc", strip.area[18], 0, 1e-9)
  assert(strip.area[#strip.area] > 0.3 and strip.moment[#strip.moment] > 3 * strip.beam[#strip.beam])
  check.within_share("another mesh", strip.coarse[#strip.coarse], strip.moment[#strip.moment], 0.03)
  check.within("balance", strip.balance, 1, 0.005)
  check.within("action and reaction", strip.imbalance, 0, 1e-8)
end)

check.case("boot seal: folds touch each other and the shaft that tilts; the force of an axisymmetric model", function()
  local seal = results("boot_seal", "meshes=1", "steps=5")
  local press, last = seal.press, #seal.moment
  check.within_share("axisymmetric", seal.force[press], seal.revolved[press], 0.02)
  check.within_share("moment of small tilts", seal.moment[press + 2], 2 * seal.moment[press + 1], 0.02)
  check.within("moment without a tilt", seal.moment[press], 0, 1e-5 * seal.moment[last])
  assert(seal.area[last] > 3 and seal.bore[last] > 3 and seal.moment[last] > 7 * seal.moment[press + 1])
  check.within("balance", seal.balance, 1, 0.01)
end)

check.case("crossed tubes: a force that rises until the softer tube is flat and touches itself", function()
  local tubes = results("crossed_tubes", "meshes=5", "steps=20")
  for i = 2, 20 do assert(tubes.force[i] > tubes.force[i - 1], i) end
  check.within("inside before it is flat", tubes.inside[12], 0, 1e-9)
  assert(tubes.inside[20] > 0.1)
  check.within("balance", tubes.balance, 1, 0.005)
  check.within("action and reaction", tubes.imbalance, 0, 1e-6)
end)

check.case("wrong arguments are errors", function()
  check.refused("objects/bumper", { ["most=0.6"] = "most", ["refinement=0"] = "refinement", ["mu=-1"] = "mu" })
  check.refused("objects/boot_seal", { ["meshes=0"] = "meshes", ["tilt=20"] = "tilt", ["stroke=20"] = "stroke" })
  check.refused("objects/crossed_tubes", { ["meshes=2"] = "meshes", ["travel=50"] = "travel", ["steps=2"] = "steps" })
  check.refused("objects/cshape", { ["turn=0"] = "turn", ["travel=9"] = "travel", ["steps=4"] = "steps" })
  check.refused("objects/brake_pad", { ["over=0"] = "over", ["speeds=-1"] = "speeds", ["steps=1"] = "steps" })
  check.refused("objects/worn_pin", { ["scar=2"] = "scar", ["solid=2"] = "solid", ["force=0"] = "force" })
  check.refused("objects/mixed_mode_bending", { ["ratios=2"] = "ratios", ["law=linear"] = "law",
                                               ["shear=0"] = "shear" })
  check.refused("objects/rough_joint", { ["exponents=0.5"] = "exponents", ["elements=0"] = "elements" })
  check.refused("objects/rolled_strip", { ["rho=2"] = "rho", ["angle=360"] = "angle", ["steps=2"] = "steps" })
  check.refused("objects/roller", { ["mu=0"] = "mu", ["travel=2"] = "travel", ["steps=4"] = "steps" })
  check.refused("objects/belt", { ["h=0"] = "h", ["mu=1"] = "mu", ["elements=2"] = "elements", ["turn=0"] = "turn" })
  check.refused("objects/pressed_tool", { ["P=0"] = "P", ["refinement=0"] = "refinement", ["distance=3"] = "distance" })
  check.refused("objects/ball", { ["approach=0.6"] = "approach", ["elements=1"] = "elements", ["depth=0"] = "depth",
                                 ["penalty=-1"] = "penalty" })
  check.refused("objects/bushing", { ["volumetric=mixed"] = "volumetric", ["most=0.9"] = "most", ["K=0"] = "K",
                                    ["steps=0"] = "steps" })
  check.refused("objects/o_ring", { ["most=0.5"] = "most", ["elements=2"] = "elements", ["most=-1"] = "most" })
  check.refused("objects/peel_film", { ["energy=0"] = "energy", ["strength=-1"] = "strength", ["law=linear"] = "law",
                                      ["steps=2"] = "steps" })
  check.refused("objects/rolling_tire", { ["nu=0.5"] = "nu", ["mu=0"] = "mu", ["angle=10"] = "angle",
                                         ["elements=4"] = "elements" })
  check.refused("objects/shrink_fit", { ["interference=0"] = "interference", ["mu=-1"] = "mu", ["steps=1"] = "steps" })
  check.refused("objects/snap_fit", { ["mu=-1"] = "mu", ["steps=1"] = "steps", ["penalty=0"] = "penalty",
                                     ["elements=3"] = "elements" })
end)
