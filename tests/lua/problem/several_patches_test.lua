-- The listing of share/doc/use/several_patches.md runs as printed; several_patches.lua shows what its header says.

require "check"

check.case("the page's listing", function()
  check.holds(check.page(core.share .. "/doc/use/several_patches.md"), "L.1.east-2.west shares 4 control points",
    "L.1.north-3.south shares 6 control points")
end)

check.case("a die slides across a border without a kick, in the plane and in space", function()
  for dimension, arguments in pairs { [2] = "steps=30", [3] = "steps=20" } do
    local result = check.study("problems/several_patches", "dimensions=" .. dimension, arguments)[dimension]
    check.at_most("joined less line", result.line, 1e-10)
    assert(result.joined < result.uncut, ("joined oscillates by %g, uncut by %g"):format(result.joined, result.uncut))
    if dimension == 2 then check.at_most("fine", result.fine, result.uncut / 2) end
  end
end)
