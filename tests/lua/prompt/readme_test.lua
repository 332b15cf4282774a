-- The README's example runs as printed, and stays short.

require "check"

check.case("the example", function()
  local output, folder = check.page(core.home .. "/README.md")
  check.holds(output, "press     46", "slide    100", "factorization and solve")
  check.equal(select(2, core.read_file(folder .. "/listing.lua"):gsub("\n", "\n")) <= 20, true)
  check.equal(core.exists(folder .. "/die.png"), true)
end)
