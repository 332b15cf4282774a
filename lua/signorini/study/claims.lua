-- Claims of cases on a shared disk: one task solves a case, whatever machines the tasks are on. The claim of a case is
-- the file cases/<case>.claim, which names its task; the file system lets only one task create it. Tasks remove it when
-- the case is done. The claim of a task that has died remains until no living task is going to solve the case
-- (remote.lua), or until the same task starts again.

local core = require "signorini.core"
local lists = require "signorini.call.lists"

local claims = {}

local function file_of(study, entry) return ("%s/cases/%s.claim"):format(study.folder, entry.id) end

--- The name of the task that has claimed a case; nil without a claim.
function claims.owner(study, entry)
  local ok, owner = pcall(core.read_file, file_of(study, entry)) -- it may be released at any time
  return ok and owner or nil
end

--- True if the task of this name got the claim of a case, now or in an earlier start of it. The case may have been done
--- meanwhile: look after the claim.
function claims.take(study, entry, name)
  return core.create_claim(file_of(study, entry), name) or claims.owner(study, entry) == name
end

function claims.release(study, entry) os.remove(file_of(study, entry)) end

--- How many cases are claimed.
function claims.count(study)
  return #lists.filter(core.list_folder(study.folder .. "/cases"), function(name) return name:find "%.claim$" end)
end

return claims
