-- The scenes of sg.gradients, sg.check_gradients: what a function of parameters returns, at several values of these.

local check = require "signorini.call.check"
local core = require "signorini.core"
local lists = require "signorini.call.lists"
local named = require "signorini.call.named"
local stages = require "signorini.run.stages"

local scene = {}

-- Distance of the neighbors from the run, relative to the parameter or its scale: rounding errors of 1e-13 leave 3e-9
-- of the derivative, and its third derivative 1e-9.
scene.step = 3e-5

-- Least scale of a parameter, relative to its value, at which 4 digits of a derivative remain.
local least_scale = 1e-4

-- Options of model:run under which models cannot follow a run; and those of a single run, not of a series of them.
local alone, single = { "arc_length", "errors", "tolerance" }, { "checkpoint", "resume" }

--- Parameters as a list of { name, at, size }, sorted by name, without those with an entry in `constant`; `size`: the
--- parameter's own size, or its scale.
function scene.parameters(where, at, scale, constant)
  for name in pairs(scale or {}) do
    if at[name] == nil then core.fail(("%s: scale.%s: there is no parameter of this name"):format(where, name)) end
  end
  if not next(at) then core.fail(where .. ": at is empty. Hint: name at least one parameter, at = { E = 1 }") end
  local names = lists.filter(lists.sorted_names(at), function(name) return not (constant or {})[name] end)
  return lists.map(names, function(name)
    local size = (scale or {})[name] or math.abs(at[name])
    if size < least_scale * math.abs(at[name]) then
      core.fail(("%s: scale.%s = %g is too small next to the value %g: rounding errors of its results would count. "
        .. "Hint: measure it from a nearby origin"):format(where, name, size, at[name]))
    end
    if size == 0 then
      core.fail(("%s: at.%s is 0, which has no size of its own. Hint: scale = { %s = 0.1 }, with a typical value")
        :format(where, name, name))
    end
    return { name = name, at = at[name], size = size }
  end)
end

--- "E = 1.00003".
function scene.place(name, value) return ("%s = %.10g"):format(name, value) end

--- The argument of a scene: its parameters, of which it notes in `reads` those that are read.
local function argument(values, reads)
  return setmetatable({}, {
    __index = function(_, name)
      if values[name] == nil then named.missing("the argument of scene", name, lists.sorted_names(values)) end
      reads[name] = true
      return values[name]
    end,
    __pairs = function()
      for name in pairs(values) do reads[name] = true end
      return next, values
    end })
end

--- The scene at values of parameters, { model, list (stages), options, path (stages that have been read) }. `changed`:
--- the name of the parameter that differs from those of the run, for messages.
function scene.make(where, make, values, changed)
  local place = changed and (" at " .. scene.place(changed, values[changed])) or ""
  local reads = {}
  local model, list, options = make(argument(values, reads))
  if core.kind(model) ~= "model" or type(list) ~= "table" then
    core.fail(("%s: scene%s must return a model and its stages, got %s and %s"):format(where, place,
      core.describe(model), core.describe(list)))
  end
  for _, name in ipairs(lists.sorted_names(values)) do
    if not reads[name] then core.fail(("%s: scene%s does not read the parameter '%s'"):format(where, place, name)) end
  end
  list, options = check.call("model:run", model, list, options)
  for _, key in ipairs(where == "sg.gradients" and alone or lists.joined(alone, single)) do
    if options[key] and (type(options[key]) ~= "table" or next(options[key])) then
      core.fail(("%s: scene%s returns the option %s, %s. Hint: leave it out"):format(where, place, key,
        lists.holds(alone, key) and "with which models cannot follow a run" or "which is that of a single run"))
    end
  end
  return { model = model, list = list, options = options, path = (stages.read(model, list, lists.merged(options))) }
end

--- True if two tables have equal numbers and texts; functions are not compared.
local function same(a, b)
  if type(a) ~= "table" or type(b) ~= "table" then return a == b or type(a) == "function" and type(b) == "function" end
  for key, value in pairs(a) do
    if not same(value, b[key]) then return false end
  end
  return true
end

--- Checks that a function makes the scene `made` once more for the same values, so that differences come from these.
function scene.check_repeats(where, make, values, made)
  local again = scene.make(where, make, values)
  local wrong = core.content(again.model) ~= core.content(made.model) and "model"
    or not same(again.list, made.list) and "path" or nil
  if wrong then
    core.fail(("%s: scene returns another %s when it is called again with the same values. Hint: it must depend on its "
      .. "argument alone, not on random numbers, clocks or variables that it changes"):format(where, wrong))
  end
end

--- Checks that a scene has the unknowns, the stages and the steps of another one.
function scene.compare(where, run, other, name, value)
  local function fail(text) core.fail(("%s: scene at %s: %s"):format(where, scene.place(name, value), text)) end
  if other.model == run.model then fail "it returns the model of another call. Hint: make a new one in each call" end
  local text = core.neighbor_difference(run.model, other.model)
  if text then fail(text) end
  if #run.path ~= #other.path then fail "it has another number of stages, which a parameter must not change" end
  for i, stage in ipairs(run.path) do
    if other.path[i].steps ~= stage.steps then
      fail(("stage '%s' has another number of steps, which a parameter must not change"):format(stage.name))
    end
  end
end

return scene
