-- The README's example runs as printed, and stays short.

require "check"

check.case("the example", function()
  local page = assert(io.open(core.home .. "/README.md", "rb"))
  local example = page:read("a"):match "```lua\n(.-)```"
  page:close()
  local picture = check.file "die.png"
  check.ended({ check.script(example:gsub('"die.png"', ("%q"):format(picture)), "-q") }, 0,
    "press     46", "slide    100", "factorization and solve")
  check.equal(select(2, example:gsub("\n", "\n")) <= 20, true)
  check.equal(core.exists(picture), true)
end)
