-- Progress of a long run, on stderr: a bar that is redrawn on a terminal, one line per finished stage elsewhere,
-- nothing when the program runs quietly (-q). Front ends that replace texts show both (core.replace_text).

local core = require "signorini.core"
local counted = require("signorini.call.text").counted

local Progress = {}
Progress.__index = Progress

local bar_width = 30
local redraw_after = 0.1 -- seconds

local function seconds_text(seconds)
  if seconds < 60 then return ("%.1f s"):format(seconds) end
  if not (seconds < 1e9) then return "years" end -- too large for a whole number, or infinite
  local whole = math.floor(seconds)
  return ("%d:%02d min"):format(whole // 60, whole % 60)
end

--- A progress display over `total` steps. `lines`: without the bar, because other output comes in between.
local function start(total, lines)
  local now, terminal = core.now(), core.terminal and not lines
  local display = { total = total, done = 0, began = now, drawn = now, terminal = terminal }
  if core.replace_text then return require "signorini.prompt.kernel.progress"(display, Progress) end
  return setmetatable(display, Progress)
end

--- The text of a bar.
function Progress.bar_text(name, part, text)
  local filled = math.floor(bar_width * part)
  return ("%s [%s%s] %s"):format(name, ("#"):rep(filled), ("."):rep(bar_width - filled), text)
end

function Progress:clear()
  if self.visible then io.stderr:write "\r\27[K" end
  self.visible = false
end

--- Redraws the bar, unless that was done just now: name, fraction that is done (0 to 1), and further text.
function Progress:draw(name, part, text)
  if core.quiet or not self.terminal then return end
  local now = core.now()
  if now - self.drawn < redraw_after then return end
  self.drawn, self.visible = now, true
  io.stderr:write("\r\27[K", self.bar_text(name, part, text))
  io.stderr:flush()
end

--- The remaining time when this fraction (0 to 1) of the work is done, in words.
function Progress:to_go(part)
  return part > 0 and seconds_text((core.now() - self.began) * (1 / part - 1)) .. " left" or "time left unknown"
end

--- Counts one more step.
function Progress:step(stage)
  self.done = self.done + 1
  local part = self.done / self.total
  self:draw(stage, part, ("%d/%d, %s"):format(self.done, self.total, self:to_go(part)))
end

--- Shows how far a step is after an attempt at it. `part`: the fraction that is accepted; `histories`: the attempts of
--- all steps.
function Progress:attempt(stage, part, histories)
  local attempts, whole = #histories[#histories], (self.done + part) / self.total
  self:draw(stage, whole, ("%d/%d, next step at %.0f %%, %s, %s"):format(self.done, self.total, 100 * part,
    counted(attempts, "attempt"), self:to_go(whole)))
end

--- A line that remains, in place of the bar.
function Progress:line(text)
  if core.quiet then return end
  self:clear()
  io.stderr:write(text, "\n")
end

--- A stage has ended; on a terminal the bar shows it.
function Progress:stage_end(stage, steps, iterations, wall)
  if self.terminal then return end
  self:line(("%s: %s, %s, %s"):format(stage, counted(steps, "step"), counted(iterations, "iteration"),
    seconds_text(wall)))
end

return start
