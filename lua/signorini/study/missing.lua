-- Which cases of a study are to be solved: those without a record, or with one that is out of date.

local inputs = require "signorini.study.inputs"
local outcomes = require "signorini.study.outcomes"
local store = require "signorini.study.store"
local values = require "signorini.study.values"
local release = require "signorini.call.release"

local missing = {}

--- Why a record is out of date; nil if it is not.
function missing.outdated(entry, record, now, limit)
  if not values.same(record.case, entry.case) then return "a parameter changed" end
  local changed = inputs.difference(record.inputs or {}, now)
  if #changed > 0 then return table.concat(changed, ", ") .. " changed" end
  if outcomes.is_error(record.outcome) then return "it ended by an error" end
  if record.outcome == "time" and (not limit or limit > record.wall) then return "the time limit was raised" end
end

local function is_wanted(again, row)
  if type(again) == "function" then return again(row) end
  return again == true or again == "failed" and row.failed
end

--- The message at the start: how many cases are taken from the folder, and why others are solved again.
local function words_on(study, list, reasons, older)
  local finished, words = #study.cases - #list, {}
  for why, count in pairs(reasons) do words[#words + 1] = ("%d because %s"):format(count, why) end
  table.sort(words)
  local again = #words > 0 and "; again: " .. table.concat(words, "; ") or ""
  if finished == 0 and again == "" then return nil end
  local version = older > 0 and (" (%d by another version than %s)"):format(older, release) or ""
  return ("%s: %d of %d taken from %s%s, %s%s"):format(study.name, finished, #study.cases, study.folder, version,
    #list > 0 and #list .. " to solve" or "0 solved", again)
end

--- The positions of the cases to solve, the message about those solved before, and by the names of cases those whose
--- valid record `rerun` rejects. Valid records become those of the study.
function missing.find(study, now, limit, rerun)
  local list, reasons, older, again = {}, {}, 0, {}
  for i, entry in ipairs(study.cases) do
    local record, damaged = store.read(study, entry)
    local why = damaged and "the file cannot be read" or record and missing.outdated(entry, record, now, limit)
    if record and not why and is_wanted(rerun, study:row_of(entry, record)) then
      why, again[entry.id] = "rerun requests it", true
    end
    if why then reasons[why] = (reasons[why] or 0) + 1 end
    if record and not why then
      study.records[i] = record
      if ((record.made or {}).versions or {}).signorini ~= release then older = older + 1 end
    else
      list[#list + 1] = i
    end
  end
  return list, words_on(study, list, reasons, older), again
end

return missing
