-- Why a search has ended, in words.

local parameters = require "signorini.inverse.parameters"

local ends = {}

--- The last try since the last move whose run has failed; nil if there is none.
local function failed_try(tries)
  for i = #tries, 1, -1 do
    if tries[i].failed then return tries[i] end
    if tries[i].taken then return nil end
  end
end

--- A sentence, or nil if there is nothing to say.
function ends.text(search, reason, tries)
  if reason == "interrupted" then return "Ctrl-C has ended the search: these are the best values so far" end
  if reason == "runs" then return "the search ended at its limit of runs. Hint: runs = <more>" end
  if reason ~= "stalled" then return nil end
  local failed = failed_try(tries)
  if failed then
    return ("the search ended where runs beyond fail: at %s, %s"):format(parameters.text(search.free, failed.values),
      failed.failed)
  end
  return "the search ended where no short move brings what the derivatives promise: results jump there or have a kink, "
    .. "as where points of a contact change their state. Hint: finer meshes and more steps make kinks smaller"
end

return ends
