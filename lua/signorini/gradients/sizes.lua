-- Sizes of results, next to which differences of runs are rounding errors.

local core = require "signorini.core"

local sizes = {}

-- Error of the results of runs, relative to the largest of their kind.
sizes.uncertain = 1e-9

--- "f" of forces, "max_pressure" …
function sizes.kind_of(name) return (name:match "[^.]*$":gsub("^f[xyz]$", "f")) end

--- The largest values of a run, by kinds of results; those of forces are at least rounding errors.
function sizes.largest(run, names, model)
  local most = { f = core.rounding(model) / sizes.uncertain }
  for _, name in ipairs(names) do
    local kind = sizes.kind_of(name)
    for _, value in ipairs(run:column(name)) do most[kind] = math.max(most[kind] or 0, math.abs(value)) end
  end
  return most
end

return sizes
