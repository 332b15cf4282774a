-- Generated scenes that may be absurd (scripts/robustness.lua): reproducible from a seed, refused with a message,
-- solved or ended with a reason; equal forces in other words. And scenes in which the generator found errors.

local core = require "signorini.core"
package.path = core.home .. "/scripts/?.lua;" .. package.path
local check = require "check"
local sg = require "signorini"
local scenes = require "robustness.scenes"
local survey = require "robustness.survey"

core.quiet = true

check.case("a seed gives the same scene on every machine", function()
  check.equal(scenes.text(scenes.describe(25)), "25: plane_strain, joined, block; a L2 4x4 neo_hookean, b N3-N3.1 3x3 "
    .. "neo_hookean, c N2 2x3 ogden; equal-augmented mu 0.7; odd: wild waves, points far away, extreme Poisson's "
    .. "ratio, narrow knot span, narrow knot span, extreme friction penalty, extreme offset, extreme load")
end)

check.case("generated scenes: nothing infinite, no forces that do not cancel, no internal error", function()
  local result = survey.run(1, 60, "some")
  check.equal(result.found, {})
  check.equal(result.apart, {})
  local refused, completed = result.outcomes.refused or 0, result.outcomes.completed or 0
  assert(refused > 10 and completed > 10, ("%d refused, %d completed"):format(refused, completed))
end)

check.done()
