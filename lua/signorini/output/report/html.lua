-- Texts of users in HTML: escaped, and valid UTF-8; pictures of a page.

local core = require "signorini.core"

local html = {}

local entities = { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;", ['"'] = "&quot;", ["'"] = "&#39;" }

--- The text with U+FFFD in place of each byte that is not valid UTF-8.
local function valid(text)
  local count, wrong = utf8.len(text)
  if count then return text end
  local parts, from = {}, 1
  while wrong do
    parts[#parts + 1], from = text:sub(from, wrong - 1), wrong + 1
    count, wrong = utf8.len(text, from)
  end
  parts[#parts + 1] = text:sub(from)
  return table.concat(parts, "\u{FFFD}")
end

--- A text as content of an element or of an attribute in double quotes. Control characters, which HTML does not allow,
--- are replaced like invalid bytes.
function html.escape(text)
  local plain = valid(tostring(text)):gsub("\r\n?", "\n"):gsub("[\0-\8\11-\31\127]", "\u{FFFD}")
  return (plain:gsub("[&<>\"']", entities))
end

--- The label of a chart without its markup for subscripts and superscripts.
function html.plain(label) return (label:gsub("([_^]){(.-)}", "%1%2"):gsub("\\([_^{}\\])", "%1")) end

--- An element with a text.
function html.element(name, text, class)
  return ("<%s%s>%s</%s>"):format(name, class and (' class="%s"'):format(class) or "", html.escape(text), name)
end

--- Paragraphs of a text, which empty lines separate.
function html.paragraphs(text)
  local parts = {}
  for part in (text:gsub("\r\n?", "\n") .. "\n\n"):gmatch "(.-)\n%s*\n" do
    if part:find "%S" then parts[#parts + 1] = html.element("p", part, "lines") end
  end
  return table.concat(parts, "\n")
end

--- A list of texts.
function html.list(texts)
  local items = {}
  for i, text in ipairs(texts) do items[i] = html.element("li", text, "lines") end
  return ("<ul>\n%s\n</ul>"):format(table.concat(items, "\n"))
end

--- A list of { name, value } as names and values side by side.
function html.facts(facts)
  local items = {}
  for i, fact in ipairs(facts) do
    items[i] = ("<div>%s%s</div>"):format(html.element("dt", fact[1]), html.element("dd", fact[2]))
  end
  return ('<dl class="facts">\n%s\n</dl>'):format(table.concat(items, "\n"))
end

--- A text of a program, folded.
function html.listing(title, text, open)
  return ("<details%s>\n<summary>%s</summary>\n<pre><code>%s</code></pre>\n</details>"):format(open and " open" or "",
    html.escape(title), html.escape(text))
end

--- Bytes as the address of a resource within the page.
function html.data(kind, bytes) return ("data:%s;base64,%s"):format(kind, core.base64(bytes)) end

--- An SVG document whose names (of clip paths, glyphs, images) have a prefix: those of several pictures in one page
--- would otherwise be equal. Texts are left as they are.
function html.prefixed(svg, prefix)
  return (svg:gsub("<[^>]->", function(tag)
    return (tag:gsub('( id=")', "%1" .. prefix):gsub('(href="#)', "%1" .. prefix):gsub("(url%(#)", "%1" .. prefix))
  end))
end

--- Seconds in the unit that readers expect.
function html.duration(seconds)
  if seconds < 60 then return ("%.3g s"):format(seconds) end
  if seconds < 3600 then return ("%d min %02d s"):format(seconds // 60, math.floor(seconds % 60)) end
  return ("%d h %02d min"):format(seconds // 3600, math.floor(seconds % 3600 / 60))
end

return html
