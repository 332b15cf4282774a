-- Counts what becomes of many generated scenes, and of each in other words (variants.lua).

local checks = require "robustness.checks"
local dice = require "stability.generated.dice"
local scenes = require "robustness.scenes"
local variants = require "robustness.variants"

local survey = {}

local function count(list, key) list[key] = (list[key] or 0) + 1 end

--- The beginning of a message without the line, with # in place of numbers.
local function general(message)
  local text = message:gsub("^[^:\n]*:%d+: ", ""):gsub("%-?%d[%d.e+-]*", "#"):gsub(" Hint: .*", "")
  return #text <= 100 and text or text:sub(1, 100):match "^(.*) %S*$" .. " …"
end

--- The names of the variants that a scene is compared with: all, none, or two or three that depend on the seed.
local function chosen(scene, how)
  if how == "all" then return variants.names end
  if how == "none" then return {} end
  local roll, names = dice(scene.seed + 104729), variants.names
  local count = #names - 1 -- all but the last, "saved", which one scene in six has besides
  local first = roll.integer(1, count)
  return { names[first], names[(first + roll.integer(0, count - 2)) % count + 1],
           dice(scene.seed + 15485863).uniform(0, 1) < 1 / 6 and names[#names] or nil }
end

--- Solves the scenes of the seeds first … first + count - 1. `how`: "some", "all" or "none" of the variants; `begin`:
--- called with each seed; `family`: of the scenes (families.lua; default: any scene). Returns counts: outcomes (of the
--- scenes; "ended" with the reason), refusals (by message), compared and different (by variant; different ones with
--- "outcome" or "forces"), and lists of texts: found, apart.
function survey.run(first, how_many, how, begin, family)
  local result = { scenes = how_many, outcomes = {}, refusals = {}, compared = {}, different = {}, found = {},
                   apart = {} }
  for seed = first, first + how_many - 1 do
    if begin then begin(seed) end
    local scene = scenes.describe(seed, family)
    local account = checks.solve(scene)
    count(result.outcomes, account.outcome == "ended" and "ended: " .. account.detail or account.outcome)
    if account.outcome == "refused" then count(result.refusals, general(account.detail)) end
    for _, text in ipairs(account.found) do
      result.found[#result.found + 1] = ("%s\n  %s"):format(scenes.text(scene), text)
    end
    for _, name in ipairs(account.reason ~= "stopped" and chosen(scene, how) or {}) do
      local text, kind, other = variants.compare(scene, account, name)
      if other then count(result.compared, name) end
      if text then
        count(result.different, ("%s: %s"):format(name, kind))
        result.apart[#result.apart + 1] = ("%s\n  %s: %s"):format(scenes.text(scene), name, text)
      end
    end
  end
  return result
end

return survey
