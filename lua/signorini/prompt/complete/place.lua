-- The position in a call at which a text ends.

local place = {}

--- The text without strings and closed brackets; `open`: whether it ends inside quotes, which are removed.
local function bare(text)
  local open = false
  text = text:gsub("\\.", ""):gsub('"[^"\n]*"', "0"):gsub("'[^'\n]*'", "0")
  text, open = text:gsub("[\"'][^\"'\n]*$", "", 1)
  local before
  repeat
    before = text
    text = text:gsub("%b{}", "0"):gsub("%b()", "0")
  until text == before
  return text, open > 0
end

--- True if a text ends inside quotes.
function place.is_open(text) return select(2, bare(text)) end

local function path_at_end(text) return text:match "([%a_][%w_.:]*)%s*$" end
local function key_at_end(text) return text:match "([%a_][%w_]*)%s*=%s*$" end

--- The commas outside of all brackets.
local function commas(text) return select(2, text:gsub(",", "")) end

--- The innermost call in which a text ends, or nil: path (of names, "sg.body", "p:refine"), argument (its number),
--- first (the text of the first argument), keys (the path from there through braces: a name, or false for an entry of a
--- list), behind (the text in the last brackets), in_braces (whether these are braces), quoted (whether it ends inside
--- quotes).
function place.of(text)
  local code, quoted = bare(text)
  local keys, at, behind, in_braces = {}, #code, nil, nil
  local path = quoted and path_at_end(code)
  if path then return { path = path, argument = 1, first = "", keys = keys, behind = "", quoted = true } end
  while at > 0 do
    local bracket = code:sub(at, at)
    if bracket == "{" or bracket == "(" then
      local before = code:sub(1, at - 1)
      local inside = code:sub(at + 1)
      if not behind then behind, in_braces = inside, bracket == "{" end
      path = path_at_end(before)
      local key = not path and key_at_end(before)
      if path then
        local argument = bracket == "(" and commas(inside:match "^[^{(]*") + 1 or 1
        return { path = path, argument = argument, first = inside:match "^%s*([%w_.:]*)", keys = keys, behind = behind,
                 in_braces = in_braces, quoted = quoted }
      elseif bracket == "{" and (key or before:find "[{(,;]%s*$") then
        -- the braces of an argument count only if they are nested
        if not before:find "%(%s*$" and not (before:find "%([^{(]*,%s*$") then table.insert(keys, 1, key or false) end
      else
        return nil
      end
    end
    at = at - 1
  end
end

return place
