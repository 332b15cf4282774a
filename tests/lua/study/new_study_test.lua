-- signorini --new: the study that it writes runs, editors find the definitions, and nothing that exists is overwritten.

require "check"

local folder = check.folder()

local function run(arguments)
  return check.shell(("cd %s && SIGNORINI_HOME=%s %s %s"):format(folder, core.home, arg[-1], arguments))
end

check.case("the starter runs as it is written", function()
  local output, status = run "--new study.lua"
  check.equal(status, 0)
  check.equal(output, "Written: study.lua; run it with: " .. arg[-1] .. " study.lua\n"
    .. "Written: .luarc.json, by which editors with a Lua language server complete and check scripts\n")
  check.ended({ run "-q study.lua steps=3 meshes=1,2 orders=N2" }, 0,
    "starter: 2 of 2 cases are done", "Written: out/starter/starter.csv", "force.png", "report.html")
  for _, name in ipairs { "starter.csv", "force.png", "report.html", "N2_mesh1.png", "N2_mesh2.csv" } do
    check.equal(core.exists(folder .. "/out/starter/" .. name), true)
  end
  local force = require("signorini").csv.read(folder .. "/out/starter/starter.csv"):column "force"
  check.near(force, { 0.0165, 0.0158 }, 0.0005)
  local names = core.list_folder(folder .. "/out/starter/cases/cases")
  check.equal(#names, 2)
  for _, name in ipairs(names) do -- the time of the solve, not that of the pictures, too
    local record = core.read_json(core.read_file(folder .. "/out/starter/cases/cases/" .. name))
    check.equal(record.results.wall > 0 and record.results.wall < record.wall, true)
  end
  check.holds(run "study.lua help", "orders", "meshes", "steps")
end)

check.case("settings for editors: the definitions are where they say, and existing settings are kept", function()
  local text = core.read_file(folder .. "/.luarc.json")
  local settings = core.read_json(text)
  local shown = core.read_file(core.home .. "/share/doc/use/editor.md"):match "```json\n(.-)```"
  local function installed() return settings["workspace.library"][1] end
  check.equal(shown:gsub("<prefix>/share/signorini/library", installed), text)
  check.equal(settings["runtime.version"], "Lua 5.4")
  check.equal(#settings["workspace.library"], 1)
  check.equal(settings["workspace.library"][1]:sub(1, 1), "/")
  check.holds(core.read_file(settings["workspace.library"][1] .. "/signorini.lua"), "---@meta signorini")
  core.write_file(folder .. "/.luarc.json", "{}")
  check.ended({ run "--new second.lua" }, 0, "Written: second.lua", "Kept: .luarc.json, the settings of editors")
  check.equal(core.read_file(folder .. "/.luarc.json"), "{}")
  core.mkdir(folder .. "/other")
  core.write_file(folder .. "/other/.luarc.jsonc", "{} // mine")
  check.holds(run "--new other/study.lua", "Written: other/study.lua", "Kept: other/.luarc.jsonc")
  check.equal(core.exists(folder .. "/other/.luarc.json"), false)
  core.mkdir(folder .. "/third")
  check.holds(run "--new third/study.lua", "Written: third/study.lua", "Written: third/.luarc.json")
end)

check.case("a file that exists stays, a folder must be there, and the name ends with .lua", function()
  core.write_file(folder .. "/mine.lua", "-- mine")
  local output, status = run "--new mine.lua"
  check.equal(status, 1)
  check.holds(output, "the file 'mine.lua' exists already", "choose another name")
  check.equal(core.read_file(folder .. "/mine.lua"), "-- mine")
  for arguments, words in pairs { ["--new mine"] = "write mine.lua", ["--new no/folder.lua"] = "no/folder.lua" } do
    check.ended({ run(arguments) }, 1, words)
  end
  check.equal(core.exists(folder .. "/mine"), false)
  check.ended({ run "--new" }, 2, "--new must be followed by the name of a file")
end)
