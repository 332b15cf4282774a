-- Words of messages and pages, and of commands of the shell.

local core = require "signorini.core"

local text = {}

--- A number with its noun: "1 case", "2 cases".
function text.counted(count, noun) return ("%d %s%s"):format(count, noun, count == 1 and "" or "s") end

--- Shortens a text to a number of characters, with an ellipsis in place of the rest.
function text.cut(long, most)
  if (utf8.len(long) or #long) <= most then return long end
  return long:sub(1, (utf8.offset(long, most) or most) - 1) .. "…"
end

--- A word of a shell command, in quotes.
function text.quoted(word) return "'" .. tostring(word):gsub("'", [['\'']]) .. "'" end

--- Words in lines of at most `width` characters: `first` precedes the first word, `indent` those of further lines.
function text.wrapped(words, width, first, indent)
  local lines, line, is_empty = {}, first, true
  for _, word in ipairs(words) do
    local size = utf8.len(word) or #word
    if not is_empty and (utf8.len(line) or #line) + 1 + size > width then
      lines[#lines + 1], line, is_empty = line, indent, true
    end
    line, is_empty = line .. (is_empty and "" or " ") .. word, false
  end
  lines[#lines + 1] = line:match "^(.-)%s*$"
  return lines
end

--- The end of a message about an unknown name: "; did you mean 'refine'?", or an empty string.
function text.meant(name, known)
  local meant = type(name) == "string" and core.nearest(name, known)
  return meant and ("; did you mean '%s'?"):format(meant) or ""
end

--- Raises an error of the function `where` about a name that no column has.
function text.no_column(where, name, columns)
  local hint = text.meant(name, columns)
  core.fail(("%s: there is no column '%s'%s known: %s"):format(where, name, hint == "" and ";" or hint,
    table.concat(columns, ", ")))
end

return text
