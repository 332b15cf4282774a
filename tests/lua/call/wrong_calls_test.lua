-- Wrong calls of every public function (calls.lua): each must be an error at the line of the call that names the
-- argument and what the table expects: no crash, and nothing that passes in silence.
-- They are a few thousand; with the word `trace` behind the script's name each is printed before it runs.

local calls = require "calls"
require "check"
local names = require "signorini.prompt.help.names"

local function title(call) return ("%s, argument %s: %s"):format(call.page.name, call.place, call.what) end

local line = debug.getinfo(1, "l").currentline + 2
local function run(page, arguments)
  return pcall(function() return table.pack(names.value(page.name)(table.unpack(arguments, 1, arguments.n))) end)
end

--- What is wrong with how a wrong call ends, or nil.
local function fault(call)
  local arguments, owner = call.arguments, calls.owner_of(call.page)
  arguments.n = calls.count(arguments)
  if owner then arguments = table.move(arguments, 1, arguments.n, 2, { owner, n = arguments.n + 1 }) end
  local ok, message = run(call.page, arguments)
  if ok then return "passes in silence" end
  message = tostring(message)
  if not message:find(("wrong_calls_test.lua:%d: "):format(line), 1, true) then
    return "not at the line of the call: " .. message
  end
  for _, part in ipairs(call.holds) do
    if not message:find(part, 1, true) then return ("'%s' is not in: %s"):format(part, message) end
  end
end

-- ── The test ─────────────────────────────────────────────────────────────────────────────────────────────────────────

check.case("wrong calls are errors at their line that name the argument and what it must be", function()
  local wrong, faults = calls.wrong(), {}
  for _, call in ipairs(wrong) do
    if arg[1] == "trace" then io.stderr:write(title(call), "\n") end
    local found = fault(call)
    if found then faults[#faults + 1] = ("%s: %s"):format(title(call), found) end
  end
  print(#wrong .. " wrong calls")
  check.equal(#wrong > 4000, true)
  if #faults > 0 then error(("%d faults\n%s"):format(#faults, table.concat(faults, "\n"))) end
end)
