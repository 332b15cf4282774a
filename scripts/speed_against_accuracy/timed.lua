-- How long a call takes.

local core = require "signorini.core"

--- What body() returns (one value), and the seconds that went by (wall) and that the processor worked (cpu, of all
--- threads).
return function(body)
  local wall, cpu = core.now(), os.clock()
  local result = body()
  return result, { wall = core.now() - wall, cpu = os.clock() - cpu }
end
