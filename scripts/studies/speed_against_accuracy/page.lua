-- The page share/doc/evidence/speed_against_accuracy.md: reports of all problems with charts, in Markdown.

local tables = require "studies.speed_against_accuracy.tables"

local page = {}

-- ── Markdown ─────────────────────────────────────────────────────────────────────────────────────────────────────────

local raised = { ["0"] = "⁰", ["1"] = "¹", ["2"] = "²", ["3"] = "³", ["4"] = "⁴", ["5"] = "⁵", ["6"] = "⁶", ["7"] = "⁷",
                 ["8"] = "⁸", ["9"] = "⁹", ["-"] = "⁻" }

--- Numbers such as 1.30e-02 in a text as 1.30·10⁻².
local function typeset(text)
  return (text:gsub("(%d)e([+-])(%d+)", function(digit, sign, power)
    local exponent = tostring(math.tointeger(tonumber(power)))
    if exponent == "0" then return digit end
    return digit .. "·10" .. ((sign == "-" and "-" or "") .. exponent):gsub(".", raised)
  end))
end

local function cell(value, format)
  if value == nil then return "–" end
  local text = type(value) == "number" and format and format:format(value) or tostring(value)
  return typeset(text):gsub("|", "\\|"), nil
end

--- A table of tables.lua, with units after the names.
local function write_table(table_)
  local lines, heads, rules = {}, {}, {}
  for j, name in ipairs(table_.columns) do
    local unit = table_.units[j]
    heads[j], rules[j] = unit ~= "" and ("%s (%s)"):format(name, unit) or name, "---"
  end
  lines[1], lines[2] = table.concat(heads, " | "), table.concat(rules, "|")
  for i, row in ipairs(table_.rows) do
    local cells = {}
    for j = 1, #table_.columns do cells[j] = cell(row[j], table_.formats[j]) end
    lines[i + 2] = table.concat(cells, " | ")
  end
  lines[2] = "|" .. lines[2] .. "|"
  for i = 1, #lines do
    if i ~= 2 then lines[i] = "| " .. lines[i] .. " |" end
  end
  return table.concat(lines, "\n")
end

local function write_block(block, folder)
  if block.chart then return ("![%s](%s/%s)"):format(block.title, folder, block.chart) end
  if block.table then return ("%s:\n\n%s"):format(block.title, write_table(block.table)) end
  return typeset(block.text)
end

-- ── Origin of the figures ────────────────────────────────────────────────────────────────────────────────────────────

--- Processors, versions and days of all cases, as a text.
local function origin(results)
  local lists, seen = { processor = {}, signorini = {}, day = {} }, {}
  local function add(key, value)
    if value and not seen[key .. value] then
      seen[key .. value] = true
      table.insert(lists[key], value)
    end
  end
  for _, result in ipairs(results) do
    for _, record in pairs(result.measured.study.records) do
      local made = record.made or {}
      add("processor", made.processor)
      add("signorini", (made.versions or {}).signorini)
      add("day", made.time and made.time:sub(1, 10))
    end
  end
  for _, list in pairs(lists) do table.sort(list) end
  local days = lists.day
  return ("Signorini %s on %s, %s"):format(table.concat(lists.signorini, " and "),
    table.concat(lists.processor, " and "), #days > 1 and days[1] .. " to " .. days[#days] or days[1] or "")
end

-- ── The page ─────────────────────────────────────────────────────────────────────────────────────────────────────────

local head = [[
# Speed against accuracy

Work–precision diagrams of five problems: error over time of a run, one curve per discretization, one marker per mesh;
points further down and left are better. The gray steps are the Pareto front: every case above them is beaten by one
that is both faster and more accurate. Made by `scripts/studies/speed_against_accuracy.lua` with %s.

Times include scene and path, %s, one case at a time. Ratios of times at equal error interpolate linearly between the
points of each curve in both logarithms, without extrapolation: not below the smallest error of either curve, and not
above that of its fastest case, which might be faster still at a larger error.]]

local summary_head = [[
## Summary

Ratios of times at equal error: at the smallest, the (geometrically) middle and the largest common error.]]

local run_head = [[
## Run it

    build/signorini scripts/studies/speed_against_accuracy.lua page=share/doc/evidence

writes this page. Finished cases are saved in the folder `out`: an interrupted run continues with the others, and a
complete one only draws and writes. Times are meaningful only on an otherwise idle machine.
`problems=hertz orders=N2,N2-N2.3 meshes=m1,m2` runs a part; any order label is possible.]]

--- The text of the page; `folder` is that of its charts, relative to the page.
function page.text(results, options, folder)
  local clock = options.time == "cpu" and "in seconds of processor time" or "as wall time"
  local parts = { head:format(origin(results), clock), summary_head, write_table(tables.summary(results)),
                  "Range of the middle ratios:", write_table(tables.ranges(results)) }
  for _, result in ipairs(results) do
    local problem = result.measured.problem
    parts[#parts + 1] = ("## %s\n\n[The problem](%s). %s"):format(problem.title, problem.page, result.blocks[1].text)
    for i = 2, #result.blocks do parts[#parts + 1] = write_block(result.blocks[i], folder) end
  end
  parts[#parts + 1] = run_head
  return table.concat(parts, "\n\n") .. "\n"
end

--- Writes the page atomically.
function page.write(file, results, options, folder)
  local text = page.text(results, options, folder)
  local stream = assert(io.open(file .. ".new", "w"))
  assert(stream:write(text))
  assert(stream:close())
  assert(os.rename(file .. ".new", file))
end

return page
