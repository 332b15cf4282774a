-- Mutants: does a test fail where one operator or number of the program is wrong?
--
-- Problem: places are drawn at random from the lines of src/: a comparison, a sign, a product, a logical operator or a
--          number in code is exchanged, in a copy of the sources. The copy is built, and its tests run until one fails.
--          A mutant that no test notices survives: either a test is missing, or the change has no effect.
-- Source: DeMillo, Lipton, Sayward, Hints on test data selection, Computer 11(4) (1978), 34-41.
-- Expected: few survivors, to be read one by one.
-- Run: signorini tests/measure/mutants.lua [count=200] [seed=1] [out=out/mutants] [within=src]
--      [tests=contact|model] [build=no]; within: a folder of sources; tests: a regular expression of ctest;
--      build=no: shows the mutants only. The copy is of the last commit.

local sg = require "signorini"

local options = sg.arguments{ count = 200, seed = 1, out = "out/mutants", within = "src", tests = "", build = true }

local home, tree = arg[0]:match "^(.*/)tests/measure/[^/]*$" or "./", options.out .. "/tree"
local sources = options.build and tree .. "/" or home

local function read(file)
  local source <close> = assert(io.open(file, "rb"))
  return source:read "a"
end

local function write(file, text)
  local target <close> = assert(io.open(file, "wb"))
  assert(target:write(text))
end

-- ── Places ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- What is exchanged for what. The spaces around operators tell them from templates, references and signs.
local exchanges = {
  { " < ", " <= " }, { " > ", " >= " }, { " <= ", " < " }, { " >= ", " > " }, { " == ", " != " }, { " != ", " == " },
  { " + ", " - " }, { " - ", " + " }, { " / ", " * " }, { " && ", " || " }, { " || ", " && " },
  { " += ", " -= " }, { " -= ", " += " }, { " true;", " false;" }, { " false;", " true;" },
  { "return 0;", "return 1;" }, { " = 0;", " = 1;" }, { " 0.5 ", " 0.25 " },
  { "std::max(", "std::min(" }, { "std::min(", "std::max(" },
}

--- Appends all places of a source to a list: { file, line, from, what, instead }.
local function add_places(list, file)
  local number = 0
  for line in (read(sources .. file) .. "\n"):gmatch "([^\n]*)\n" do
    number = number + 1
    local code = line:gsub("//.*", "")
    if not (code:find '^%s*#' or code:find '"' or code:find "template" or code:find "assert") then
      for _, exchange in ipairs(exchanges) do
        local from = code:find(exchange[1], 1, true)
        if from then
          list[#list + 1] = { file = file, line = number, from = from, what = exchange[1], instead = exchange[2] }
        end
      end
    end
  end
end

-- ── The copy ─────────────────────────────────────────────────────────────────────────────────────────────────────────

local function quoted(word) return "'" .. word:gsub("'", [['\'']]) .. "'" end

--- Runs a command in the copy; true if it succeeds. Its output is in a file next to the copy.
local function succeeds(command)
  return os.execute(("cd %s && (%s) >../log 2>&1"):format(quoted(tree), command)) == true
end

local make = "cmake --build build --parallel $(nproc)"
local check = ("ctest --test-dir build -j $(nproc) --stop-on-failure --timeout 600 -R %s"):format(quoted(options.tests))
if options.build then
  assert(os.execute(("rm -rf %s && git clone -q %s %s"):format(quoted(tree), quoted(home), quoted(tree))),
    "the sources could not be copied")
  local first = "cmake --preset release -D CMAKE_UNITY_BUILD=OFF -D SIGNORINI_TESTS=ON && " .. make .. " && " .. check
  if not succeeds(first) then error(("the tests fail without a mutant, see %s/log"):format(options.out), 0) end
end

-- ── Mutants ──────────────────────────────────────────────────────────────────────────────────────────────────────────

local list = {}
local pipe = assert(io.popen(("cd %s && find %s -name '*.cpp' | sort"):format(quoted(sources), quoted(options.within))))
for file in pipe:lines() do add_places(list, file) end
pipe:close()

--- A source with a place exchanged, and the line before and after.
local function mutated(text, place)
  local start = 1
  for _ = 2, place.line do start = text:find("\n", start, true) + 1 end
  local from = start + place.from - 1
  local changed = text:sub(1, from - 1) .. place.instead .. text:sub(from + #place.what)
  local function line(of) return of:sub(start, of:find("\n", start, true) - 1):gsub("^%s+", "") end
  return changed, line(text), line(changed)
end

math.randomseed(options.seed)
local counts = { noticed = 0, survived = 0, ["does not compile"] = 0 }
for _ = 1, math.min(options.count, #list) do
  local place = table.remove(list, math.random(#list))
  local text = read(sources .. place.file)
  local changed, before, after = mutated(text, place)
  local outcome = "not built"
  if options.build then
    write(sources .. place.file, changed)
    outcome = not succeeds(make) and "does not compile" or succeeds(check) and "survived" or "noticed"
    counts[outcome] = counts[outcome] + 1
    write(sources .. place.file, text)
  end
  print(("%-16s %s:%d\n    %s\n    %s"):format(outcome, place.file, place.line, before, after))
end
if options.build then
  print(("%d noticed, %d survived, %d do not compile"):format(counts.noticed, counts.survived,
    counts["does not compile"]))
end
