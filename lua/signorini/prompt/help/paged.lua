-- Shows a long text on a terminal by the pager of the user, $PAGER or less, as man and git do; elsewhere and in the
-- sandbox it is printed.

local core = require "signorini.core"

local screen = 20 -- lines that every terminal has

-- less ends at once if the text fits on the screen (-F), and leaves it there (-X).
local command = [[p=${PAGER:-less}; command -v "${p%% *}" >/dev/null 2>&1 || p=cat
export LESS="${LESS-FRX}"; exec $p]]

return function(text)
  local _, lines = text:gsub("\n", "")
  local started, pipe = core.interactive and lines >= screen, nil
  if started then started, pipe = pcall(io.popen, command, "w") end
  if not (started and pipe) then return print(text) end
  io.stdout:flush()
  pipe:write(text, "\n")
  pipe:close()
end
