-- Completion in the commands of the prompt: names after %, files after %run and !, words of help after ?.

local core = require "signorini.core"
local lists = require "signorini.call.lists"

--- Names of files and folders that begin like a path; hidden ones if it asks for them. `is_script`: only those of Lua.
local function files(path, is_script)
  local folder, beginning = path:match "^(.*/)([^/]*)$"
  if not folder then folder, beginning = "", path end
  local listed, names = pcall(core.list_folder, folder == "" and "." or folder)
  local found = lists.filter(listed and names or {}, function(name)
    return name:sub(1, #beginning) == beginning and (name:sub(1, 1) ~= "." or beginning:sub(1, 1) == ".")
  end)
  found = lists.map(found, function(name)
    return folder .. name .. (core.exists(folder .. name .. "/.") and "/" or "")
  end)
  return is_script and lists.filter(found, function(name) return name:find "/$" or name:find "%.lua$" end) or found
end

--- The names that begin with a text.
local function beginning(names, start)
  return lists.filter(names, function(name) return name:sub(1, #start) == start end)
end

--- Those scripts that are supplied, if no file begins like this.
local function scripts(path)
  local found = files(path, true)
  if #found > 0 or path:find "^[./]" then return found end
  local all = lists.map(require("signorini.prompt.help.scripts").all(), function(script) return script.name end)
  return beginning(all, path)
end

--- The completions of a word after a text that ends in a command's line; nil if it does not. names: those of the
--- variables that begin like the word.
return function(word, before, names)
  local line = before:match "[^\n]*$"
  if line:find "^%s*%%$" then
    return beginning(require("signorini.prompt.commands").names(), word)
  end
  if line:find "^%s*%?+$" then
    local pages = beginning(require("signorini.prompt.help").words(), word)
    local all = lists.unique(lists.joined(names(), pages))
    table.sort(all)
    return all
  end
  local run, rest = line:match "^%s*%%run%s+()(.*)$"
  if not run then rest = line:match "^%s*!(.*)$" end
  if not rest then return nil end
  local begun = rest:match "%S*$" -- what belongs to the path before the word
  local path = begun .. word
  local found = run and not rest:find "%s" and scripts(path) or files(path)
  return lists.map(found, function(name) return name:sub(#begun + 1) end)
end
