-- Checks that every message code used by the modules left of bind has a sentence in src/bind/lua/wording with
-- placeholders for all of its data, that every sentence is used, and that these modules pass codes without text to
-- require(), fail() and similar functions.
--   build/signorini tests/architecture/wording.lua [folder of the sources]

local source = arg and arg[1] or "src"
local modules = { "base", "os", "symbolic", "nurbs", "exchange", "solid", "contact", "solve", "model", "tessellation",
  "view", "figure", "terminal" }

local function output(command)
  local pipe = assert(io.popen(command))
  local text = pipe:read "a"
  pipe:close()
  return text
end

local function read(name)
  local file = assert(io.open(name))
  local text = file:read "a"
  file:close()
  return text
end

local wrong = {}
local function complain(...) wrong[#wrong + 1] = string.format(...) end

local function sorted(set)
  local list = {}
  for name in pairs(set) do list[#list + 1] = name end
  table.sort(list)
  return table.concat(list, ", ")
end

--- The names in {{"name", value}, …}.
local function data_names(list)
  local names = {}
  for datum in list:sub(2, -2):gmatch "%b{}" do
    local name = datum:match '^{"([%w_]+)",'
    if name then names[name] = true end
  end
  return names
end

--- Codes with the names of their data and the file that uses them: { [code] = { { names = …, file = … }, … } }.
local function used_codes(file, text, module, uses)
  for code, place in text:gmatch('"(' .. module .. '%.[%w_]+%.[%w_]+)"()') do
    local rest = text:sub(place):gsub('^%s*:%s*"[%w_.]+"', "") -- first of two codes with the same data
    local list = rest:match "^%)?%s*,%s*(%b{})"
    uses[code] = uses[code] or {}
    table.insert(uses[code], { names = data_names(list or "{}"), file = file })
  end
end

--- The rows of a file of sentences: { [code] = set of placeholders }.
local function read_rows(text, rows)
  text = text:gsub('"%s*\n%s*"', "")
  for code, sentence in text:gmatch '{"([%w_.]+)",%s*"(.-[^\\])"}' do
    if rows[code] then complain("%s has two sentences", code) end
    local names = {}
    for name in sentence:gsub("{{", ""):gsub("}}", ""):gmatch "{([%w_]+)" do names[name] = true end
    rows[code] = names
  end
end

local function check(folder)
  wrong = {}
  local uses, rows = {}, {}
  for _, module in ipairs(modules) do
    local files = output(("find %s/%s -name '*.cpp' -o -name '*.hpp' 2>/dev/null"):format(folder, module))
    for file in files:gmatch "[^\n]+" do
      local text = read(file):gsub("//[^\n]*", "")
      used_codes(file, text, module, uses)
      for name, call in text:gmatch "([%w_]+)(%b())" do
        if name == "require" or name == "fail" or name == "wrong" or name == "warn" or name == "Message" then
          for words in call:gsub('\\"', ""):gmatch '"([^"\n]*)"' do
            if words:find " " then
              complain("%s: %s(… \"%s\" …): text belongs in src/bind/lua/wording", file, name, words)
            end
          end
        end
      end
    end
  end
  for file in output(("find %s/bind/lua/wording -name '*.def'"):format(folder)):gmatch "[^\n]+" do
    read_rows(read(file), rows)
  end
  for code, places in pairs(uses) do
    for _, use in ipairs(places) do
      if not rows[code] then
        complain("%s: %s has no sentence", use.file, code)
      elseif sorted(rows[code]) ~= sorted(use.names) then
        complain("%s: %s has the data (%s), its sentence the placeholders (%s)", use.file, code, sorted(use.names),
          sorted(rows[code]))
      end
    end
  end
  for code in pairs(rows) do
    if not uses[code] then complain("the sentence of %s is not used", code) end
  end
  table.sort(wrong)
  return table.concat(wrong, "\n")
end

-- Shows that the test can fail: it rejects a tree with one mistake of each kind, and accepts it without these.
local trial = os.tmpname()
os.remove(trial)
os.execute(("mkdir -p %s/base %s/bind/lua/wording"):format(trial, trial))
local function complaints(use, row)
  for name, text in pairs { ["base/a.cpp"] = use, ["bind/lua/wording/base.def"] = row } do
    local file = assert(io.open(trial .. "/" .. name, "w"))
    file:write(text)
    file:close()
  end
  return check(trial)
end
local good_use, good_row = 'require(ok, "base.a.b", {{"x", f(x)}});', '{"base.a.b",\n "x must "\n "be {x:6}"},'
assert(complaints(good_use, good_row) == "", complaints(good_use, good_row))
for _, case in ipairs {
  { 'require(ok, "base.a.c");', good_row },
  { good_use, good_row .. '{"base.a.c", "x"},' },
  { 'require(ok, "base.a.b", {{"y", x}});', good_row },
  { good_use .. 'fail("x is wrong");', good_row },
} do
  assert(complaints(case[1], case[2]) ~= "", "not noticed: " .. case[1] .. " with " .. case[2])
end
os.execute("rm -r " .. trial)

local found = check(source)
if found ~= "" then
  io.stderr:write(found, "\n")
  os.exit(1)
end
