-- The outcomes of cases without a result, in words. row.outcome is "failed" if run said so, "time" after the limit; an
-- "error" or a process that "crashed" is not a result, but a mistake to be fixed.

local lists = require "signorini.call.lists"

local outcomes = {}

local words = { error = "ended by an error", crashed = "crashed", time = "exceeded the time limit" }

--- True if an outcome is a mistake to be fixed: such cases run again at the next call.
function outcomes.is_error(outcome) return outcome == "error" or outcome == "crashed" end

--- The outcome of a case without a result, in one line.
function outcomes.line(row)
  local what, reason = words[row.outcome] or "failed", row.reason and tostring(row.reason):match "^[^\n]*"
  return reason and ("%s: %s"):format(what, reason) or what
end

--- "1 failed, 2 ended by an error" of rows, as a list; empty if all have results.
function outcomes.counts(rows)
  local parts = {}
  for _, outcome in ipairs { "failed", "time", "error", "crashed" } do
    local count = #lists.filter(rows, function(row) return row.failed and (row.outcome or "failed") == outcome end)
    if count > 0 then parts[#parts + 1] = ("%d %s"):format(count, words[outcome] or "failed") end
  end
  return parts
end

--- Why no case of a study has a result: how many failed and how the first one did. nil if one has.
function outcomes.why_none(study)
  if #study.rows == 0 then return study.cases and "none of its cases is done yet; execute the study" or nil end
  if lists.any(study.rows, function(row) return not row.failed end) then return nil end
  local counts, first = outcomes.counts(study.rows), outcomes.line(study.rows[1])
  if #counts == 1 then return ("%d of %d %s"):format(#study.rows, #study.rows, first) end
  return ("%s; the first one %s"):format(table.concat(counts, ", "), first)
end

return outcomes
