-- Runs of tests: those that have reached their end, and the last values of their columns.

local runs = {}

--- The run; raises an error if it has failed.
function runs.completed(run)
  if run.failed then error(run.failure, 2) end
  return run
end

function runs.last(run, name)
  local column = run:column(name)
  return column[#column]
end

return runs
