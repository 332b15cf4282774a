-- Detection of steps that jump to another branch of equilibria.

require "check"
local jumps = require "signorini.run.jumps"
local peeling = require "problems.peeling2d.problem"

--- What is found in stages of steps, each { length, released }, that take up work of 1 each.
local function found(...)
  local record, energy = jumps.record(), { work = 0, stored = 0, contact = 0, friction = 0 }
  local model, step = { energy = function()
    return { work = energy.work, stored = energy.stored, contact = 0, friction = 0, area_growth = 0,
             debonding = 0, wear = 0 }
  end }, 0
  for _, stage in ipairs { ... } do
    jumps.begin(record, model)
    for _, entry in ipairs(stage) do
      step = step + 1
      energy.work, energy.stored = energy.work + 1, energy.stored + 1 - entry[2]
      jumps.note(record, model, step, entry[1])
    end
  end
  jumps.close(record)
  local list = {}
  for i, entry in ipairs(record.found) do list[i] = entry.step end
  return list
end

local smooth, jump = { 1, 1e-5 }, { 8, 0.2 }

check.case("one step far longer than its neighbors that releases energy", function()
  check.equal(found { smooth, smooth, smooth, jump, smooth, smooth, smooth }, { 4 })
  check.equal(found { smooth, smooth, smooth, jump, smooth, smooth, smooth, smooth, jump, smooth }, { 4, 9 })
  check.equal(found { smooth, jump, smooth }, { 2 })
  check.equal(found { smooth, smooth, jump }, { 3 }) -- the last of a stage
  check.equal(found({ smooth, smooth, smooth }, { smooth, smooth, smooth, jump }), { 7 })
end)

check.case("nothing else", function()
  check.equal(found { smooth, smooth, smooth, smooth, smooth, smooth }, {})
  check.equal(found { smooth, smooth, { 8, 1e-5 }, smooth, smooth }, {})  -- far, and all energy is there
  check.equal(found { smooth, smooth, { 1, 0.2 }, smooth, smooth }, {})   -- not far: a kink, as first touch is
  check.equal(found { smooth, smooth, { 8, -0.2 }, smooth, smooth }, {})  -- energy has come from nowhere
  check.equal(found { { 1, 0.2 }, { 1, 0.1 }, { 8, 0.2 }, { 1, 0.1 } }, {}) -- the balance is as far off everywhere
  check.equal(found({ smooth, smooth, smooth }, { jump, jump, jump }), {}) -- a stage of longer steps
  check.equal(found { jump, smooth, smooth }, {})                         -- nothing before it to compare with
  check.equal(found {}, {})
end)

check.case("peeling on a coarse mesh jumps over its snap-backs in completed steps, and says where", function()
  local function peel(order, options)
    return (peeling.scene(order, "m0", 100, 85)):run({ { name = "rotate", steps = 150, edge = 30 } }, options)
  end
  local run = peel "N2"
  check.equal(run.reason, "completed")
  check.holds(table.concat(run.warnings, "\n"), "has probably jumped to another branch of solutions",
    "times those of neighboring steps", "of its work was released",
    "Hint: follow the path with arc_length = true")
  run = peel("N2", { arc_length = true })
  check.holds(table.concat(run.warnings, "\n"), "has probably jumped",
    "Hint: arc length is used only where a step fails")
  check.equal(#peel("N2-N2.2").warnings, 0)
end)
