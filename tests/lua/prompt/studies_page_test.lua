-- The listing of share/doc/use/studies.md runs as printed, and comes to what the page says.

require "check"

check.case("the listing", function()
  local output, folder = check.page(core.share .. "/doc/use/studies.md")
  check.holds(output, "ratio of wall, A to B, at equal error", "Pareto front of wall and error", "chosen\n",
    ": 1 % of ground.fy. 5 levels")
  -- Which of the rows with an error below 1 % is the cheapest depends on the clock.
  check.equal(output:find "refined = %d, order = [%w.-]+: error = 0%.%d+ %%" ~= nil, true)
  check.equal(core.exists(folder .. "/line_contact.png"), true)
end)
