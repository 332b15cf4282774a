-- Pictures of the states that a run has stored: sheets, series, films; several fields, insets, no ground.

require "check"

local folder = check.folder()

local body = scenes.body{ size = {4, 1}, elements = { 4, 2 }, contact = "south", thickness_degree = 1, E = 2 }
local model = scenes.model{ bodies = { strip = body }, contacts = {},
  supports = { foot = { on = "west", fix = "xy" }, tip = { on = "east", drive = "xy" } } }
local at_rest = model:snapshot()
local stages = { { name = "bend", steps = 4, tip = { 0, 1 } }, { name = "back", steps = 2, tip = { 0, 0.5 } } }

local function run(states, on_step)
  model:restore(at_rest)
  return model:run(stages, { states = states, on_step = on_step })
end

local function steps(of)
  local list = {}
  for i, state in ipairs(of:states()) do list[i] = state.step end
  return list
end

local function bytes(name) return core.read_file(folder .. "/" .. name) end
local function size(name) return { string.unpack(">I4I4", bytes(name), 17) } end

--- The bytes of the picture that these arguments draw.
local function draw(arguments)
  arguments.file, arguments.size = folder .. "/one.png", arguments.size or 500
  sg.picture(arguments)
  return bytes "one.png"
end

check.case("a run keeps the requested states", function()
  check.equal(steps(run()), { 0, 4, 6 })
  check.equal(steps(run(3)), { 0, 3, 6 })
  check.equal(steps(run(20)), { 0, 1, 2, 3, 4, 5, 6 })
  check.equal(steps(run { 5, 1 }), { 1, 5 })
  check.equal(steps(run(function(info) return info["tip.uy"] > 0.7 end)), { 3, 4, 5 })
  check.equal(steps(run(nil, function(info) if info.step == 2 then return "stop" end end)), { 0, 2 })
  local states = run():states()
  check.equal({ tostring(states[1]), states[2].stage, states[2].title }, { "state at start", "bend", "bend, step 4" })
  model:restore(states[2].snapshot)
  check.near(model:target "tip", { 0, 1 })
  for _, wrong in ipairs { 1, 2.5, "all", { 7 }, { -1 }, { "end" } } do
    check.fails(function() run(wrong) end, "model:run: options.states")
  end
end)

check.case("a sheet of states is the sheet of their pictures, and does not change the model", function()
  model:restore(at_rest)
  local pictures = { sg.picture{ model = model, field = "uy", title = "start" } }
  local stored = run({ 0, 4 }, function(info)
    if info.step == 4 then pictures[2] = sg.picture{ model = model, field = "uy", title = "bend, step 4" } end
  end)
  local tip = model:sample("strip", "uy", { 1, 0.5 })
  local sheet = draw{ states = stored:states(), field = "uy", model = model }
  sg.sheet{ pictures, size = 500, file = folder .. "/sheet.png" }
  check.equal(bytes "sheet.png" == sheet, true)
  for i, state in ipairs(stored:states()) do pictures[i] = sg.picture{ state = state, field = "uy" } end
  sg.sheet{ pictures, size = 500, file = folder .. "/sheet.png" }
  check.equal(bytes "sheet.png" == sheet, true)
  check.near(model:sample("strip", "uy", { 1, 0.5 }), tip, 0)
  check.near(tip, 0.5)
end)

check.case("a series has one size and one range, and numbers its files", function()
  sg.picture{ states = run(3):states(), field = "uy", size = 400, file = folder .. "/bend-%03d.png" }
  check.equal(size "bend-001.png", size "bend-003.png")
  check.equal(bytes "bend-001.png" == bytes "bend-002.png", false)
  check.equal(core.exists(folder .. "/bend-004.png"), false)
end)

