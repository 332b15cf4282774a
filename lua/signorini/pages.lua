-- The tables of the functions: one page each, used for checks of calls (check.lua), help, Tab completion, the
-- reference, and the tests of wrong calls. A page is
--
--     { "sg.f", "What it does.", named = rows or arguments = rows, more = …, returns = type, example = … }
--
-- named: the rows of one table of named arguments, sg.f{ … }; arguments: those of positional arguments, sg.f(a, b);
-- neither: it has no arguments. rest: the type of named arguments with other keys, which are errors without it. After
-- loading it also has the fields `name` and `text`. may_be_empty: the table may be omitted. repeats: the last row
-- describes any number of further arguments. unchecked: the function checks its arguments itself. head: the first line,
-- if it cannot be made from the rows. more: text after the rows. example: code or a list of it. returns: the type of
-- the result, or a list of the types of several results, if any; a function that returns a table of its own may have
-- fields instead, their rows. The page of a type, such as "run", has fields: rows of the fields of its objects,
-- and arguments and returns if these can be called. as_given: the function receives the table as it was given, checked,
-- without defaults. rows: rows that other pages use by the page's name. entries = { noun, type, text }: entries of the
-- table of named arguments without a name. A row is { key, type, text, default = …, otherwise = "the default in words",
-- optional = true, unit = …, derived = function(values) }: without one of the first three the argument is required;
-- `derived` returns a default that depends on the values of the rows before. needs, excludes: keys of which one must,
-- or none may, be given with it, { "patch", why = "it is for models" }. hidden: help and Tab do not show the row. A row
-- that is a string is a heading. A list of rows may have conflict = function(values, given), which returns nil, or a
-- sentence if the values contradict each other.

local core = require "signorini.core"
local describe = require "signorini.call.describe"
local lists = require "signorini.call.lists"
local filter, map = lists.filter, lists.map

-- A script may change them before a page is loaded.
local open, searchpath, standard_path = io.open, package.searchpath, package.path

local pages = {}

--- The subjects in the order of the reference, each a file below pages/ that returns { title = …, word = … (for
--- help), also = … (another word), page, … }; one with the title of the previous one continues it.
pages.subjects = { "patches", "curves", "patch", "materials", "bodies", "formulas", "scene", "solving", "results",
                   "methods", "scenes", "pictures", "charts", "studies", "gradients", "inverse", "reports",
                   "scripts" }

local loaded, texts = {}, {} -- lists of pages, and texts of the files that are not loaded yet, by subject
local found = {} -- pages by name, as far as they have been looked for
local all, groups -- all pages by name; lists { title, word, page, … } in order

--- The pages of a subject, in order and by name.
local function load_subject(subject)
  if loaded[subject] then return loaded[subject] end
  local list = require("signorini.pages." .. subject)
  local by_name = {}
  for _, page in ipairs(list) do
    page.name, page.text = page[1], page[2]
    if not page.head and not page.name:find "[.:]" then page.head = page.name end
    by_name[page.name] = page
  end
  loaded[subject], texts[subject] = { list = list, by_name = by_name }, nil
  return loaded[subject]
end

