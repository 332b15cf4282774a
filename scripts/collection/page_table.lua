-- The table of benchmarks of share/doc/evidence/collection.md: a row for each variant, a column for each formulation.

local page_table = {}

local formulations = { { "gpts", "Gauss points" }, { "equal", "mortar" }, { "equal-multipliers", "multipliers" } }

local function signed(text) return (text:gsub("^%-", "−")) end

--- A number without an exponent, of `digits` significant ones, without zeros at the end of its decimals.
local function plain(value, digits)
  if value == 0 then return "0" end
  local decimals = math.max(0, digits - 1 - math.floor(math.log(math.abs(value), 10)))
  local text = ("%.*f"):gsub("%*", decimals):format(tonumber(("%." .. digits .. "g"):format(value)))
  if decimals > 0 then text = text:gsub("0+$", ""):gsub("%.$", "") end
  return signed(text)
end

--- A value with one digit more than its bar, which has one.
local function with_bar(entry)
  if not entry.value then return "failed" end
  if not entry.bar then return plain(entry.value, 5) .. " ± ?" end
  if entry.bar < 1e-6 then return plain(entry.value, 5) end
  local decimals = math.max(0, math.min(5, 1 - math.floor(math.log(entry.bar, 10))))
  return signed(("%." .. decimals .. "f"):format(entry.value)) .. " ± " .. plain(math.max(entry.bar, 1e-5), 1)
end

--- A reference with its uncertainty, in parentheses if results are only compared with it.
local function reference(entry)
  local text = plain(entry.reference, 5)
  if entry.uncertainty > 0 then text = text .. " ± " .. plain(entry.uncertainty, 2) end
  return entry.kind == "comparison" and "(" .. text .. ")" or text
end

--- The table { name, columns, rows } of results { benchmark, variant, formulation, quantity, reference, uncertainty,
--- kind, value, bar } in their order. benchmarks: by name.
function page_table.of(entries, benchmarks)
  local columns, groups, known = { "benchmark", "variant: quantities", "source", "reference" }, {}, {}
  for i, formulation in ipairs(formulations) do columns[4 + i] = formulation[2] end
  for _, entry in ipairs(entries) do
    local key = entry.benchmark .. "\n" .. entry.variant
    local group = known[key] or { first = entry, quantities = {}, references = {}, results = {} }
    if not known[key] then known[key], groups[#groups + 1] = group, group end
    local results = group.results[entry.formulation] or {}
    group.results[entry.formulation], results[#results + 1] = results, with_bar(entry)
    if not group.references[entry.quantity] then
      group.references[entry.quantity] = true
      table.insert(group.quantities, entry.quantity)
      table.insert(group.references, reference(entry))
    end
  end
  local rows, last = {}, nil
  for i, group in ipairs(groups) do
    local name = group.first.benchmark
    local benchmark = name ~= last and benchmarks[name]
    rows[i] = { benchmark and name .. " " .. benchmark.title or "",
                group.first.variant .. ": " .. table.concat(group.quantities, "; "),
                benchmark and benchmark.cites or "", table.concat(group.references, "; ") }
    for k, formulation in ipairs(formulations) do
      rows[i][4 + k] = group.results[formulation[1]] and table.concat(group.results[formulation[1]], "; ") or false
    end
    last = name
  end
  return { name = "benchmarks", columns = columns, rows = rows }
end

return page_table
