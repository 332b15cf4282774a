-- Short cases, for tests/measure/slurm_overhead.

local sg = require "signorini"

local options = sg.arguments{ cases = 1000, chunk = "auto" }

local numbers = {}
for n = 1, options.cases do numbers[n] = n end
local study = sg.study{ name = "short", cases = sg.grid{ n = numbers }, run = function(case)
  return { square = case.n ^ 2 }
end }
study:execute{ at_most = 4, chunk = tonumber(options.chunk) or options.chunk, time = "30", memory = "100M" }

local sum = 0
for _, row in ipairs(study.rows) do sum = sum + row.square end
assert(sum == options.cases * (options.cases + 1) * (2 * options.cases + 1) // 6)
