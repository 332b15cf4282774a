-- Studies of accuracy and cost as a user runs them, on coarse meshes, and their pages. Nothing here depends on how long
-- a case takes.

require "check"

local page = require "page.tables"
local folder = check.folder()

-- ── Pages and the files from which they are made ─────────────────────────────────────────────────────────────────────

local given, pages = {}, 0 -- given[page][name of a table]: the files that have it
for file in check.shell(("find '%s/doc' -name '*.json'"):format(core.share)):gmatch "[^\n]+" do
  local data = sg.json.read(file)
  local target = data.page and file:gsub("[^/]*$", data.page .. ".md") or file:gsub("json$", "md")
  local tables = given[target] or {}
  given[target], pages = tables, pages + (given[target] and 0 or 1)
  for _, tabled in ipairs(data.tables) do tables[tabled.name] = (tables[tabled.name] or 0) + 1 end
  tables[data.study and "made " .. data.study or "made"] = 1
  check.case(("%s has the figures of %s"):format(target, file), function()
    local text = core.read_file(target)
    check.equal(page.filled(text, data), text)
  end)
end

check.case("every table of such a page is that of one file", function()
  assert(pages > 3)
  for target, tables in pairs(given) do
    for name in core.read_file(target):gmatch "<!%-%- table: (.-) %-%->" do
      check.equal({ name, tables[name] }, { name, 1 })
    end
  end
end)

check.case("a changed figure is found", function()
  local text = "<!-- table: t -->\n| a |\n|---|\n| 1.5 |\n<!-- end -->\n<!-- table: made -->\n\n<!-- end -->\n"
  local data = { script = "s", made = { signorini = "1", processor = "p", day = "d" },
                 tables = { { name = "t", columns = { "a" }, rows = { { 1.5 } } } } }
  check.holds(page.filled(text, data), "| 1.5 |", "signorini 1 on p")
  data.tables[1].rows[1][1] = 2.5e-5
  check.holds(page.filled(text, data), "| 2.5·10⁻⁵ |")
  check.fails(function() page.filled("", data) end, "the page has no table 't'")
end)

check.case("formats, a table across a column, and a page that several studies fill", function()
  local long = { columns = { "order", "mesh", "error" }, units = { "", "", "%" }, formats = { error = "%.1e" },
                 rows = { { "N2", "m1", 0.25 }, { "N2", "m2", -1e-12 }, { "N4", "m1" } } }
  local wide = page.across(long, { 1 }, 2, { 3 }, { "order", "%s (%%)" })
  check.equal(page.text_of(wide),
    "| order | m1 (%) | m2 (%) |\n|---|---|---|\n| N2 | 2.5·10⁻¹ | −1.0·10⁻¹² |\n| N4 | – | – |")
  local picked = page.pick(long, { 3, 1 }, { false, "label" })
  check.equal({ picked.columns, picked.rows[3] }, { { "error (%)", "label" }, { false, "N4" } })
  local options = { page = folder .. "/pages", out = folder .. "/filled" }
  sg.mkdir(options.page)
  core.write_file(options.page .. "/p.md", "<!-- table: t -->\n<!-- end -->\n<!-- table: made s -->\n\n<!-- end -->\n")
  page.fill(options, "p", "s", { t = long })
  local text = core.read_file(options.page .. "/p.md")
  check.holds(text, "| N2 | m1 | 2.5·10⁻¹ |", core.processor)
  check.equal(page.filled(text, sg.json.read(options.page .. "/s.json")), text)
  page.fill({ page = "none" }, "p", "s", {})
end)

-- ── Speed against accuracy ───────────────────────────────────────────────────────────────────────────────────────────

local words = { "problems=rings", "meshes=m1", "rounds=1", "out=" .. folder .. "/out" }
local run = check.study("studies/speed_against_accuracy", table.unpack(words))
local rings = run.results.rings

check.case("the published thickness degree costs the rings three percent of the force, the default almost nothing",
  function()
    local published = rings.chosen:row{ order = "N2", setting = "published", mesh = "m1" }
    local layered = rings.chosen:row{ order = "N2-N2.2", setting = "default", mesh = "m1" }
    assert(published.error > 2 and layered.error < 1)
  end)

check.case("the bar of the reference is below what is compared", function()
  assert(rings.bar > 0 and rings.bar < 0.05)
  check.holds(tostring(run.comparisons.rings.force), "Reference: ", "± ")
end)

check.case("costs: iterations times unknowns, and the range of the times", function()
  for _, row in ipairs(rings.chosen.rows) do
    check.equal(row.work, row.iterations * row.unknowns)
    assert(row.cpu_low <= row.cpu and row.cpu <= row.cpu_high)
  end
end)

check.case("tables, ratios, and no case run again", function()
  check.equal(#run.tables[1].rows, 1)
  check.equal(#sg.csv.read(folder .. "/out/ratios.csv").columns, 9)
  local before = rings.study.records[1].made.time
  local again = check.study("studies/speed_against_accuracy", table.unpack(words)).results.rings
  check.equal(again.study.records[1].made.time, before)
end)

check.case("a page is filled", function()
  local doc = folder .. "/doc"
  sg.mkdir(doc .. "/speed_against_accuracy")
  local empty = ""
  for _, name in ipairs { "cheapest", "claims", "made" } do
    empty = empty .. ("<!-- table: %s -->\n<!-- end -->\n"):format(name)
  end
  core.write_file(doc .. "/speed_against_accuracy.md", empty)
  check.study("studies/speed_against_accuracy", "page=" .. doc, table.unpack(words))
  check.holds(core.read_file(doc .. "/speed_against_accuracy.md"), "| Two rings | N2", core.processor)
  check.equal(#sg.json.read(doc .. "/speed_against_accuracy.json").problems, 1)
end)

check.case("wrong arguments", function()
  check.refused("studies/speed_against_accuracy", {
    ["problems=ring"] = "problems must be values among 'ironing', 'hertz', 'rings', 'peeling' and 'ironing3d'",
    ["meshes=m1,m9"] = "meshes must be all, or meshes that one of the problems has, got 'm9' in 'm1,m9'",
    ["rounds=0"] = "rounds must be a whole number, 1 or more, got '0'",
  })
end)

-- ── Which model is enough ────────────────────────────────────────────────────────────────────────────────────────────

check.case("levers of one model: error, time ratio, whether long steps and plain Newton converge", function()
  local sphere = check.study("studies/which_model").results.sphere
  local of = {}
  for _, case in ipairs(sphere.levers) do of[case.lever] = case end
  assert(of.m1.row.error > 2 * of.base.row.error and of.base.long and of.base.plain)
  check.equal(of.N2.row.order, "N2")
end)

check.case("settings can be joined, unknown ones are named", function()
  local settings = require "studies.accuracy.settings"
  local o = settings.of{ order = "N2", setting = "multipliers + steps × 4", mesh = "m1", coarser = 2 }
  check.equal({ o.contact.enforcement, o.coarser }, { "multipliers", 8 })
  check.fails(function() settings.of{ order = "N2", setting = "best", mesh = "m1" } end, "there is no setting 'best'")
end)
