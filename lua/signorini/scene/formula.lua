-- Formulas of the user: a function is called once with symbols, and returns its formula.

local core = require "signorini.core"
local check = require "signorini.call.check"
local counted = require("signorini.call.text").counted
local lists = require "signorini.call.lists"
local sealed = require "signorini.call.sealed"

local formula = {}

--- A hint for an error in the function, such as math.log of a symbol, or "".
local function cure(message)
  local name = message:match "'(%w+)' %(number expected, got symbol%)"
  if not name then return "" end
  if not rawget(sealed.entries(core.sg), name) then return ". Hint: help 'formulas' lists the functions of symbols" end
  return (". Hint: use sg.%s, which accepts symbols"):format(name)
end

--- The formula that a function of symbols returns; `where`: the function that the user has called, `name`: the argument
--- that holds the function.
function formula.of(where, name, f, symbols)
  local ok, result = pcall(f, table.unpack(symbols))
  if not ok then error(type(result) == "string" and result .. cure(result) or result, 0) end
  if type(result) == "number" then
    core.fail(("%s: %s must return a formula of its arguments, got the number %s"):format(where, name, result))
  end
  if core.kind(result) ~= "symbol" then
    check.reject(where, "the result of " .. name, "a formula of its arguments", result,
      result == nil and "write return before the formula" or nil)
  end
  return result
end

--- Raises an error unless a function has as many parameters as there are arguments for it; `fewer`: or less.
function formula.check_parameters(where, name, f, symbols, fewer, hint)
  local about = debug.getinfo(f, "u")
  local takes, has = about.nparams, #symbols
  if about.isvararg or takes == has or (fewer and takes < has) then return end
  core.fail(("%s: %s must take %s, %s, but takes %d. Hint: %s"):format(where, name, counted(has, "argument"),
    table.concat(lists.map(symbols, tostring), ", "), takes, hint))
end

return formula
