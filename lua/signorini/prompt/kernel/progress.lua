-- Progress in a notebook: finished stages and a bar, as one text that is replaced.

local core = require "signorini.core"
local lists = require "signorini.call.lists"

local redraw_after = 0.5 -- seconds

local count = 0

--- A progress display with the methods of those on stderr (signorini.progress) that do not write.
return function(display, methods)
  count = count + 1
  local name, lines, bar, shown = ("progress %d"):format(count), {}, nil, ""

  local function show()
    local text = table.concat(lists.joined(lines, { bar }), "\n")
    if core.quiet or text == shown then return end
    display.drawn, shown = core.now(), text
    core.replace_text(name, text)
  end

  function display:draw(what, part, text)
    bar = self.bar_text(what, part, text)
    if core.now() - self.drawn >= redraw_after then show() end
  end

  function display:line(text)
    lines[#lines + 1], bar = text, nil
    show()
  end

  --- The last state remains.
  function display:clear() show() end

  return setmetatable(display, { __index = methods })
end
