-- Solves one case of a problem and measures its cost.

local sg = require "signorini"
local settings = require "studies.accuracy.settings"

--- The results of a case { order, mesh, setting, and, if not those of the setting, coarser, plain } of a scene:
--- scene(options) returns a model, its path, a function of the run that returns results, and options of model:run.
--- cpu: processor time in s of scene and path.
return function(scene, case)
  local o, began = settings.of(case), os.clock()
  local model, path, measure, options = scene(o)
  local run = model:run(path, (o.plain and sg.plain or sg.robust)(options))
  local results = run.failed and { failed = true, reason = run.failure } or measure(run)
  results.cpu, results.iterations = os.clock() - began, run.iterations
  results.unknowns = model:cost().unknowns
  results.work = results.iterations * results.unknowns
  return results
end
