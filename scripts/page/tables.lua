-- A page's JSON files, from which its tables are made: page.json next to page.md holds { script, made, tables = a list
-- of { name, columns, rows, formats } } and what else a study keeps. A table's text replaces what stands in the page
-- between the lines "<!-- table: name -->" and "<!-- end -->". Where several studies fill one page, each has a file
-- study.json, which names both, and a line "<!-- table: made study -->" for program, processor and day.

local sg = require "signorini"

local page = {}

-- ── Markdown ─────────────────────────────────────────────────────────────────────────────────────────────────────────

local raised = { ["0"] = "⁰", ["1"] = "¹", ["2"] = "²", ["3"] = "³", ["4"] = "⁴", ["5"] = "⁵", ["6"] = "⁶",
                 ["7"] = "⁷", ["8"] = "⁸", ["9"] = "⁹", ["-"] = "⁻", ["+"] = "" }

--- "-2.4e-05" as "−2.4·10⁻⁵".
local function typeset(text)
  return (text:gsub("e([+-])0*(%d+)", function(sign, digits)
    return digits == "0" and "" or "·10" .. (sign .. digits):gsub(".", raised)
  end):gsub("^%-", "−"))
end

--- A number in its column's format or with two significant digits, a text as it is, "–" for nothing (false in JSON).
local function cell(value, format)
  if value == nil or value == false then return "–" end
  if type(value) ~= "number" then return (tostring(value):gsub("|", "\\|")) end
  if format then return typeset(format:format(value)) end
  if value == math.floor(value) and math.abs(value) < 1e6 then return typeset(("%d"):format(value)) end
  local text = ("%.2g"):format(value)
  return typeset(value >= 100 and text:find "e" and ("%.0f"):format(value) or text)
end

