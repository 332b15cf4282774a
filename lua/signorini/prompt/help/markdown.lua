-- All help pages as one Markdown page, share/doc/reference/reference.md; scripts/reference writes it.

local examples_of = require("signorini.prompt.help.page_text").examples
local page_text = require("signorini.prompt.help.page_text").whole
local lists = require "signorini.call.lists"
local pages = require "signorini.pages"
local texts = require "signorini.prompt.help.texts"

local head = [[
# Reference

All functions of the Lua interface, as shown by `help` at the prompt; `scripts/reference` generates this page from the
same tables. Named arguments are in braces with their defaults; those without a default are required unless stated
otherwise. Any consistent units can be used; angles are in degrees; directions and indices count from 1.
]]

local function add(lines, ...)
  for _, line in ipairs { ... } do lines[#lines + 1] = line end
end

local function add_page(lines, page)
  local examples = examples_of(page)
  add(lines, "", "### " .. page.name, "", "```text", page_text(page, true), "```")
  if #examples > 0 then add(lines, "", "```lua", table.concat(examples, "\n"), "```") end
end

--- The text of the page.
return function()
  local lines, titles = { head }, lists.map(pages.groups(), function(group) return group.title end)
  for _, title in ipairs(lists.joined(titles, { "The scene of the examples", "The prompt" })) do
    add(lines, ("- [%s](#%s)"):format(title, title:lower():gsub("[,:']", ""):gsub(" ", "-")))
  end
  for _, group in ipairs(pages.groups()) do
    add(lines, "", "## " .. group.title)
    for _, page in ipairs(group) do add_page(lines, page) end
  end
  add(lines, "", "## The scene of the examples", "", "```lua", texts.scene, "```")
  add(lines, "", "## The prompt", "", "```text", texts.prompt, "```")
  return table.concat(lines, "\n") .. "\n"
end
