-- All help pages as one Markdown page, share/doc/reference.md; scripts/reference writes it.

local core = require "signorini.core"
local examples_of = require "signorini.help.examples"
local subjects = require "signorini.help.subjects"
local texts = require "signorini.help.texts"

local head = [[
# Reference

Every function of the language, as `help` shows it at the prompt; `scripts/reference` writes this page from the same
texts. Named arguments stand in braces with their defaults; those without one, unless the text says so, are needed.
Units are yours, as long as they are consistent; angles are degrees; directions and indices count from 1.
]]

--- Pages on parts of a scene, by title.
local parts_of_scene = { { "Supports", "support" }, { "Loads", "load" }, { "Contacts", "contact" },
                         { "Stages", "stage" } }

local function add(lines, ...)
  for _, line in ipairs { ... } do lines[#lines + 1] = line end
end

local function add_page(lines, name)
  local text, examples = examples_of(core.docs[name])
  add(lines, "", "### " .. name, "", "```text", text, "```")
  if #examples > 0 then add(lines, "", "```lua", table.concat(examples, "\n"), "```") end
end

local function add_text(lines, title, name)
  add(lines, "", "## " .. title, "", "```text", texts[name], "```")
end

--- The text of the page.
return function()
  local lines = { head }
  local parts = { "Labels", "Geometry" }
  for _, part in ipairs(parts_of_scene) do parts[#parts + 1] = part[1] end
  for _, group in ipairs(subjects.groups) do parts[#parts + 1] = group.title end
  parts[#parts + 1], parts[#parts + 2] = "The scene of the examples", "The prompt"
  for _, title in ipairs(parts) do
    add(lines, ("- [%s](#%s)"):format(title, title:lower():gsub("[,:']", ""):gsub(" ", "-")))
  end
  add_text(lines, "Labels", "labels")
  add_text(lines, "Geometry", "geometry")
  for _, part in ipairs(parts_of_scene) do add_text(lines, table.unpack(part)) end
  for _, group in ipairs(subjects.groups) do
    add(lines, "", "## " .. group.title)
    for _, name in ipairs(subjects.pages(group)) do add_page(lines, name) end
  end
  add(lines, "", "## The scene of the examples", "", "```lua", texts.scene, "```")
  add_text(lines, "The prompt", "prompt")
  return table.concat(lines, "\n") .. "\n"
end
