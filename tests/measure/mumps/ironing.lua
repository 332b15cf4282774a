-- 3D ironing for the studies of MUMPS: the scene, the options of the solver, and runs in processes of their own, of
-- which each has its peak of memory and may be shared by the ranks of mpirun.

local sg = require "signorini"
local problem = require "problems.ironing3d.problem"

local ironing = {}

--- Linear solvers by name; the names with "mumps" and more have options.
ironing.solvers = {
  auto = { linear = "auto" }, umfpack = { linear = "umfpack" },
  mumps = { linear = "mumps" }, ["mumps-reuse"] = { linear = "mumps", mumps = { reuse = true } },
  ["mumps-low-rank"] = { linear = "mumps", mumps = { low_rank = 1e-4 } },
  ["mumps-single"] = { linear = "mumps", mumps = { precision = "single" } },
}

--- The model on the mesh coarse with `fineness` times as many elements in each direction.
function ironing.scene(fineness, mu)
  return (problem.scene({ order = "N2", mesh = "coarse", fineness = fineness, radius = 7.5, mu = mu }, 50))
end

--- What a model's solver says of its size: unknowns, operations and bytes of the factors, bytes of the rank that used
--- most, and the peak of this process.
function ironing.sizes(model)
  local solver = model:solver()
  local peak = io.open "/proc/self/status":read "a":match "VmHWM:%s*(%d+)"
  return { unknowns = solver.unknowns, operations = solver.factor_operations, factors = solver.factor_memory,
           rank = rawget(solver, "rank_memory") or 0, model = solver.memory, peak = 1024 * tonumber(peak) }
end

--- Writes the results of a process, numbers by name.
function ironing.write(file, results)
  local columns, row = {}, {}
  for name in pairs(results) do columns[#columns + 1] = name end
  table.sort(columns)
  for i, name in ipairs(columns) do row[i] = results[name] end
  sg.csv.write(file, { columns = columns, rows = { row } })
end

local function quoted(word) return "'" .. word:gsub("'", [['\'']]) .. "'" end

--- Runs a script of this folder in a process of its own, with `arguments` by name and the launcher's words in front. It
--- writes its results into the file of the argument `once`. Returns them, or nil and why there are none.
function ironing.process(script, arguments, launcher)
  local file = assert(package.searchpath("mumps_" .. script, package.path))
  local words = { launcher, quoted(arg[-1]), "-q", quoted(file) }
  for name, value in pairs(arguments) do words[#words + 1] = quoted(("%s=%s"):format(name, value)) end
  os.remove(arguments.once)
  local pipe = assert(io.popen(table.concat(words, " ") .. " 2>&1"))
  local output = pipe:read "a"
  pipe:close()
  local ok, data = pcall(sg.csv.read, arguments.once)
  if not ok then return nil, output:match "signorini: [^\n]*" or output:match "([^\n]+)\n*$" or "no output" end
  os.remove(arguments.once)
  local results = {}
  for i, name in ipairs(data.columns) do results[name] = data.rows[1][i] end
  return results
end

return ironing
