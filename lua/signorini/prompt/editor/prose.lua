-- Text of help pages as lines of Markdown in comments that begin with ---, which editors show.

local wrapped = require("signorini.call.text").wrapped

local width = 120 -- characters of a line

local prose = {}

--- Markdown for text: what it would take for emphasis, tags, lists or headings is escaped.
local function escaped(text) return (text:gsub("[<*]", "\\%0")) end

--- A line must not begin with what annotations (| and @) or Markdown give a meaning.
local function begun(line)
  return (line:gsub("^([|@#>+-])", "\\%1"):gsub("^(%d+)([.)]%s)", "%1\\%2"))
end

--- Adds a block of code to lines.
function prose.add_code(lines, code, language)
  lines[#lines + 1] = "---```" .. language
  for line in (code .. "\n"):gmatch "([^\n]*)\n" do lines[#lines + 1] = "---" .. line end
  lines[#lines + 1] = "---```"
end

--- Adds how a function is called to lines.
function prose.add_head(lines, head)
  local words = {}
  for word in head:gmatch "%S+" do words[#words + 1] = word end
  prose.add_code(lines, table.concat(wrapped(words, width - 3, "", "  "), "\n"), "text")
end

--- Adds a text to lines: paragraphs are filled, lines that begin with a blank are code; a source starts a paragraph.
function prose.add_text(lines, text)
  local words, code = {}, {}
  local function flush()
    if #words > 0 then
      for _, line in ipairs(wrapped(words, width - 3, "", "")) do lines[#lines + 1] = "---" .. begun(line) end
    end
    if #code > 0 then prose.add_code(lines, table.concat(code, "\n"), "text") end
    words, code = {}, {}
  end
  for line in (text .. "\n"):gmatch "([^\n]*)\n" do
    local is_code = line:find "^%s+%S"
    if line == "" or line:find "^Source" or is_code and #words > 0 or not is_code and #code > 0 then flush() end
    if line:find "^Source" and lines[#lines] ~= "---" then lines[#lines + 1] = "---" end
    if is_code then
      code[#code + 1] = line
    else
      for word in escaped(line):gmatch "%S+" do words[#words + 1] = word end
    end
  end
  flush()
end

--- The text in one line, for the description of a parameter.
function prose.line(text) return (escaped(text:gsub("%s+", " "))) end

return prose
