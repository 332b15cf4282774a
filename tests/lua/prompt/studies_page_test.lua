-- The listing of share/doc/studies.md runs as printed, and comes to what the page says.

require "check"

check.case("the listing", function()
  local parts = {}
  for part in core.read_file(core.home .. "/share/doc/studies.md"):gmatch "```lua\n(.-)```" do parts[#parts + 1] =
    part end
  local folder, script = check.folder(), check.file()
  core.write_file(script, table.concat(parts))
  check.ended({ check.shell(("cd %s && SIGNORINI_HOME=%s %s -q %s && ls"):format(folder, core.home, arg[-1],
    script)) }, 0, "ratio of wall, A to B, at equal error", "Pareto front of wall and error",
    "line_contact.png", "refined = 2, order = N2: error = 0.527", "N2 on mesh 2 meets the tolerance")
end)
