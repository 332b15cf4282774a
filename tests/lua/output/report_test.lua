-- Reports: the pages of studies, runs and convergence maps, read as text and used in a browser
-- (tests/browser/report.py).

require "check"

local folder = check.folder()

local function file(name) return ("%s/%s"):format(folder, name) end

--- A page without the texts of scripts.
local function page_of(name) return (core.read_file(file(name)):gsub("<pre>.-</pre>", "")) end

--- A page without the section that differs between two reports of the same input.
local function fixed(page)
  local rest, count = page:gsub('<section id="program%-machine%-and%-time">.-</section>', "")
  check.equal(count, 1)
  return rest
end

local study = sg.study { name = "press </script>", folder = file "study", units = { error = "%" },
  cases = sg.grid({ order = { "N2", "N4" } }, { mesh = { 1, 2, 10 } }), run = function(case)
    if case.order == "N4" and case.mesh == 10 then
      return { failed = true, reason = "step 3 was not reached: a < b & \"c\"\nsecond line" }
    end
    local error = { N2 = { 10, 5, [10] = 0.3 }, N4 = { 25, 1 } }
    return { error = error[case.order][case.mesh], note = 'a "note", <b>' }
  end }
study:execute { jobs = 1 }

local function strip()
  return scenes.model{ bodies = { strip = { size = {3, 1}, elements = { 3, 2 }, contact = "north" } },
    supports = { bed = { on = "west", fix = "xy" }, plate = { on = "east", drive = "x" } } }
end

local run = strip():run { { name = "pull", steps = 3, plate = 0.3 }, { name = "hold", steps = 2, plate = 0.3 } }

local map = sg.convergence_map { name = "pulling", x = { name = "order", values = { "N2", "N3" } }, jobs = 1,
  y = { name = "length", values = { 0.1, -5 } }, scene = strip,
  path = function(_, _, length)
    return { { name = "pull", steps = 1, plate = length } }, { fallback = false, step = { adaptive = false } }
  end,
  results = function(_, done) return { force = done:column "plate.fx"[done.steps] } end }

-- ── As text ──────────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("a study's page has charts, table, failures, script and origin", function()
  study:report(file "plain.html")
  local page = page_of "plain.html"
  check.holds(page, "<title>press &lt;/script&gt;</title>", "6 cases, 1 failed", "error over mesh, by order",
    "wall over mesh, by order", '<td class="number">0.3</td>', "failed: step 3 was not reached: a &lt; b &amp; "
    .. "&quot;c&quot;\nsecond line", "<dt>order</dt><dd>N2, N4</dd>", "Script report_test.lua", "Module check",
    core.versions.signorini, "kernel " .. core.versions.kernel, "<figcaption>Outcomes</figcaption>",
    "order: N4\nmesh: 2")
  check.equal(page:find("Module signorini", 1, true), nil) -- of the library
  check.equal(select(2, page:gsub('<tr class="failed">', "")), 1)
end)

check.case("no page refers to anything outside", function()
  study:report(file "plain.html")
  run:report(file "run.html")
  map:report(file "map.html")
  for _, name in ipairs { "plain.html", "run.html", "map.html" } do
    for _, word in ipairs { "https?:", "src=\"[^d]", "href=\"[^#d]", "@import", "url%([^#]" } do
      check.equal({ name, word, page_of(name):match(word) }, { name, word })
    end
  end
end)

check.case("equal input gives equal bytes, apart from program, machine and time", function()
  local pages = {}
  for i = 1, 2 do
    study:report(file "again.html")
    run:report(file "again_run.html")
    pages[i] = { fixed(core.read_file(file "again.html")), fixed(core.read_file(file "again_run.html")) }
  end
  check.equal(pages[1][1] == pages[2][1], true)
  check.equal(pages[1][2] == pages[2][2], true)
  study:where { order = "N2" }:report(file "again.html")
  check.equal(fixed(core.read_file(file "again.html")) == pages[1][1], false)
end)

check.case("a run's page has its stages, steps, energies and charts", function()
  run:report { file = file "run.html", field = "ux", charts = { { y = { "plate.fx", "bed.fx" }, title = "Both forces" },
    { y = "plate.fx", x = "plate.ux" } } }
  local page = core.read_file(file "run.html")
  check.holds(page, "Run: pull, hold", "Both forces", "plate.fx over plate.ux", "Stored states, colored by ux",
    "data:image/png;base64,", '<section id="energy-balance">', '<section id="stages">')
  local steps = page:match '<section id="steps">.-</section>'
  check.equal(select(2, steps:gsub("<td>pull</td>", "")), 3)
  check.equal(select(2, steps:gsub("<td>hold</td>", "")), 2)
  run:report(file "run.html")
  check.holds(core.read_file(file "run.html"), "Force of plate", "Displacement of plate",
    "Newton iterations of each step")
end)

check.case("a failed run's page has the failure and the attempts", function()
  local failed = strip():run({ { name = "crush", steps = 1, plate = -5 } },
    { fallback = false, step = { adaptive = false } })
  check.equal(failed.failed, true)
  failed:report { file = file "failed.html", field = false }
  local page = page_of "failed.html"
  check.holds(page, "step 1 (stage &#39;crush&#39;, 1 of 1) was not reached", "No step converged.",
    '<section id="attempts">', "ended: inverted")
  check.equal(page:find("data:image/png", 1, true), nil)
end)

check.case("a map's page has outcomes, results and the reports of failures", function()
  map:report { file = file "map.html", title = "Where it converges" }
  check.holds(core.read_file(file "map.html"), "<h1>Where it converges</h1>", "Outcomes, with the number of iterations",
    "<figcaption>force</figcaption>", "order = N2, length = -5", "was not reached")
end)

