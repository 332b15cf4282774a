-- What verbose = true prints: a title for each attempt at a step, a header, and a line per Newton iteration.

local verbose = {}

local head = "iteration   residual   relative   |f·Δu|"
local contact_head = "   active  slip  changed"
local outcomes = { iterating = "", converged = "converged" } -- other reasons: "ends: <reason>"

--- Each line is visible at once, also in a pipe.
local function say(text)
  print(text)
  io.stdout:flush()
end

--- A number in scientific notation, or blanks.
local function scientific(value, digits)
  return value and ("%10." .. digits .. "e"):format(value) or (" "):rep(10)
end

--- The right column: the linear solver and what else happened.
local function remarks(now)
  local parts = {}
  local function add(form, value)
    if value then parts[#parts + 1] = form:format(value) end
  end
  add(now.factored and "%s, factored" or "%s", now.linear)
  add("%d GMRES", now.gmres)
  add("factor %.3g", now.part)
  add("pseudo-time damping %.2g", now.damping)
  local outcome = outcomes[now.reason] or "ends: " .. now.reason
  if outcome ~= "" then parts[#parts + 1] = outcome end
  return table.concat(parts, ", ")
end

--- Prints an iteration, as src/bind/model/iteration_report.cpp describes it; before the first one of a step the header.
--- `relative` is the residual in units in which newton.tolerance is the limit.
function verbose.iteration(now)
  if now.first then say(head .. (now.contact and contact_head or "")) end
  local relative = now.residual and now.tolerance > 0 and now.residual / now.tolerance * now.goal or nil
  local line = ("%9d %s %s %s"):format(now.iteration, scientific(now.residual, 3), scientific(relative, 2),
    scientific(now.energy, 2))
  if now.contact then line = ("%s  %7d %5d  %7d"):format(line, now.active, now.slipping, now.changed) end
  say(("%s   %s"):format(line, remarks(now)):match "^(.-)%s*$")
end

--- "press, step 3 of 46": where a step of model:run is.
local function place(step) return ("%s, step %d of %d"):format(step.stage.name, step.number, step.stage.steps) end

--- Prints the title of an attempt at a step up to a fraction of it.
function verbose.attempt(step, to, fallback)
  local whole = step.done == 0 and to == 1
  local targets = step:place(to)
  say(("%s%s%s%s"):format(place(step), whole and "" or (", from %.4g to %.4g"):format(step.done, to),
    fallback and (", fallback: %s"):format(fallback) or "", targets == "" and "" or ": " .. targets))
end

--- Prints where layers have followed the contact (adapt.lua).
function verbose.adaptation(now)
  local names = {}
  for name in pairs(now.elements) do names[#names + 1] = name end
  table.sort(names)
  for i, name in ipairs(names) do names[i] = ("%d elements of %s"):format(now.elements[name], name) end
  say(("after step %d the layer is in %s: %d unknowns"):format(now.step, table.concat(names, ", "), now.unknowns))
end

--- Prints the title of an arc-length increment. `follows`: of the path, otherwise of the search for a turning point.
function verbose.arc(step, length, follows)
  say(("%s, from %.4g, %sarc length %.4g"):format(place(step), step.done,
    follows and "" or "search for a turning point: ", length))
end

--- Prints the title of a solve for targets in the search for a turning point.
function verbose.probe(step, to)
  say(("%s, search for a turning point: to %.4g"):format(place(step), to))
end

return verbose
