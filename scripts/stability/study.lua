-- What the studies in this folder share: arguments, both maps of a problem (plain Newton, and all controls on), what
-- one holds beside the other, and the files.

local sg = require "signorini"
local arguments = require "solid_ironing.arguments"
local controls = require "stability.controls"

local study = { split = arguments.split }

local common = { jobs = "2", limit = "600", keep = "no", with = "robust" }

-- ── Arguments ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A list of numbers such as "-0.5,0,1e3".
function study.numbers(name, text)
  local numbers = arguments.split(text)
  for i, part in ipairs(numbers) do
    local number = tonumber(part)
    if not number or number ~= number or math.abs(number) == math.huge then
      error(("%s must be numbers such as 0,0.5,1e3, got '%s'"):format(name, text), 0)
    end
    numbers[i] = number
  end
  return numbers
end

--- A list of numbers above 0.
function study.positive(name, text)
  local numbers = study.numbers(name, text)
  if math.min(table.unpack(numbers)) <= 0 then error(("%s must be above 0, got '%s'"):format(name, text), 0) end
  return numbers
end

--- One of the words of a list.
function study.choice(name, text, words)
  for _, word in ipairs(words) do
    if word == text then return word end
  end
  error(("%s must be one of %s, got '%s'"):format(name, table.concat(words, ", "), text), 0)
end

study.count = arguments.count

--- Reads a script's words key=value, with its own defaults and those that all have: jobs, limit, keep, with.
function study.read(words, defaults)
  for key, value in pairs(common) do defaults[key] = value end
  local texts = arguments.read(words, { "standard" }, { standard = defaults })
  local options = { jobs = arguments.count("jobs", texts.jobs), limit = study.positive("limit", texts.limit)[1],
                    keep = study.choice("keep", texts.keep, { "yes", "no" }) == "yes",
                    with = study.choice("with", texts.with, controls.names) }
  return setmetatable(options, { __index = texts })
end

-- ── Maps ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- How many iterations the cells took that both maps hold.
local function work(plain, robust)
  local before, after = 0, 0
  for _, cell in ipairs(plain.cells) do
    local other = robust:cell(cell.x, cell.y)
    if cell.outcome == "completed" and other.outcome == "completed" then
      before, after = before + cell.iterations, after + other.iterations
    end
  end
  return before, after
end

local function pairs_text(cells)
  local texts = {}
  for i, cell in ipairs(cells) do texts[i] = ("%s, %s"):format(cell[1], cell[2]) end
  return table.concat(texts, "; ")
end

--- Prints both maps, under their titles, and what the controls gained and lost. Returns the comparison, with the
--- iterations of the cells that both hold.
local function report(plain, robust, titles)
  for i, map in ipairs { plain, robust } do print(("\n%s: %s"):format(titles[i], tostring(map))) end
  local result = plain:compare(robust)
  local held, total = plain:held()
  local lost = #result.lost > 0 and (" (%s)"):format(pairs_text(result.lost)) or ""
  print(("\n%s: plain Newton holds %d of %d cells, the controls %d; gained %d, lost %d%s"):format(plain.name, held,
    total, (robust:held()), #result.gained, #result.lost, lost))
  result.plain_iterations, result.robust_iterations = work(plain, robust)
  if result.plain_iterations > 0 then
    print(("iterations in cells that both hold: %d and %d, %.3f times as many"):format(result.plain_iterations,
      result.robust_iterations, result.robust_iterations / result.plain_iterations))
  end
  return result
end

--- Solves a problem's map both ways. `problem`: name, x, y, scene, figures as sg.stability_map takes them, path(model,
--- x, y) with the overrides of model:run's options that both ways need, charts (further pictures: map:figure's name,
--- log and label, and `key`, their file's name), and `key`, part of the files' names when a script has several
--- problems. Returns { plain, robust, comparison }; adds the files that it wrote to `files`.
function study.solve(problem, options, files)
  sg.mkdir(options.out)
  local function file(name)
    files[#files + 1] = ("%s/%s%s"):format(options.out, problem.key and problem.key .. "_" or "", name)
    return files[#files]
  end
  local titles = { controls.titles.plain, controls.titles[options.with] }
  local function solve(kind)
    local name = file(kind .. ".csv")
    if not options.keep then os.remove(name) end
    return sg.stability_map{
      name = problem.name, x = problem.x, y = problem.y, scene = problem.scene, figures = problem.figures,
      jobs = options.jobs, limit = options.limit, file = name,
      path = function(model, x, y)
        local stages, overrides = problem.path(model, x, y)
        return stages, controls[kind](overrides)
      end,
    }
  end
  local plain, robust = solve "plain", solve(options.with)
  local comparison = report(plain, robust, titles)
  plain:picture{ file = file "outcomes.png", title = problem.name .. ": outcome, and Newton's iterations",
                 beside = robust, titles = titles }
  for _, chart in ipairs(problem.charts or {}) do
    plain:figure{ file = file(chart.key .. ".png"), name = chart.name, log = chart.log, label = chart.label,
                  title = problem.name .. ": " .. chart.label, beside = robust, titles = titles }
  end
  return { plain = plain, robust = robust, comparison = comparison }
end

--- Ends a script: says what was written.
function study.finish(files) print("\nWritten: " .. table.concat(files, "\n         ")) end

return study
