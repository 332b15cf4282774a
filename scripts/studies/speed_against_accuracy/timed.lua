-- Duration of a call.

local sg = require "signorini"

--- The result of body() (one value), wall time, and processor time of all threads (cpu), in seconds.
return function(body)
  local wall, cpu = sg.wall_time(), os.clock()
  local result = body()
  return result, { wall = sg.wall_time() - wall, cpu = os.clock() - cpu }
end