local function load_all()
  all, groups = {}, {}
  for _, subject in ipairs(pages.subjects) do
    local list = load_subject(subject).list
    local group = groups[#groups]
    if not group or group.title ~= list.title then
      group = { title = list.title, word = list.word, also = list.also }
      groups[#groups + 1] = group
    end
    for _, page in ipairs(list) do all[page.name], group[#group + 1] = page, page end
  end
end

--- True if a subject may have a page: its file, which takes longer to compile than to search, contains the name.
local function may_have(subject, name)
  if not texts[subject] then
    local path = searchpath("signorini.pages." .. subject, standard_path)
    local file <close> = path and open(path)
    if not file then return true end -- require says why
    texts[subject] = file:read "a"
  end
  return texts[subject]:find(('"%s"'):format(name), 1, true)
end

--- Lists of pages by subject in order: { title = …, word = … (for help), page, … }.
function pages.groups()
  if not all then load_all() end
  return groups
end

--- The page of a name, or nil. Checks of calls need few pages: only the files that have the name are loaded.
function pages.find(name)
  if all then return all[name] end
  if found[name] then return found[name] end
  for _, subject in ipairs(pages.subjects) do
    if loaded[subject] or may_have(subject, name) then
      found[name] = load_subject(subject).by_name[name]
      if found[name] then return found[name] end
    end
  end
  load_all() -- a name that no file has as it is
  return all[name]
end

--- The rows themselves, or those of the page with this name.
function pages.rows(rows)
  if type(rows) ~= "string" then return rows end
  local page = pages.find(rows)
  return page.rows or pages.rows(page.named or page.arguments)
end

--- The kind of a value: "patch", "run", otherwise its Lua type.
function pages.kind(value)
  local own = type(value) == "table" and getmetatable(value)
  return type(own) == "table" and rawget(own, "__name") or core.kind(value)
end

--- What help shows of the page of a name, or nil.
function pages.text(name)
  local page = pages.find(name)
  return page and require("signorini.prompt.help.page_text").whole(page)
end

--- The names of all pages, sorted.
function pages.names()
  pages.groups()
  return lists.sorted_names(all)
end

--- The row of a key, or nil.
function pages.row(rows, key)
  return filter(pages.rows(rows), function(row) return type(row) == "table" and row[1] == key end)[1]
end

--- The keys of rows in their order, except hidden ones.
function pages.keys(rows)
  local shown = filter(pages.rows(rows), function(row) return type(row) == "table" and not row.hidden end)
  return map(shown, function(row) return row[1] end)
end

--- Rows in one line, "a, b = 1".
local function listed(rows)
  local shown = filter(rows, function(row) return type(row) == "table" end)
  return table.concat(map(shown, function(row)
    return row.default ~= nil and ("%s = %s"):format(row[1], describe.literal(row.default))
      or row[2].last and ("{ %s }"):format(listed(pages.rows(row[2].rows))) or row[1]
  end), ", ")
end

local function call(page, inside)
  if page.named then return ("%s{ %s }"):format(page.name, inside) end
  return ("%s(%s)"):format(page.name, inside)
end

--- The rows of a page as help shows them: those without a name come first, as <curves>.
function pages.shown(page)
  local rows = lists.joined(pages.rows(page.named or page.arguments or {}), page.fields or {})
  if not page.entries then return rows end
  local noun, of, text = table.unpack(page.entries)
  return lists.joined({ { ("<%s>"):format(noun), of, text } }, rows)
end

--- The types of a function's results.
function pages.results(page)
  if page.returns then return page.returns.kind and { page.returns } or page.returns end
  return page.fields and { { kind = "named", rows = page.fields, is_result = true } } or {}
end

--- The name of the page of a type, by the name of its objects in messages: "map" of a convergence map.
function pages.of_objects(name)
  for key, methods in pairs(core.types) do
    if key == name or rawget(methods, "__name") == name then return key end
  end
end

--- True if the argument of a row must be given.
function pages.is_needed(row) return row.default == nil and not (row.otherwise or row.optional) end

--- How a function is called, "sg.f{ a, b = 1 }".
function pages.head(page)
  if page.head then return page.head end
  if type(page.named) == "string" then return page.name .. "{ … }" end
  return call(page, page.fields and "" or listed(pages.shown(page)))
end

--- How a function is called, in at most so many characters; the last arguments are left out.
function pages.short_head(page, most)
  local head = pages.head(page):match "^[^\n]*"
  if utf8.len(head) <= most then return head end
  local keys = pages.keys(page.named or page.arguments or {})
  for count = #keys, 1, -1 do
    local short = call(page, table.concat(keys, ", ", 1, count) .. (count < #keys and ", …" or ""))
    if utf8.len(short) <= most then return short end
  end
  return call(page, "…")
end

--- The first sentence of a page.
function pages.summary(page)
  local text = page.text:gsub("\n", " ")
  return text:match "^(.-)%.%f[%s\0]" or text
end

return pages
