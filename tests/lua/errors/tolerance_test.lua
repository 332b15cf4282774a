-- model:run(path, { tolerance = … }): levels until the bars are within it, the model of the last one, wrong input.

require "check"

local path = { { name = "press", steps = 4, grip = { 0, -0.1 } }, { name = "slide", steps = 6, grip = { 0.2, -0.1 } } }

local function ironing(refinement)
  return (sg.scenes.ironing{ order = "N2", mu = 0.3, refinement = refinement or 2 })
end

check.case("the bars are within the tolerance, and so is the error against a finer solution", function()
  local model = ironing()
  local coarse = #model:unknowns()
  local run = model:run(path, { tolerance = { "4 % of grip.fx", "3 % of grip.fy" } })
  check.completed(run)
  check.equal(run.settings.reached, true)
  if #model:unknowns() <= coarse then error "the model has no more unknowns than before" end
  check.equal(#model:unknowns(), run.settings.levels[#run.settings.levels].unknowns)
  local fine = require "signorini.errors.remade".model(ironing(), { elements = 3, row = true, penalty = 20 })
  local exact = fine:run{ { steps = 16, grip = { 0, -0.1 } }, { steps = 24, grip = { 0.2, -0.1 } } }
  for name, share in pairs { ["grip.fx"] = 0.04, ["grip.fy"] = 0.03 } do
    local largest, values = 0, run:column(name)
    for row = 1, run.rows do largest = math.max(largest, math.abs(values[row])) end
    for row = 1, run.rows do
      check.at_most(name .. ": bar", run:error(name)[row], share * largest)
      check.at_most(name .. ": error", values[row] - exact:column(name)[4 * row], share * largest)
    end
  end
  check.holds(tostring(run), "4 % of grip.fx, 3 % of grip.fy: reached after", "elements × ")
end)

check.case("the model is that of the last level: further runs and pictures continue with it", function()
  local model = ironing()
  local run = model:run(path, { tolerance = "4 % of grip.fx" })
  check.near(model:reaction("grip").fx, run:column("grip.fx")[run.rows], 1e-15)
  local further = model:run({ { steps = 1, grip = { 0.21, -0.1 } } }, { errors = "mesh" })
  check.completed(further)
  if further:error("grip.fx")[1] ~= further:error("grip.fx")[1] then error "the further run has no bar" end
  check.equal(#run:states() > 0, true)
end)

check.case("a tolerance that the given scene meets is one level with its bits", function()
  local run, plain = ironing():run(path, { tolerance = "60 % of grip.fy" }), ironing():run(path)
  check.equal(#run.settings.levels, 1)
  check.equal(run:column("grip.fy")[run.rows], plain:column("grip.fy")[plain.rows])
end)

check.case("a limit of time ends the levels with the best bar, and says what is missing", function()
  local run = ironing():run(path, { tolerance = "0.01 % of grip.fx", limit = 1e-3 })
  check.equal(run.settings.reached, false)
  check.equal(#run.settings.levels, 1)
  check.holds(tostring(run), "not reached after 1 level", "more than the limit of 0.001 s allows")
end)

check.case("a path that ends early has not reached the tolerance", function()
  local run = ironing():run({ { steps = 1, grip = { 0, -0.95 } } }, sg.plain{ tolerance = "50 % of grip.fy",
    newton = { iterations = 4 } })
  check.equal({ run.failed, run.settings.reached }, { true, false })
  check.holds(run.settings.missed, "the path ended early")
end)

check.case("multipliers have no term of the penalty", function()
  local strip = scenes.model{ bodies = { block = { size = { 4, 1 }, elements = { 12, 4 }, contact = "south" } },
    supports = { grip = { on = "north", drive = "y", fix = "x" } },
    contacts = { floor = { slave = "south", method = "mortar", enforcement = "multipliers",
                           master = sg.rigid.cylinder{ center = { 2, -8 }, radius = 8 } } } }
  local run = strip:run({ { steps = 2, grip = -0.1 } }, { tolerance = "3 % of grip.fy" })
  check.equal(run.settings.penalty, 1)
  check.equal(run.settings.reached, true)
end)

check.case("wrong input", function()
  local model = ironing(1)
  local function wrong(options, ...) check.fails(function() model:run(path, options) end, ...) end
  for _, text in ipairs { "1 of grip.fx", "x % of grip.fx", "0 % of grip.fx", "-1 % of grip.fx", "101 % of grip.fx",
                          "1 % grip.fx", "" } do
    wrong({ tolerance = text }, "tolerance must be a text such as", "got \"" .. text)
  end
  wrong({ tolerance = 0.01 }, "tolerance", "1 % of grip.fx")
  wrong({ tolerance = { "1 % of grip.fx", "2" } }, "tolerance[2]")
  wrong({ tolerance = "1 % of grip.fz" }, "'grip.fz' is no result of the run", "grip.fy")
  wrong({ tolerance = "1 % of grip.ux" }, "'grip.ux' is no result")
  wrong({ tolerance = "1 % of grip.fx", limit = 0 }, "limit")
  wrong({ limit = 3 }, "limit is for tolerance")
  wrong({ tolerance = "1 % of grip.fx", on_step = print }, "on_step is for one run")
  wrong({ tolerance = "1 % of grip.fx", errors = "mesh" }, "tolerance needs all error bars")
  wrong({ tolerance = "1 % of grip.fx", checkpoint = "x.sgn" }, "checkpoint is for one run")
  wrong({ tolerance = "1 % of grip.fx", arc_length = true }, "arc_length")
  local strip = scenes.model{ bodies = { block = { size = { 4, 1 }, elements = { 16, 4 }, contact = "south" } },
    supports = { grip = { on = "north", drive = "y", fix = "x" } },
    contacts = { floor = { slave = "south", penalty = 100, master = scenes.floor() } } }
  check.fails(function() strip:run({ { steps = 1, grip = -0.1 } }, { tolerance = "1 % of grip.fx" }) end,
    "'grip.fx' is zero but for rounding errors")
  local file = check.folder() .. "/model.sgn"
  model:save(file)
  check.fails(function() sg.load(file):run(path, { tolerance = "1 % of grip.fx" }) end, "not made by sg.model")
  check.equal(model:last_length(), 0) -- nothing has moved
end)
