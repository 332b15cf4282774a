-- All help pages in Markdown, the pages of share/doc/reference that scripts/reference writes: one for each subject, and
-- reference.md with an alphabetical index and the texts on subjects.

local examples_of = require("signorini.prompt.help.page_text").examples
local page_text = require("signorini.prompt.help.page_text").whole
local lists = require "signorini.call.lists"
local pages = require "signorini.pages"
local texts = require "signorini.prompt.help.texts"

local head = [[
# Reference

All functions of the Lua interface, as shown by `help` at the prompt; `scripts/reference` generates these pages from the
same tables. Named arguments are in braces with their defaults; those without a default are required unless stated
otherwise. Any consistent units can be used; angles are in degrees; directions and indices count from 1.
]]

--- Texts on subjects, as sections of reference.md.
local sections = { { "orders", "Order labels" }, { "units", "Units" }, { "quasi-static", "Quasi-static solutions" },
                   { "geometry", "Geometry" }, { "prompt", "The prompt" } }

local function add(lines, ...)
  for _, line in ipairs { ... } do lines[#lines + 1] = line end
end

--- The part of an address that leads to a heading.
local function anchor(heading) return "#" .. heading:lower():gsub("[^%w_ -]", ""):gsub(" ", "-") end

--- Addresses of pages, subjects and texts by the words that help knows.
local function addresses()
  local found = {}
  for _, section in ipairs(sections) do found[section[1]] = "reference.md" .. anchor(section[2]) end
  found.examples = "reference.md" .. anchor "The scene of the examples"
  for _, group in ipairs(pages.groups()) do
    found[group.word] = group.word .. ".md"
    for _, page in ipairs(group) do found[page.name] = group.word .. ".md" .. anchor(page.name) end
  end
  return found
end

--- Links to everything that a page's text mentions, or nil.
local function links(page, text, found)
  local seen, list = { [page.name] = true }, {}
  local function mention(word, address)
    if address and not seen[word] then
      seen[word], list[#list + 1] = true, ("[%s](%s)"):format(word, address)
    end
  end
  for word in text:gmatch 'help "([^"]+)"' do mention(word, found[word]) end
  for word in text:gmatch "%f[%w]%l+[.:][%l_.]*[%w_]+" do mention(word, found[word]) end
  for folder, name in text:gmatch "share/doc/(%l+)/([%l_%d]+)%.md" do
    mention(name, folder == "reference" and name .. ".md" or ("../%s/%s.md"):format(folder, name))
  end
  return #list > 0 and "See " .. table.concat(list, ", ") .. "." or nil
end

local function add_page(lines, page, found)
  local examples, text = examples_of(page), page_text(page, true)
  add(lines, "", "### " .. page.name, "", "```text", text, "```")
  if #examples > 0 then add(lines, "", "```lua", table.concat(examples, "\n"), "```") end
  local see = links(page, text, found)
  if see then add(lines, "", see) end
end

--- Lines of the alphabetical index: names by the first letter of their last part.
local function index(found)
  local by_letter = {}
  for _, name in ipairs(pages.names()) do
    local letter = name:match("[^.:]+$"):sub(1, 1):upper()
    by_letter[letter] = by_letter[letter] or {}
    table.insert(by_letter[letter], ("[%s](%s)"):format(name, found[name]))
  end
  return lists.map(lists.sorted_names(by_letter), function(letter)
    table.sort(by_letter[letter], function(a, b) return a:match "[^.:%[]+%]":lower() < b:match "[^.:%[]+%]":lower() end)
    return ("| %s | %s |"):format(letter, table.concat(by_letter[letter], ", "))
  end)
end

--- The texts of the pages by the names of their files.
return function()
  local found, files = addresses(), {}
  local lines = { head, "| subject | functions and types |", "|---|---|" }
  for _, group in ipairs(pages.groups()) do
    add(lines, ("| [%s](%s) | %d |"):format(group.title, found[group.word], #group))
    local own = { "# " .. group.title, "", "[All functions](reference.md#index)" }
    for _, page in ipairs(group) do add_page(own, page, found) end
    files[group.word .. ".md"] = table.concat(own, "\n") .. "\n"
  end
  add(lines, "", "## Index", "", "| | |", "|---|---|")
  add(lines, table.unpack(index(found)))
  for _, section in ipairs(sections) do
    add(lines, "", "## " .. section[2], "", "```text", texts[section[1]], "```")
  end
  add(lines, "", "## The scene of the examples", "", "```lua", texts.scene, "```")
  files["reference.md"] = table.concat(lines, "\n") .. "\n"
  return files
end
