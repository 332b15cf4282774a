-- The listings of the tutorial run as printed, one after the other as one script, and print what the page
-- quotes. Blocks marked `times` hold seconds, so their decimals are not compared; those marked `example` are not
-- compared at all.

require "check"

--- Blanks do not count; where `times` is set, neither do numbers with a decimal point.
local function plain(text, times)
  text = text:gsub("[ \t]+", " "):gsub(" ?\n ?", "\n")
  return times and text:gsub("%d+%.%d+", "#") or text
end

local page = core.read_file(core.home .. "/share/doc/start/tutorial.md")
local quotes = {}
for language, kind, body in page:gmatch "```(%l+) ?(%l*)\n(.-)```" do
  if language == "text" then quotes[#quotes + 1] = { kind = kind, body = body } end
end

check.case("the listings", function()
  local output, folder = check.page(core.share .. "/doc/start/tutorial.md")
  check.equal(#quotes >= 10, true)
  for _, quote in ipairs(quotes) do
    if quote.kind ~= "example" then
      local times = quote.kind == "times"
      check.holds(plain(output, times), plain(quote.body, times))
    end
  end
  for name in page:gmatch "%f[%w]([%w_]+%.[pv][ntv][gud])\"" do
    check.equal(core.read_file(("%s/%s"):format(folder, name)) ~= "", true)
  end
  check.equal(#sg.csv.read(folder .. "/press.csv").rows, 9)
  check.holds(core.read_file(folder .. "/press.pvd"), "press_0010.vtu")
end)
