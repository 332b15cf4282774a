-- Cells of a notebook (called by src/repl/kernel.cpp): their values, completion, and help in the front end.

local core = require "signorini.core"
local prompt = require "signorini.prompt.prompt"
local show = require "signorini.prompt.show"

local kernel = {}

--- The pixels of a picture per CSS pixel, for screens with a high resolution, and its largest width in CSS pixels: the
--- classic notebook shrinks no SVG to the available width.
local resolution, widest = 2, 720

-- ── Values ───────────────────────────────────────────────────────────────────────────────────────────────────────────

local function formats(value)
  return { ["text/plain"] = show.text(value), ["text/html"] = require "signorini.prompt.kernel.html"(value) }
end

--- Shows the pictures of a cell's values, the first of which is then `_`, unless it is nil; returns the formats of the
--- other ones, if there are any.
function kernel.results(...)
  if select("#", ...) == 1 and ... == core.sg.help then return core.sg.help() end
  if ... == io.stdout then return end -- the value of io.write
  prompt.keep(...)
  local others = {}
  for i = 1, select("#", ...) do
    local value = select(i, ...)
    if core.kind(value) == "picture" then
      require "signorini.prompt.display".show(value)
    else
      others[#others + 1] = formats(value)
    end
  end
  if #others < 2 then return others[1] end
  for i, other in ipairs(others) do others[i] = other["text/plain"] end
  return { ["text/plain"] = table.concat(others, "\n") }
end

--- The formats of a value that does not become `_`.
function kernel.value(...) return formats((...)) end

--- An SVG of this size, with names of its own.
local pictures = 0
local function scaled_svg(bytes, width, height)
  pictures = pictures + 1
  bytes = require("signorini.output.report.html").prefixed(bytes, ("picture%d-"):format(pictures))
  local size = ('width="%d" height="%d"'):format(width, height)
  return (bytes:match "<svg.*":gsub('width="%d+px" height="%d+px"', size, 1)) -- converters refuse <?xml … encoding?>
end

--- Shows a picture in the front end; charts and heat maps also as SVG.
local function show_picture(picture)
  local png = core.picture_bytes(picture, "png")
  local width, height = string.unpack(">I4I4", png, 17)
  local factor = math.min(1 / resolution, widest / width)
  width, height = math.floor(factor * width + 0.5), math.floor(factor * height + 0.5)
  local text = tostring(picture)
  local is_flat = text:find "^chart" or text:find "^heat map"
  core.front_end.show { ["image/png"] = png, ["text/plain"] = text, width = width, height = height,
    ["image/svg+xml"] = is_flat and scaled_svg(core.picture_bytes(picture, "svg"), width, height) or nil }
end

-- ── Requests while typing ────────────────────────────────────────────────────────────────────────────────────────────

--- The code before and behind a position, which counts characters; without one, a negative number, all is before it.
local function parted(code, cursor)
  local at = cursor >= 0 and utf8.offset(code, cursor + 1) or #code + 1
  return code:sub(1, at - 1), code:sub(at)
end

--- The characters that end a word, as in src/repl/line_editor.cpp.
local breaks = "[ \t\n\"'`@$><=;|&{}()%[%],+%-*^%%#~]"

--- The completions of the word before the cursor, and the positions of its begin and end.
function kernel.complete(code, cursor)
  local before = parted(code, cursor)
  local word_begin = #before + 1
  local is_open = require "signorini.prompt.complete.place".is_open(before)
  while word_begin > 1 and not before:sub(word_begin - 1, word_begin - 1):find(is_open and "[\"']" or breaks) do
    word_begin = word_begin - 1
  end
  local word = before:sub(word_begin)
  local found = require "signorini.prompt.complete"(word, before:sub(1, word_begin - 1))
  local word_end = utf8.len(before)
  return found, word_end - utf8.len(word), word_end
end

--- The help page of the name at the cursor, otherwise of the function in whose arguments it is.
function kernel.inspect(code, cursor)
  local before, behind = parted(code, cursor)
  local path = before:match "[%w_.:]*$" .. behind:match "^[%w_]*"
  local call = require "signorini.prompt.complete.place".of(before)
  local page = require "signorini.prompt.kernel.page"
  return path ~= "" and page(path) or call and page(call.path) or nil
end

--- The indentation of the line after an unfinished one.
function kernel.indent(code)
  local last = code:match "([^\n]*)%s*$":gsub("%-%-.*$", "")
  local indent = last:match "^[ \t]*"
  local word = last:match "(%w+)%s*$"
  local opens = last:find "[%({]%s*$" or last:find "function[%w_.:%s]*%b()%s*$" or word == "do" or word == "then"
    or word == "else" or word == "repeat"
  return opens and indent .. "  " or indent
end

-- ── The session ──────────────────────────────────────────────────────────────────────────────────────────────────────

local function refuse_exit()
  core.fail "os.exit is not available in a notebook. Hint: shut down or restart the kernel in the menu of the front end"
end

--- io.read in a notebook: a line that the front end asks for, as text ("l", "L") or number ("n").
local function read(...)
  local values = {}
  for i, format in ipairs { select("#", ...) == 0 and "l" or ..., select(2, ...) } do
    local letter = tostring(format):gsub("^%*", ""):sub(1, 1)
    if not letter:find "^[lLn]$" then
      core.fail(("io.read: format must be \"l\", \"L\" or \"n\" in a notebook, got %s. Hint: io.open reads files")
        :format(core.describe(format)))
    end
    local line = core.front_end.read_line()
    values[i] = letter == "n" and (tonumber(line) or false) or letter == "L" and line .. "\n" or line
    if not values[i] then return nil end
  end
  return table.unpack(values)
end

--- Prepares the language for a notebook, before the first cell.
function kernel.open()
  core.terminal = false
  core.replace_text = core.front_end.replace
  require "signorini.prompt.display".screen = show_picture
  traceback = prompt.traceback
  io.read, os.exit = core.offered(read), core.offered(refuse_exit)
end

return kernel
