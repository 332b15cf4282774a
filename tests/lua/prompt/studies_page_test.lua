-- The listing of share/doc/use/studies.md runs as printed, and comes to what the page says.

require "check"

check.case("the listing", function()
  local output, folder = check.page(core.share .. "/doc/use/studies.md")
  check.holds(output, "ratio of wall, A to B, at equal error", "Pareto front of wall and error",
    "refined = 2, order = N2: error = 0.527", "chosen\n", ": 1 % of ground.fy. 5 levels")
  check.equal(core.exists(folder .. "/line_contact.png"), true)
end)