check.case("pictures and films are in the page", function()
  local png = core.picture_bytes(sg.chart { { x = { 1, 2 }, y = { 1, 2 } } }, "png", { 300, 200 })
  core.write_file(file "a.png", png)
  core.write_file(file "a.MP4", "film")
  study:report { file = file "figures.html", charts = {}, films = { file "a.MP4" },
    pictures = { file "a.png", { picture = file "a.png", caption = "u_{max} < 1" } } }
  local page = core.read_file(file "figures.html")
  check.holds(page, 'alt="a.png"', 'alt="u_max &lt; 1"', "<figcaption>u_max &lt; 1</figcaption>",
    "data:image/png;base64," .. core.base64(png), "data:video/mp4;base64,ZmlsbQ==", 'id="films"')
  check.equal(page:find('id="charts"', 1, true), nil)
end)

check.case("parts of a study, and studies without results, have pages", function()
  study:where { order = "N4", mesh = 1 }:report(file "part.html")
  check.holds(core.read_file(file "part.html"), "1 case", "<td>N4</td>")
  sg.study { name = "later", folder = file "later", cases = sg.grid { mesh = { 1, 2 } }, run = print }
    :report(file "later.html")
  check.holds(core.read_file(file "later.html"), "2 of 2 cases are not done yet", "No case is done yet.")
end)

check.case("charts are chosen by the parameters and results", function()
  local function page(name, cases, solve)
    local chosen = sg.study { name = name, folder = file(name), cases = cases, run = solve }
    chosen:execute { jobs = 1 }
    chosen:report(file "chosen.html")
    return page_of "chosen.html"
  end
  local function solve(case) return { error = case.mu / case.mesh, kind = "a", flag = true } end
  local grid = sg.grid({ order = { "N2", "N4" } }, { mu = { 0.1, 0.2 } }, { mesh = { 1, 2, 4 } })
  local three = page("three", grid, solve)
  check.holds(three, "error over mu, by order, mesh", "order, mesh: N2, 4") -- the first parameter with numbers is x
  check.equal({ three:find "kind over", three:find "flag over" }, {})
  local many = sg.grid({ order = { "N2", "N4" } }, { mu = { 0.1, 0.2 } }, { mesh = { 1, 2, 3, 4, 5, 6, 7, 8 } })
  check.holds(page("many", many, solve), "error over mu, by order<") -- 16 curves would be too many
  check.holds(page("names", sg.grid { order = { "N2", "N4" } }, function(case) return { length = #case.order } end),
    "length over order", "order: N4\nlength: 2")
  local one = page("one", { { mesh = 1 } }, function() return { force = 1 } end)
  check.equal(one:find('id="charts"', 1, true), nil)
end)

check.case("wrong arguments are errors at the user's line, and no page is written", function()
  core.write_file(file "empty.png", "")
  core.write_file(file "large.mp4", (" "):rep(33e6 // 1))
  for _, wrong in ipairs {
    { { file = file "no.txt" }, "study:report: file must be the name of a file that ends with .html" },
    { { file = folder .. "/no/where.html" }, "study:report: cannot write", "does not exist" },
    { { charts = { { x = "mes", y = "error" } } }, "study:report: charts[1]: x must be 'order', 'mesh'",
      "did you mean 'mesh'?" },
    { { charts = { { x = "mesh", y = "error" } } }, "study:report: charts[1]: more than one case at mesh = 1" },
    { { charts = { { x = "mesh", y = "error", series = "order", log = "x", xrange = { -1, 2 } } } },
      "study:report: charts[1]: range of x must be" },
    { { maps = { { x = "order", y = "order", value = "error" } } }, "maps[1]: x and y are both order" },
    { { pictures = { "a" } }, "pictures[1] must be the name of a picture that ends with .gif, .jpeg, .jpg, .png" },
    { { pictures = { "none.png" } }, "pictures[1]: there is no file 'none.png'" },
    { { pictures = { file "empty.png" } }, "pictures[1]: the file", "is empty" },
    { { films = { "a.avi" } }, "films[1] must be the name of a film that ends with .mp4, .ogv or .webm" },
    { { films = { file "large.mp4" } }, "has 33 MB, more than the 32 MB that a page can hold" },
  } do
    wrong[1].file = wrong[1].file or file "wrong.html"
    check.fails(function() study:report(wrong[1]) end, "report_test.lua", table.unpack(wrong, 2))
  end
  check.fails(function() run:report { file = file "wrong.html", charts = { { y = "plate.f" } } } end, "report_test.lua",
    "run:report: charts[1].y[1] must be 'step'", "did you mean 'plate.fx'?")
  check.fails(function() run:report { file = file "wrong.html", field = "none" } end,
    "run:report: unknown field 'none'")
  check.fails(function() map:report "map.htm1" end, "map:report: file must be the name of a file that ends with .html")
  check.equal(core.exists(file "wrong.html"), false)
end)

-- ── In a browser ─────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("in a browser tables sort and filter, charts show values, and a phone has no overflow", function()
  study:report { file = file "study.html", title = 'Errors <b>& "more"</b> </title>', text = "Bytes \255 and \1." }
  run:report(file "run.html")
  map:report(file "map.html")
  local script = core.home .. "/tests/browser/report.py"
  local output, status = check.shell(("PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 '%s' '%s' '%s' '%s'"):format(script,
    file "study.html", file "run.html", file "map.html"))
  if status ~= 0 then error(output, 0) end
end)