check.case("films are made by ffmpeg, whatever the name holds, and leave nothing else behind", function()
  core.mkdir(folder .. "/bin")
  core.write_file(folder .. "/bin/ffmpeg", [[#!/bin/sh
for last; do :; done
{ printf '\0\0\0 ftypisom\n'; ls "$(dirname "$last")"; printf '%s\n' "$@"; } > "$last"
]])
  check.shell(("chmod +x %s/bin/ffmpeg; mkdir '%s/a b'"):format(folder, folder))
  local code = ([[
    local sg = require "signorini"
    local body = sg.body{ patch = sg.shapes.rectangle{ width = 4, height = 1 }, elements = { 4, 2 }, order = "N2",
      contact = "south", material = sg.neo_hookean{ E = 2, nu = 0.3 } }
    local model = sg.model{ bodies = { a = body }, supports = { foot = { on = body:face "west", fix = "xy" } } }
    local picture = sg.picture{ model = model, size = 400 }
    sg.film{ picture, picture, fps = 5, file = "%s/a b/;x'.mp4" }]]):format(folder)
  core.write_file(folder .. "/film.lua", code)
  -- A killed process has left this.
  check.shell(("mkdir '%s/a b/.;x'\\''.mp4.parts'; touch '%s/a b/.;x'\\''.mp4.parts/9.png'"):format(folder, folder))
  local output, status = check.program({ folder .. "/film.lua" }, nil, "PATH=" .. folder .. "/bin:$PATH")
  check.equal({ output, status }, { "", 0 })
  check.holds(bytes "a b/;x'.mp4", "1.png\n2.png\n", "-framerate\n5.000000\n", "libx264")
  check.equal((check.shell(("ls -A '%s/a b'"):format(folder))), ";x'.mp4\n")
  local first = bytes "a b/;x'.mp4"
  core.write_file(folder .. "/fields.lua",
    code:gsub("model, size = 400 }\n.*", "model, size = 400, field = arg[1] }\n") ..
    "sg.film{ picture, fps = 5, file = arg[2] }")
  for _, wrong in ipairs {
    { "w", "a b/;x'.mp4", "unknown field 'w'" }, { "uy", "missing/x.mp4", "sg.film: cannot write" },
  } do
    output, status = check.program({ folder .. "/fields.lua", wrong[1], folder .. "/" .. wrong[2] }, nil,
      "PATH=" .. folder .. "/bin:$PATH")
    check.holds(output, wrong[3])
    check.equal({ status, bytes "a b/;x'.mp4" == first, core.exists(folder .. "/missing") }, { 1, true, false })
  end
  core.write_file(folder .. "/bin/ffmpeg", "#!/bin/sh\necho 'Unknown encoder' >&2\nexit 1\n")
  check.shell(("chmod +x %s/bin/ffmpeg"):format(folder))
  output, status = check.program({ folder .. "/film.lua" }, nil, "PATH=" .. folder .. "/bin:$PATH")
  check.holds(output, "film.lua:6: sg.film: cannot write the film '", "x-%04d.png",
              "ffmpeg failed with the message: Unknown encoder")
  check.equal({ status, (check.shell(("ls -A '%s/a b'"):format(folder))) }, { 1, ";x'.mp4\n" })
  check.equal(bytes "a b/;x'.mp4" == first, true)
  output, status = check.program({ folder .. "/film.lua" }, nil, "PATH=/nowhere")
  check.holds(output, "film.lua:6: sg.film: file", "needs the program ffmpeg", "x-%04d.png")
  check.equal(status, 1)
end)

check.case("what a film cannot show is refused before ffmpeg starts", function()
  local film = { states = run(3):states(), field = "uy", size = { 301, 203 }, file = folder .. "/x.mp4",
                 transparent = true }
  check.fails(function() sg.picture(film) end, "sg.picture: transparent is not available for films", "x-%04d.png")
  film.transparent, film.file = nil, folder .. "/x.ogv"
  check.fails(function() sg.picture(film) end, "x.ogv", "a film, .mp4")
  check.fails(function() sg.film{ sg.picture{ model = model }, file = film.file } end,
    "file must be the name of a film")
end)

