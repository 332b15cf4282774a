-- help(): the pages of the functions (signorini.pages), texts on subjects, headers of the supplied scripts, and answers
-- to terms of other programs (signorini.help.synonyms).

local core = require "signorini.core"
local cut = require("signorini.call.text").cut
local pages = require "signorini.pages"
local scripts = require "signorini.prompt.help.scripts"
local named = require "signorini.call.named"
local paged = require "signorini.prompt.help.paged"
local show = require "signorini.prompt.show"
local lists = require "signorini.call.lists"
local meant = require("signorini.call.text").meant
local synonyms = require "signorini.prompt.help.synonyms"
local texts = require "signorini.prompt.help.texts"
local with_article = require("signorini.call.describe").with_article
local wrapped = require("signorini.call.text").wrapped

local help = {}

local shortest = 3 -- word that ?word searches for
local width, widest_head = 118, 46 -- characters of a line, and of its left column

--- Lines of two columns, { left, right } each.
local function two_columns(entries)
  local most, lines = 0, {}
  for _, entry in ipairs(entries) do most = math.max(most, utf8.len(entry[1])) end
  for i, entry in ipairs(entries) do
    local blanks = (" "):rep(most - utf8.len(entry[1]))
    lines[i] = ("  %s%s  %s"):format(entry[1], blanks, cut(entry[2], width - most - 4))
  end
  return table.concat(lines, "\n")
end

--- One line per page: how to call the function, and the first sentence.
local function list(title, found)
  return title .. "\n" .. two_columns(lists.map(found, function(page)
    return { pages.short_head(page, widest_head), pages.summary(page) }
  end))
end

local function script_list(title, found)
  return title .. "\n" .. two_columns(lists.map(found, function(script) return { script.name, script.title } end))
end

local function all_scripts()
  return script_list("Supplied scripts; signorini <name> runs one, signorini <name> help lists its arguments,\n"
    .. "help \"<name>\" describes it:", scripts.all())
end

--- The pages of the functions in a table such as sg.nurbs.
local function table_page(value)
  local names = {}
  local function collect(entries, depth)
    for _, entry in next, named.entries(entries) do
      local name = core.names[entry]
      if name then names[name] = true elseif type(entry) == "table" and depth < 2 then collect(entry, depth + 1) end
    end
  end
  collect(value, 1)
  local found = lists.map(lists.filter(lists.sorted_names(names), pages.find), pages.find)
  if #found == 0 then return "This table has no help page. help() lists topics." end
  return list("Functions:", found)
end

--- Everything that contains a word: pages (in full the one with this name) and scripts.
local function search(word)
  local parts = {}
  local names = lists.filter(pages.names(), function(name)
    return (name .. "\n" .. pages.text(name)):lower():find(word:lower(), 1, true)
  end)
  local own = lists.filter(names, function(name) return name:match "[^.:]+$" == word end)
  local found = lists.map(names, pages.find)
  if #own == 1 then parts[#parts + 1] = pages.text(own[1]) end
  if #found > 0 then parts[#parts + 1] = list(("Pages with '%s':"):format(word), found) end
  local of_scripts = scripts.with(word)
  if #of_scripts > 0 then parts[#parts + 1] = script_list(("Scripts with '%s':"):format(word), of_scripts) end
  return #parts > 0 and table.concat(parts, "\n\n") or nil
end

--- A term as synonyms are compared: lower case, single blanks, without the plural's s.
local function normalized(term)
  return (term:lower():gsub("[-_%s]+", " "):gsub("^ ", ""):gsub(" $", ""):gsub("s$", ""))
end

