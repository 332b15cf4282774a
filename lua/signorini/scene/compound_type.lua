-- The type of bodies of several patches, with sg.body and sg.model that accept them; compound.lua is loaded for the
-- first one. Both keep the tables with which they are called.

local core = require "signorini.core"
local history = require "signorini.errors.history"
local recipes = require "signorini.scene.recipes"

local Compound = { __name = "compound" }
Compound.__index = Compound
core.types.compound = Compound

for _, name in ipairs { "corner", "edge", "face", "part" } do
  Compound[name] = function(...) return require("signorini.scene.compound")[name](...) end
end
-- An unknown method is an error, as that of bodies is.
setmetatable(Compound, { __index = function(_, name)
  if type(name) ~= "string" or name:find "^__" then return nil end
  core.fail(("a compound has no method '%s'; it has corner, edge, face, part. Hint: its parts are bodies, as in "
    .. "compound:part(1):%s(…)"):format(name, name))
end })
function Compound:__tostring() return require("signorini.scene.compound").text(self) end

local function has_compound(bodies)
  for _, body in pairs(bodies) do
    if getmetatable(body) == Compound then return true end
  end
  return false
end

--- An entry of named arguments; nil for other values, such as a study, whose names are checked.
local function entry(values, key)
  if type(values) ~= "table" then return nil end
  local of = getmetatable(values)
  if type(of) == "table" and rawget(of, "__name") then return nil end
  return values[key]
end

--- Replaces a function of sg by one of the same name, which calls the original.
local function replace(sg, key, make)
  local name = "sg." .. key
  sg[key] = core.offered(make(sg[key]))
  core.names[sg[key]] = name
end

return function(sg)
  replace(sg, "body", function(body)
    return function(values, ...)
      local several = type(entry(values, "patch")) == "table"
      if several and select("#", ...) == 0 then
        return recipes.keep(require("signorini.scene.compound").new(body, values), values)
      end
      return recipes.keep(body(values, ...), values)
    end
  end)
  replace(sg, "model", function(model)
    return function(values, ...)
      local bodies = entry(values, "bodies")
      local several = type(bodies) == "table" and has_compound(bodies)
      local whole = values
      if several and select("#", ...) == 0 then whole = require("signorini.scene.compound").expanded(values) end
      local made = recipes.keep(model(whole, ...), values)
      history.begin(made)
      return made
    end
  end)
end