check.case("several fields, insets, scale and ground", function()
  local single = draw{ model = model, field = "uy", size = 600 }
  local pair = draw{ model = model, fields = { "uy", "sxx" }, columns = 2, size = 1200 }
  local function dimensions(png) return string.unpack(">I4I4", png, 17) end
  check.equal(dimensions(pair) > 1.6 * dimensions(single), true)
  check.equal(draw{ model = model, fields = { "uy" }, size = 600 } == single, true)
  check.equal(draw{ model = model, fields = { "uy", "sxx" }, columns = 20, size = 1200 } == pair, true)
  local inset = draw{ model = model, field = "uy", size = 600, inset = { 3.5, 4, 0.5, 1 } }
  check.equal(inset == single, false)
  local function marked(text, part)
    return draw{ model = model, field = "uy", size = 600, inset = part, marks = { { x = { 3, 2 }, text = text } } }
  end
  check.equal(marked("one", { 3.5, 4, 0.5, 1 }) == marked("two", { 3.5, 4, 0.5, 1 }), true) -- beneath the inset
  check.equal(marked "one" == marked "two", false)
  for _, many in ipairs { { states = run():states(), field = "uy" }, { model = model, fields = { "ux", "uy" } } } do
    local plain = draw(many)
    many.inset = { 3.5, 4, 0.5, 1 }
    check.equal(draw(many) == plain, false)
  end
  check.equal(dimensions(draw{ model = model, size = { 300, 200 }, scale = 2 }), 600)
  check.equal({ single:byte(26), draw{ model = model, transparent = true }:byte(26) }, { 2, 6 })
end)

check.case("stresses are continuous across C¹ element boundaries, and jump across others", function()
  run()
  local function jump(field, xi, d)
    local before, after = { xi[1], xi[2] }, { xi[1], xi[2] }
    before[d], after[d] = xi[d] - 1e-9, xi[d] + 1e-9
    return math.abs(model:sample("strip", field, after) - model:sample("strip", field, before))
  end
  for _, field in ipairs { "sxx", "syy", "sxy", "von_mises" } do
    check.equal(jump(field, { 0.5, 0.3 }, 1) < 1e-6, true)
    check.equal(jump(field, { 0.3, 0.5 }, 2) > 1e-3, true)
  end
end)

check.case("wrong arguments", function()
  local states = run():states()
  local other = sg.model{ bodies = { strip = body }, supports = { foot = { on = body:face "west", fix = "xy" } } }
  for _, case in ipairs {
    { { states = states, model = other }, "model is not the model of the stored state" },
    { { states = {} }, "states must be a list of at least one state" },
    { { model = model, field = "uy", fields = { "ux" } }, "fields cannot be combined with field" },
    { { model = model, fields = {} }, "fields must be a list of at least one name" },
    { { model = model, fields = { "ux", "uz" } }, "unknown field 'uz'" },
    { { model = model, fields = { "ux", "uy" }, label = "u" },
      "label cannot be combined with fields, each of which has its own color bar" },
    { { model = model, fps = 3 }, "fps has no effect without states" },
    { { model = model, scale = 9 }, "makes 9000 pixels of 1000" },
    { { model = model, inset = { 0, 1 } }, "inset must be a list of 4 numbers" },
    { { states = states, size = 400, field = "uy", inset = { 0, 1, 0, 1 } }, "too small for an inset in each state",
      "fewer columns" },
    { { model = model, inset = { 2, 1, 0, 1 } }, "inset is {2, 1, 0, 1}", "with min below max" },
    { { model = model, inset = { 9, 10, 9, 10 } }, "inset = {9, 10, 9, 10} shows nothing" },
  } do
    check.fails(function() draw(case[1]) end, "sg.picture", table.unpack(case, 2))
  end
  check.fails(function() sg.picture{ model = model, file = "x%d.png" } end, "names a series", "run:states()")
  check.fails(function() sg.picture{ states = states, file = "x%s.png" } end, "must contain one number")
  check.fails(function() sg.picture{ states = states, file = "x.avi", fps = 5 } end, "x.avi", ".png", "a film, .mp4")
end)
