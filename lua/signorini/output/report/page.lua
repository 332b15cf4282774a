-- The page of a report: one HTML file that needs no other file, and no network.

local check = require "signorini.call.check"
local core = require "signorini.core"
local figure = require "signorini.output.report.figure"
local html = require "signorini.output.report.html"
local lists = require "signorini.call.lists"
local on_behalf_of = require "signorini.call.on_behalf_of"
local origin = require "signorini.output.report.origin"

local page = {}

--- The words of an id or of a file name.
local function slug(title) return (title:lower():gsub("[^%w]+", "-"):gsub("^-", ""):gsub("-$", "")) end

-- ── Figures of the user ──────────────────────────────────────────────────────────────────────────────────────────────

--- The figures of the arguments `pictures` and `films`, as sections. Checks the name of the page's file, too.
function page.given_figures(where, options)
  local pictures = lists.map(options.pictures or {}, function(entry, i)
    local what = ("%s: pictures[%d]"):format(where, i)
    if type(entry.picture) == "string" then return figure.of_file(what, entry.picture, entry.caption) end
    return figure.of_picture(what, entry.picture, entry.caption)
  end)
  local films = lists.map(options.films or {}, function(entry, i)
    return figure.of_film(("%s: films[%d]"):format(where, i), entry.film, entry.caption)
  end)
  if not options.file:find "[^/]%.html?$" then
    check.reject(where, "file", "the name of a file that ends with .html", options.file)
  end
  return { title = "Pictures", figures = pictures }, { title = "Films", figures = films }
end

-- ── The page ─────────────────────────────────────────────────────────────────────────────────────────────────────────

local function asset(name) return core.read_file(("%s/report/%s"):format(core.share, name)) end

local function section_text(section)
  local figures = section.figures and #section.figures > 0
    and ('<div class="figures">\n%s\n</div>'):format(table.concat(section.figures, "\n")) or nil
  local parts = lists.filter({ section.html or "", figures or "" }, function(part) return part ~= "" end)
  if #parts == 0 then return nil end
  return ('<section id="%s">\n%s\n%s\n</section>'):format(slug(section.title), html.element("h2", section.title),
    table.concat(parts, "\n"))
end

--- The whole page of { title, subtitle, text, summary (facts), sections, records }.
local function whole(content)
  local sections, links = {}, {}
  for _, section in ipairs(lists.joined(content.sections, {
    { title = "What was asked", html = (content.asked or "") .. origin.script() },
    { title = "Program, machine and time", html = html.facts(origin.facts(content.records)) },
  })) do
    local text = section_text(section)
    if text then
      sections[#sections + 1] = text
      links[#links + 1] = ('<a href="#%s">%s</a>'):format(slug(section.title), html.escape(section.title))
    end
  end
  local parts = {
    "<!DOCTYPE html>", '<html lang="en">', "<head>", '<meta charset="utf-8">',
    '<meta name="viewport" content="width=device-width, initial-scale=1">',
    '<meta name="color-scheme" content="light dark">', '<link rel="icon" href="data:,">',
    html.element("title", content.title), "<style>", asset "report.css", "</style>", "</head>", "<body>",
    "<header>", html.element("h1", content.title), html.element("p", content.subtitle, "subtitle"),
    html.facts(content.summary), ('<nav aria-label="Contents">%s</nav>'):format(table.concat(links, "\n")), "</header>",
    "<main>", content.text and html.paragraphs(content.text) or "", table.concat(sections, "\n"), "</main>",
    "<script>", asset "report.js", "</script>", "</body>", "</html>", "",
  }
  return table.concat(parts, "\n")
end

--- Writes the page to a file, whole or not at all. The options of the report are file, title and text.
function page.write(where, options, content)
  content.title, content.text = options.title or content.title, options.text
  on_behalf_of(where, "core.write_output", core.write_output, options.file, whole(content), "html")
end

return page
