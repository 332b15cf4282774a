-- One run of a search, with derivatives. What fails at values that the search tries is a reason to go less far; what
-- fails at the start is an error.

local core = require "signorini.core"
local gradients = require "signorini.gradients.gradients"
local parameters = require "signorini.inverse.parameters"
local run_path = require "signorini.run.run"
local scene = require "signorini.gradients.scene"
local without_warnings = require "signorini.call.without_warnings"

local trial = {}

--- pcall(f, …) without warnings and progress, which the search shows itself.
local function quietly(f, ...)
  local quiet = core.quiet
  core.quiet = true
  local done, result = pcall(without_warnings, f, ...)
  core.quiet = quiet
  return done, result
end

--- True for the error by which Ctrl-C or the end of --time ends a script, not for one that has the word in its text.
local function is_interruption(message)
  local text = core.interruption()
  return tostring(message):sub(-#text) == text
end

--- A text in one line without the position in the script.
local function short(text) return (tostring(text):match "^[^\n]*":gsub("^[^%s]+:%d+: ", "")) end

--- The gradients of the scene of a search at values; or nil, and why there are none: "interrupted", or a text.
function trial.solve(search, values)
  local done, found = quietly(gradients.of, search.caller, { scene = search.scene, at = values,
    scale = parameters.scale(search.free), measure = search.measure, constant = search.fixed, from_start = true,
    is_known = search.is_known })
  if not done then return nil, is_interruption(found) and "interrupted" or short(found), found end
  local run = found.run
  if run.reason == "interrupted" then return nil, "interrupted" end
  if run.failed then return nil, ("the run fails: %s"):format(short(run.failure)) end
  return found
end

--- The gradients at the start; what fails there is an error.
function trial.begin(search, values)
  local found, why, message = trial.solve(search, values)
  search.is_known = true
  if found then return found end
  if why == "interrupted" then core.fail(core.interruption()) end
  if message then error(message, 0) end
  core.fail(("%s: at the start, %s"):format(search.caller, why))
end

--- A run of the scene at values without derivatives, with further options; nil if it fails, with "interrupted" if
--- Ctrl-C has ended it.
function trial.run(search, values, options)
  local done, run = quietly(function()
    local made = scene.make(search.caller, search.scene, values)
    for key, value in pairs(options or {}) do made.options[key] = value end
    made.options.measure = search.measure or made.options.measure
    return run_path(made.model, made.list, made.options)
  end)
  if done and run.reason == "interrupted" or not done and is_interruption(run) then return nil, "interrupted" end
  return done and not run.failed and run or nil
end

return trial
