-- A page's JSON file, from which its tables are made: page.json next to page.md holds { script, made, tables = a list
-- of { name, columns, rows } } and the cases. A table's text replaces what stands in the page between the lines
-- "<!-- table: name -->" and "<!-- end -->".

local sg = require "signorini"

local page = {}

-- ── Markdown ─────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A number with three significant digits, a text as it is, "–" for nothing (false in JSON).
local function cell(value)
  if value == nil or value == false then return "–" end
  if type(value) ~= "number" then return (tostring(value):gsub("|", "\\|")) end
  if value == math.floor(value) and math.abs(value) < 1e6 then return ("%d"):format(value) end
  local text = ("%.2g"):format(value)
  return not text:find "e" and text or value >= 100 and ("%.0f"):format(value)
    or (text:gsub("e([+-])0*(%d+)", function(sign, digits) return "·10^" .. (sign == "-" and "−" or "") .. digits end)
      :gsub("%^(−?%d+)", function(power)
        return (power:gsub("[%d−]", { ["0"] = "⁰", ["1"] = "¹", ["2"] = "²", ["3"] = "³", ["4"] = "⁴", ["5"] = "⁵",
                                     ["6"] = "⁶", ["7"] = "⁷", ["8"] = "⁸", ["9"] = "⁹" }):gsub("−", "⁻"))
      end))
end

--- The lines of a table { columns, rows }.
function page.text_of(tabled)
  local lines = { "| " .. table.concat(tabled.columns, " | ") .. " |", ("|---"):rep(#tabled.columns) .. "|" }
  for i, row in ipairs(tabled.rows) do
    local cells = {}
    for j = 1, #tabled.columns do cells[j] = cell(row[j]) end
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
  replaced("made", ("Made by `%s` with signorini %s on %s, one core, %s."):format(data.script, data.made.signorini,
    data.made.processor, data.made.day))
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

--- Writes base.json and, from what was written, the tables of base.md if there is such a page.
function page.write(base, data)
  sg.json.write(base .. ".json", data)
  local stream = io.open(base .. ".md")
  if not stream then return end
  local text = page.filled(stream:read "a", sg.json.read(base .. ".json"))
  stream:close()
  stream = assert(io.open(base .. ".md.new", "w"))
  assert(stream:write(text))
  assert(stream:close())
  assert(os.rename(base .. ".md.new", base .. ".md"))
end

return page
