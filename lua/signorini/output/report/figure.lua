-- Figures of a report: charts as SVG with their values, pictures and films as data within the page.

local core = require "signorini.core"
local describe = require "signorini.call.describe"
local html = require "signorini.output.report.html"
local lists = require "signorini.call.lists"
local on_behalf_of = require "signorini.call.on_behalf_of"

local figure = {}

local chart_size = { 600, 600 }   -- pixels: legible on a phone; charts and heat maps keep their ratio of sides
local picture_size = { 1600, 1600 }
local near = 2.5                  -- pixels of a chart: points that are not distinguished
local most_film = 32              -- MB of a film

local image_kinds = { png = "image/png", jpg = "image/jpeg", jpeg = "image/jpeg", gif = "image/gif",
                      webp = "image/webp", svg = "image/svg+xml" }
local film_kinds = { mp4 = "video/mp4", ogv = "video/ogg", webm = "video/webm" }

-- ── Charts ───────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A spot in words, one line per quantity.
local function spot_text(spot)
  return table.concat(lists.map(spot.values, function(pair)
    local name, value = html.plain(pair[1]), html.plain(pair[2])
    return name ~= "" and ("%s: %s"):format(name, value) or value
  end), "\n")
end

--- The spots without those that cover the one before, so that long curves need few.
local function apart(spots)
  local last
  return lists.filter(spots, function(spot)
    local covers = last and spot.width == 0 and math.abs(spot.x - last.x) < near and math.abs(spot.y - last.y) < near
      and spot.values[1][2] == last.values[1][2]
    if not covers then last = spot end
    return not covers
  end)
end

--- Transparent marks with the values of a chart, for its SVG.
local function marks_of(spots)
  local marks = lists.map(apart(spots), function(spot)
    local title = html.element("title", spot_text(spot))
    if spot.width == 0 then return ('<circle cx="%.1f" cy="%.1f" r="6">%s</circle>'):format(spot.x, spot.y, title) end
    return ('<rect x="%.1f" y="%.1f" width="%.1f" height="%.1f">%s</rect>'):format(spot.x - spot.width / 2,
      spot.y - spot.height / 2, spot.width, spot.height, title)
  end)
  return ('<g class="spots" fill="transparent">\n%s\n</g>\n'):format(table.concat(marks, "\n"))
end

--- An SVG document as an element of the page.
local function inline_svg(svg, prefix, label, marks)
  svg = svg:gsub("^.-(<svg)", "%1", 1):gsub("%s*$", "")
  svg = html.prefixed(svg, prefix):gsub("<[^>]->", function(tag)
    return (tag:gsub(' xmlns[:%w]*="[^"]*"', ""):gsub("xlink:href=", "href="))
  end)
  svg = svg:gsub('^<svg[^>]-viewBox="([^"]*)"[^>]*>', function(box)
    return ('<svg viewBox="%s" role="img" tabindex="0" aria-label="%s">'):format(box, html.escape(label))
  end)
  return (svg:gsub("</svg>$", function(ending) return marks .. ending end))
end

-- ── Figures ──────────────────────────────────────────────────────────────────────────────────────────────────────────

local function framed(class, content, caption)
  local below = caption and caption ~= "" and "\n" .. html.element("figcaption", html.plain(caption)) or ""
  return ('<figure class="%s">\n<div class="frame">%s</div>%s\n</figure>'):format(class, content, below)
end

--- The figure of a picture. `what`: its name in errors, such as "study:report: charts[1]", and in the ids of its parts.
function figure.of_picture(what, picture, caption)
  local spots = on_behalf_of(what, "core.picture_spots", core.picture_spots, picture, chart_size)
  local function bytes(format, most)
    return on_behalf_of(what, "core.picture_bytes", core.picture_bytes, picture, format, most)
  end
  local label = caption or tostring(picture)
  if spots then
    local svg, prefix = bytes("svg", chart_size), what:gsub("^[^ ]* ", ""):gsub("%W+", "-")
    return framed("chart", inline_svg(svg, prefix, html.plain(label), marks_of(spots)), caption)
  end
  local address = html.data("image/png", bytes("png", picture_size))
  return framed("picture", ('<img src="%s" alt="%s">'):format(address, html.escape(html.plain(label))), caption)
end

local function kind_of(what, file, kinds, noun)
  local kind = kinds[(file:match "%.(%w+)$" or ""):lower()]
  if kind then return kind end
  local endings = lists.map(lists.sorted_names(kinds), function(ending) return "." .. ending end)
  core.fail(("%s must be the name of a %s that ends with %s, got '%s'"):format(what, noun,
    describe.alternatives(endings), file))
end

local function read(what, file)
  if not core.exists(file) then
    core.fail(("%s: there is no file '%s'. Hint: names of files are relative to the working folder"):format(what, file))
  end
  local bytes = on_behalf_of(what, "core.read_file", core.read_file, file)
  if bytes == "" then core.fail(("%s: the file '%s' is empty"):format(what, file)) end
  return bytes
end

--- The figure of a file with a picture.
function figure.of_file(what, file, caption)
  local kind = kind_of(what, file, image_kinds, "picture")
  local address = html.data(kind, read(what, file))
  local name = caption or file:match "[^/]*$"
  return framed("picture", ('<img src="%s" alt="%s">'):format(address, html.escape(html.plain(name))), caption)
end

--- The figure of a file with a film.
function figure.of_film(what, file, caption)
  local kind = kind_of(what, file, film_kinds, "film")
  local bytes, name = read(what, file), caption or file:match "[^/]*$"
  if #bytes > most_film * 1e6 then
    core.fail(("%s: '%s' has %.0f MB, more than the %d MB that a page can hold. Hint: draw it with fewer or smaller "
      .. "pictures, or send it separately"):format(what, file, #bytes / 1e6, most_film))
  end
  local content = ('<video controls preload="metadata" src="%s" aria-label="%s">%s</video>'):format(
    html.data(kind, bytes), html.escape(name),
    html.escape(("This browser cannot show the film %s."):format(file:match "[^/]*$")))
  return framed("film", content, caption)
end

return figure