--- The answer to a term that other programs use, with its pages, or nil.
local function synonym_page(word)
  for _, entry in ipairs(synonyms) do
    for term in entry[1]:gmatch "[^,]+" do
      if normalized(term) == normalized(word) then
        local answer = {}
        for part in entry[2]:gmatch "%S+" do answer[#answer + 1] = part end
        return table.concat(wrapped(answer, width, "", ""), "\n") .. "\n"
          .. list("See:", lists.map({ table.unpack(entry, 3) }, pages.find))
      end
    end
  end
end

--- The words of pages, texts and groups, sorted.
function help.words()
  local groups = lists.map(pages.groups(), function(group) return group.word end)
  local known = lists.unique(lists.joined({ "gallery" }, pages.names(), lists.sorted_names(texts), groups))
  table.sort(known)
  return known
end

local function words_of_pages()
  local found = {}
  for _, name in ipairs(pages.names()) do
    for word in pages.text(name):lower():gmatch "%a%a%a%a+" do found[word] = true end
  end
  return lists.sorted_names(found)
end

local function no_page(word)
  local known = lists.joined(help.words(), lists.map(pages.names(), function(name) return name:match "[^.:]+$" end),
    lists.map(scripts.all(), function(script) return script.name end))
  table.sort(known)
  local hint = meant(word, known)
  if hint == "" then hint = meant(word:match "[^.:]*$", known) end
  if hint == "" then hint = meant(word:lower(), words_of_pages()) end
  return ("There is no page on '%s'%s"):format(word, hint ~= "" and hint or ". help() lists topics.")
end

local function group_page(word)
  for _, group in ipairs(pages.groups()) do
    if group.word == word or group.also == word then
      local found = list(group.title .. ":", group)
      return word == "scripts" and found .. "\n\n" .. all_scripts() or found
    end
  end
end

local function script_page(word)
  local script = scripts.of(word)
  return script and ("%s\n\n%s"):format(script.path, script.header)
end

--- "model:run" of "m:run" and "model.run".
local owners = { b = "body", m = "model", p = "patch" }
local function spelled_out(word)
  local owner, method = word:match "^(%a+)[.:]([%w_]+)$"
  return owner and ("%s:%s"):format(owners[owner] or owner, method) or ""
end

local function word_page(word)
  if not word:find "%w" or word == "exit" or word == "quit" then return texts.prompt end -- also ?_
  if word == "gallery" then return all_scripts() end
  local page = texts[word] or pages.text(word) or pages.text("sg." .. word) or pages.text(spelled_out(word))
    or group_page(word) or script_page(word)
  if page then return page end
  local answer, found = synonym_page(word), search(word)
  if answer and found then return answer .. "\n\n" .. found end
  return answer or found
end

--- The page of a value: of a function, or of an object's type; nil for others.
local function page_of(value)
  local methods = type(value) == "table" and getmetatable(value) or nil
  return pages.find(core.names[value] or core.names[methods] or core.kind(value))
end

local function value_page(value)
  local page = page_of(value)
  if page then return pages.text(page.name) end
  return type(value) == "table" and table_page(value)
    or ("There is no help page for %s."):format(with_article(core.kind(value)))
end

--- sg.help.
function help.show(...)
  local value = ...
  if select("#", ...) == 0 then return print(texts.start) end
  if value == nil then return print "help(nil): this name is not defined. help() lists topics." end
  paged(type(value) == "string" and (word_page(value) or no_page(value)) or value_page(value))
end

--- The global value of a path of names such as "sg.shapes", "run:column" or "x.y", or nil.
local function look_up(path)
  local value = _G
  for name in path:gmatch "[^.:]+" do
    local found, entry = pcall(function()
      if value == _G then return rawget(_G, name) end
      return value[name]
    end)
    if not found or entry == nil then return nil end
    value = entry
  end
  return value
end

--- What a path of names such as "sg.body" or "m:run" denotes: its value, and the page of it or of its type, or nil.
function help.about(path)
  local value = look_up(path)
  return value, pages.find(path) or value ~= nil and page_of(value) or nil
end

--- The page, and its rows, of what precedes the last name in "sg.body.order" or "r.iterations", and that name; nil if
--- there is none.
local function rows_before(word)
  local owner, key = word:match "^(.+)[.:]([%w_]+)$"
  local page = owner and (pages.find(owner) or pages.find("sg." .. owner) or page_of(look_up(owner)))
  local rows = page and (page.named or page.arguments or page.fields)
  if rows then return page, rows, key end
end

--- The text of an argument or a field; with the value of a variable's field.
local function row_text(word, value)
  local page, rows, key = rows_before(word)
  local row = page and pages.row(rows, key)
  if not row then return nil end
  local text = ("%s of %s\n%s"):format(page.fields and "Field" or "Argument", page.name,
    require("signorini.prompt.help.page_text").row(row))
  return value == nil and text or ("%s\nvalue: %s"):format(text, show.text(value))
end

--- True for a function of the library, or a table of them such as sg.shapes.
local function is_of_library(value)
  if value == core.sg or core.names[value] then return true end
  for _, entry in next, named.entries(core.sg) do
    if entry == value then return true end
  end
  return false
end

--- The text of a variable: its value in short, then the page of its type, if there is one.
local function variable_text(name, value)
  local page = page_of(value)
  local text = ("%s, %s: %s"):format(name, with_article(pages.kind(value)), show.text(value))
  return page and ("%s\n\n%s"):format(text, pages.text(page.name)) or text
end

--- Answers ?query at the prompt: the page of that name, of an argument, a field or a variable, else a search. Raises an
--- error if nothing is found.
function help.ask(query)
  local word = query:match "^%s*([%a_][%w_.:]*)%s*[({]" or query:match "^%s*(.-)%s*$"
  if word == "" then return help.show() end
  if word == "_" or word:find "^[%%!]" then return paged(texts.prompt) end
  if pages.find(word) or texts[word] then return help.show(word) end
  local value
  if word:find "^[%a_][%w_.:]*$" then value = look_up(word) end
  if value ~= nil and is_of_library(value) then return help.show(value) end
  local owner = word:match "^(.+)[.:][%w_]+$"
  local is_searched = #word >= shortest and not (owner and look_up(owner) ~= nil)
  local text = row_text(word, value) or value ~= nil and variable_text(word, value) or is_searched and word_page(word)
  if text then return paged(text) end
  local page, rows, key = rows_before(word)
  if not page then core.fail(no_page(word)) end
  core.fail(("%s has no %s '%s'%s"):format(page.name, page.fields and "field" or "argument", key,
    meant(key, pages.keys(rows))))
end

return help
