-- Errors about arguments: they name the function, the argument, its value, the expectation and, where known, a hint.

local core = require "signorini.core"
local describe = require "signorini.call.describe"
local lists = require "signorini.call.lists"
local meant = require("signorini.call.text").meant
local pages = require "signorini.pages"

local reject = {}

local most_unknown = 3 -- keys in one message
local longest_meaning = 60 -- characters of a row's text that is quoted in messages

--- The hint for a value of another kind than expected, where what was meant is likely, or nil.
local function likely(expected, value)
  if not expected:find "a face" then return nil end
  if pages.kind(value) == "body" then return 'take a face of the body, such as body:face "south"' end
  return (type(value) == "string" or type(value) == "number") and 'a face is a value: body:face "south"' or nil
end

local function meaning(row)
  return row and row[3] and row[3] ~= "" and utf8.len(row[3]) <= longest_meaning and (" (%s)"):format(row[3]) or ""
end

--- Rejects a value: "sg.f: E must be a positive number (Young's modulus), got …. Hint: …".
function reject.value(where, name, expected, value, cure, row)
  if not cure or cure == "take one of these" then cure = likely(expected, value) or cure end
  local ending = cure and ". Hint: " .. cure or ""
  if value == nil then
    core.fail(("%s: %s%s is missing: it must be %s%s"):format(where, name, meaning(row), expected, ending))
  end
  core.fail(("%s: %s must be %s%s, got %s%s"):format(where, name, expected, meaning(row), core.describe(value), ending))
end

--- The keys of rows in a message.
function reject.known(rows)
  local keys = pages.keys(rows)
  return #keys > 0 and table.concat(keys, ", ") or "none"
end

--- Rejects keys that are not in the rows.
function reject.unknown(where, name, value, unknown, rows)
  table.sort(unknown)
  local known, hints = pages.keys(rows), rows.hints or {}
  local named = { table.unpack(unknown, 1, most_unknown) }
  local all = table.concat(lists.map(named, function(key, i)
    local hint = hints[key] and hints[key] == hints[named[i + 1]] and "" -- said once, after the last
      or hints[key] and ". Hint: " .. hints[key] or meant(key, known)
    return ("unknown argument '%s' (%s)%s"):format(key, core.describe(value[key]), hint)
  end), "; ")
  core.fail(("%s%s: %s%s known: %s"):format(where, name == "" and "" or ": " .. name, all, all:find "%?$" and "" or ";",
    reject.known(rows)))
end

function reject.excess(page, value)
  local pair = type(value) == "number" and ". Hint: put numbers that belong together into braces, as in {1, 2}" or ""
  core.fail(("%s: too many arguments: it is called as %s, got %s beyond that%s"):format(page.name, pages.head(page),
    core.describe(value), pair))
end

--- Rejects an argument that lacks one of its row's `needs`, or is given with one of its `excludes`.
function reject.dependencies(row, value, where, prefix)
  if type(row) == "string" or rawget(value, row[1]) == nil then return end
  for _, other in ipairs(row.excludes or {}) do
    if rawget(value, other) ~= nil then
      local why = row.excludes.why and ", " .. row.excludes.why or ""
      core.fail(("%s: %s%s cannot be combined with %s%s. Hint: leave one of them out"):format(where, prefix, row[1],
        other, why))
    end
  end
  if row.needs and not lists.any(row.needs, function(other) return rawget(value, other) ~= nil end) then
    local example = row.needs.example and ", such as " .. row.needs.example or ""
    core.fail(("%s: %s%s has no effect without %s. Hint: add it%s, or leave %s out"):format(where, prefix, row[1],
      describe.alternatives(row.needs), example, row[1]))
  end
end

return reject
