-- What became of the cases that did not come out, in words. row.outcome is "failed" where run said so, "time" where the
-- limit ended it; an "error" or a process that "crashed" is no result, but something to mend.

local lists = require "signorini.lists"

local outcomes = {}

local words = { error = "ended by an error", crashed = "crashed", time = "took too long" }

--- Whether an outcome is something to mend: such cases run again at the next call.
function outcomes.is_error(outcome) return outcome == "error" or outcome == "crashed" end

--- What came of a case that did not come out, in a line.
function outcomes.line(row)
  local what, reason = words[row.outcome] or "failed", row.reason and tostring(row.reason):match "^[^\n]*"
  return reason and ("%s: %s"):format(what, reason) or what
end

--- "1 failed, 2 ended by an error" of rows, as a list; empty where all came out.
function outcomes.counts(rows)
  local parts = {}
  for _, outcome in ipairs { "failed", "time", "error", "crashed" } do
    local count = #lists.filter(rows, function(row) return row.failed and (row.outcome or "failed") == outcome end)
    if count > 0 then parts[#parts + 1] = ("%d %s"):format(count, words[outcome] or "failed") end
  end
  return parts
end

--- Why nothing came out of a study: how many of its rows failed and how the first one did. Nothing where one came out.
function outcomes.why_none(study)
  if #study.rows == 0 then return study.cases and "none of its cases is done yet: execute the study" or nil end
  if lists.any(study.rows, function(row) return not row.failed end) then return nil end
  local counts, first = outcomes.counts(study.rows), outcomes.line(study.rows[1])
  if #counts == 1 then return ("%d of %d %s"):format(#study.rows, #study.rows, first) end
  return ("%s; the first one %s"):format(table.concat(counts, ", "), first)
end

return outcomes