--- The lines of a table { columns, rows, formats }.
function page.text_of(tabled)
  local lines = { "| " .. table.concat(tabled.columns, " | ") .. " |", ("|---"):rep(#tabled.columns) .. "|" }
  for i, row in ipairs(tabled.rows) do
    local cells = {}
    for j = 1, #tabled.columns do cells[j] = cell(row[j], (tabled.formats or {})[j]) end
    lines[i + 2] = "| " .. table.concat(cells, " | ") .. " |"
  end
  return table.concat(lines, "\n")
end

--- The page's text with the tables of its data; "made" is a line on program, processor and day.
function page.filled(text, data)
  local function replaced(name, body)
    local first, last = ("<!-- table: %s -->\n"):format(name), "\n<!-- end -->"
    local _, from = text:find(first, 1, true)
    local to = from and text:find(last, from, true)
    if not to then error(("the page has no table '%s'"):format(name), 0) end
    text = text:sub(1, from) .. body .. text:sub(to)
  end
  for _, tabled in ipairs(data.tables) do replaced(tabled.name, page.text_of(tabled)) end
  replaced(data.study and "made " .. data.study or "made", ("Made by `%s` with signorini %s on %s, one core, %s.")
    :format(data.script, data.made.signorini, data.made.processor, data.made.day))
  return text
end

-- ── Files ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- Program, processor and last day of the cases of several results of study.of; versions are joined if there are more.
function page.made(results)
  local found = { signorini = {}, processor = {}, day = {} }
  for _, result in ipairs(results) do
    for _, record in pairs(result.study.records) do
      local made = record.made or {}
      found.signorini[(made.versions or {}).signorini or "?"] = true
      found.processor[made.processor or "?"] = true
      found.day[(made.time or "?"):sub(1, 10)] = true
    end
  end
  local function joined(set)
    local names = {}
    for name in pairs(set) do names[#names + 1] = name end
    table.sort(names)
    return table.concat(names, " and ")
  end
  return { signorini = joined(found.signorini), processor = joined(found.processor), day = joined(found.day) }
end

--- Columns of a case that go to JSON.
local kept = { "order", "setting", "mesh", "way", "unknowns", "iterations", "work", "cpu", "cpu_low", "cpu_high",
               "force", "error", "oscillation", "pressure", "pressing", "pressing_oscillation", "failed" }

--- The cases of a result as plain data.
function page.cases(result)
  local rows = {}
  for i, row in ipairs(result.cases.rows) do
    rows[i] = {}
    for _, key in ipairs(kept) do rows[i][key] = row[key] end
  end
  return { name = result.problem.name, unit = result.problem.unit, bar = result.bar,
           reference = result.problem.reference, cases = rows }
end

--- Writes base.json and, from what was written, the tables of base.md, or of data.page next to it, if there is one.
function page.write(base, data)
  sg.json.write(base .. ".json", data)
  local file = data.page and ("%s/%s.md"):format(base:match "^(.*)/" or ".", data.page) or base .. ".md"
  local stream = io.open(file)
  if not stream then return end
  local text = page.filled(stream:read "a", sg.json.read(base .. ".json"))
  stream:close()
  stream = assert(io.open(file .. ".new", "w"))
  assert(stream:write(text))
  assert(stream:close())
  assert(os.rename(file .. ".new", file))
end

-- ── Studies that fill a page ─────────────────────────────────────────────────────────────────────────────────────────

--- The arguments of sg.table as plain data: units in the heads, a format or false for each column, false for nothing.
local function plain(tabled)
  local result = { columns = {}, formats = {}, rows = {} }
  for j, name in ipairs(tabled.columns) do
    local unit, formats = (tabled.units or {})[j] or "", tabled.formats or {}
    result.columns[j] = unit == "" and name or ("%s (%s)"):format(name, unit):gsub("^ ", "")
    result.formats[j] = formats[name] or formats[j] or false
  end
  for i, row in ipairs(tabled.rows) do
    result.rows[i] = {}
    for j = 1, #tabled.columns do result.rows[i][j] = row[j] or false end
  end
  return result
end

--- Some columns of a table, as sg.table takes it, by their positions; heads: other names.
function page.pick(tabled, positions, heads)
  local whole, picked = plain(tabled), { columns = {}, formats = {}, rows = {} }
  for i, row in ipairs(whole.rows) do
    picked.rows[i] = {}
    for k, j in ipairs(positions) do picked.rows[i][k] = row[j] end
  end
  for k, j in ipairs(positions) do
    picked.columns[k], picked.formats[k] = heads and heads[k] or whole.columns[j], whole.formats[j]
  end
  return picked
end

--- A table with a row for each value of the columns `by` of another one, and columns for each of the columns `show` and
--- each value in the column `across`. All are positions. heads: names of `by`, then patterns for `show` in which %s
--- stands for the value.
function page.across(tabled, by, across, show, heads)
  local whole, wide = plain(tabled), { columns = {}, formats = {}, rows = {} }
  local places, lines = {}, {}
  for k, j in ipairs(by) do wide.columns[k], wide.formats[k] = heads[k], whole.formats[j] end
  for s, j in ipairs(show) do
    for _, row in ipairs(whole.rows) do
      local key = ("%d %s"):format(s, row[across])
      if not places[key] then
        places[key] = #wide.columns + 1
        wide.columns[places[key]], wide.formats[places[key]] = heads[#by + s]:format(row[across]), whole.formats[j]
      end
    end
  end
  for _, row in ipairs(whole.rows) do
    local names = {}
    for k, j in ipairs(by) do names[k] = cell(row[j], whole.formats[j]) end
    local line = table.concat(names, "\n")
    if not lines[line] then
      lines[line] = {}
      wide.rows[#wide.rows + 1] = lines[line]
      for k = 1, #wide.columns do lines[line][k] = by[k] and row[by[k]] or false end
    end
    for s, j in ipairs(show) do lines[line][places[("%d %s"):format(s, row[across])]] = row[j] end
  end
  return wide
end

--- Fills a page with the tables of a study if it was given page=FOLDER: writes FOLDER/study.json and the page's tables.
--- options: page, nil or "none" for none, and out. tables: by name, as sg.table takes them, each of which the page has.
function page.fill(options, name, study, tables)
  if not options.page or options.page == "none" then return end
  local signed = sg.study{ name = "made", folder = options.out .. "/made", cases = { { time = os.time() } },
                           run = function() return {} end }:execute{}
  local command = { (arg and arg[0] or ""):match "scripts/.*" or study }
  for _, word in ipairs(arg or {}) do
    if not word:find "^page=" and not word:find "^out=" then command[#command + 1] = word end
  end
  local data = { page = name, study = study, script = table.concat(command, " "), tables = {},
                 made = page.made{ { study = signed } } }
  for title, tabled in pairs(tables) do
    data.tables[#data.tables + 1] = plain(tabled)
    data.tables[#data.tables].name = title
  end
  table.sort(data.tables, function(a, b) return a.name < b.name end)
  page.write(("%s/%s"):format(options.page, study), data)
end

return page
