-- Tables and objects that raise an error on names they do not have; sealed ones, such as sg, also on assignments.

local core = require "signorini.core"
local lists = require "signorini.call.lists"
local meant = require("signorini.call.text").meant
local with_article = require("signorini.call.describe").with_article

local named = {}

--- Raises an error about a name that `what` ("a run") does not have, with the most similar one. `entries`: in words,
--- what it has instead of entries by number.
function named.missing(what, name, known, entries)
  table.sort(known)
  if entries and type(name) ~= "string" then
    core.fail(("%s has no entry %s: it has %s; they are %s"):format(what, core.describe(name), entries,
      table.concat(known, ", ")))
  end
  local hint = meant(name, known)
  core.fail(("%s has no '%s'%s %s"):format(what, tostring(name), hint == "" and ": it has" or hint .. " It has",
    table.concat(known, ", ")))
end

--- Makes a table strict: names that it does not have are errors, not nil. `by_number`: see named.missing.
function named.strict(what, entries, by_number)
  return setmetatable(entries, { __name = what:match "^an? (.*)", __index = function(_, name)
    named.missing(what, name, lists.sorted_names(entries), by_number)
  end })
end

--- Makes a type of objects strict, such as runs and studies: names other than the fields on its page and the methods
--- with a page are errors, except private ones, given as a string of names, which may be missing. Returns these as a
--- set.
function named.strict_type(methods, noun, private)
  local may_be_missing = {}
  for name in private:gmatch "%S+" do may_be_missing[name] = true end
  setmetatable(methods, { __index = function(_, name)
    if may_be_missing[name] or type(name) == "string" and name:find "^__" then return nil end
    if type(name) == "number" and rawget(methods, "__len") then return nil end -- as of any list
    local pages = require "signorini.pages"
    local public = lists.filter(lists.sorted_names(methods), function(method)
      return pages.find(("%s:%s"):format(noun, method))
    end)
    named.missing(with_article(noun), name, lists.joined(pages.keys(pages.find(noun).fields), public))
  end })
  return may_be_missing
end

-- Entries of sealed tables, because Lua reports only assignments to names that a table does not have.
local hidden = setmetatable({}, { __mode = "k" })

--- The entries of a table, for `next`: sealed or not.
function named.entries(of) return hidden[of] or of end

--- Seals a table of the library. `path`: its name, "sg.shapes"; `text`: what print shows.
function named.seal(of, path, text)
  local entries = {}
  for key, entry in next, of do entries[key] = entry end
  for key in next, entries do of[key] = nil end
  hidden[of] = setmetatable(entries, { __index = function(_, key)
    core.fail(("there is no %s.%s%s"):format(path, tostring(key), meant(tostring(key), lists.sorted_names(entries))))
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

return named
