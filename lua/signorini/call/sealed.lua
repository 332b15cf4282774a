-- Tables of the library, such as sg and sg.shapes: a misspelled name is an error, not nil, and so is an assignment.
-- Their entries are in a hidden table, because Lua reports only assignments to names that a table does not have.

local core = require "signorini.core"
local meant = require("signorini.call.text").meant
local sorted_names = require("signorini.call.lists").sorted_names

local sealed = {}

local hidden = setmetatable({}, { __mode = "k" })

--- The entries of a table, for `next`: sealed or not.
function sealed.entries(of) return hidden[of] or of end

--- Seals a table. `path`: its name, "sg.shapes"; `text`: what print shows.
function sealed.seal(of, path, text)
  local entries = {}
  for key, entry in next, of do entries[key] = entry end
  for key in next, entries do of[key] = nil end
  hidden[of] = setmetatable(entries, { __index = function(_, key)
    core.fail(("there is no %s.%s%s"):format(path, tostring(key), meant(tostring(key), sorted_names(entries))))
  end })
  return setmetatable(of, {
    __index = entries, __tostring = function() return text(entries, path) end,
    __pairs = function() return next, entries, nil end,
    __newindex = function(_, key)
      core.fail(("%s.%s cannot be assigned: %s belongs to the program. Hint: keep your own values in local variables")
        :format(path, tostring(key), path))
    end,
  })
end

return sealed
