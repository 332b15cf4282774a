-- What a front end shows of a name: its value if it is a variable, and the help page.

local core = require "signorini.core"
local help = require "signorini.prompt.help"
local page_text = require "signorini.prompt.help.page_text"
local show = require "signorini.prompt.show"

local function fenced(language, text) return ("```%s\n%s\n```"):format(language, text) end

--- The formats by MIME type of a path of names such as "sg.body" or "m:run"; nil if it has neither value nor page.
return function(path)
  local value, page = help.about(path)
  if value == nil and not page then return nil end
  local plain, marked = {}, {}
  local function add(text, mark) plain[#plain + 1], marked[#marked + 1] = text, mark end
  if value ~= nil and not core.names[value] then
    local text = show.text(value)
    add(text, fenced("text", text))
  end
  if page then
    local text, examples = page_text.whole(page, true), page_text.examples(page)
    add(text, ("### %s\n\n%s"):format(page.name, fenced("text", text)))
    if #examples > 0 then
      local code = table.concat(examples, "\n")
      add("Example:\n" .. code, fenced("lua", code))
    end
  end
  return { ["text/plain"] = table.concat(plain, "\n\n"), ["text/markdown"] = table.concat(marked, "\n\n") }
end
