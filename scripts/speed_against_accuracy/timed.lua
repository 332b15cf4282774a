-- How long a call takes.

local sg = require "signorini"

--- What body() returns (one value), and the seconds that went by (wall) and that the processor worked (cpu, of all
--- threads).
return function(body)
  local wall, cpu = sg.wall_time(), os.clock()
  local result = body()
  return result, { wall = sg.wall_time() - wall, cpu = os.clock() - cpu }
end
