-- Checks single values, not tables of others, against types. For each kind a function of type and value, which returns
-- true if the value fits, otherwise false, a hint if one is known, and the expectation if it differs from describe.one.

local core = require "signorini.core"
local describe = require "signorini.call.describe"
local lists = require "signorini.call.lists"
local meant = require("signorini.call.text").meant
local pages = require "signorini.pages"

local fits = {}

local function is_finite(value) return value == value and value ~= math.huge and value ~= -math.huge end

local function number_cure(value)
  if type(value) == "string" and tonumber(value) then return "remove the quotes" end
  if type(value) == "table" then return "write a plain number without braces" end
end

local function in_range(of, value)
  return not (of.low and value < of.low or of.above and value <= of.above or of.high and value > of.high
    or of.below and value >= of.below)
end

local function range_cure(of, value)
  if of.above and value <= of.above then return "give a value above " .. describe.literal(of.above) end
  if of.low and value < of.low then return "give a value from " .. describe.literal(of.low) end
  return of.below and "give a value below " .. describe.literal(of.below) or
    "give a value up to " .. describe.literal(of.high)
end

function fits.any() return true end
function fits.flag(_, value) return type(value) == "boolean" end
function fits.text(of, value)
  return type(value) == "string", of.cure or type(value) ~= "table" and "write it in quotes" or nil
end
fits["function"] = function(of, value) return type(value) == "function", of.cure end
function fits.only(of, value) return value == of.value end
function fits.data(_, value)
  local ok, message = pcall(core.write_json, value, "it")
  return ok, not ok and message:gsub("^.-:%d+: ", "", 1) or nil
end

function fits.number(of, value)
  if type(value) ~= "number" then return false, number_cure(value) end
  if not is_finite(value) then
    return of.gaps, "look for a division by zero in its computation", "a finite number"
  end
  if not in_range(of, value) then return false, of.cure or range_cure(of, value) end
  return true
end

function fits.integer(of, value)
  if type(value) ~= "number" then return false, number_cure(value) end
  local whole = math.tointeger(value)
  if not whole then return false, "give a value without a fraction" end
  if not in_range(of, whole) then return false, range_cure(of, whole) end
  return true
end

function fits.choice(of, value)
  if lists.holds(of.of, value) then return true end
  if type(value) ~= "string" then return false, of.cure or type(value) ~= "table" and "write it in quotes" or nil end
  return false, meant(value, of.of):match "did .*" or "take one of these"
end

function fits.object(of, value)
  local cure = of.cure
  if type(cure) == "function" then cure = cure(value) end
  return pages.kind(value) == of.name, cure
end

fits["table"] = function(of, value) return type(value) == "table", of.cure end

return fits
