-- What VTK's reader (tests/vtk/read_vtu.cpp) finds in a .vtu file, every cell evaluated at all combinations of places
-- in [0, 1].

local check = require "check"

local reader = (arg[-1]:match "^(.*)/[^/]*$" or ".") .. "/tests/read_vtu"

return function(file, places)
  local words = {}
  for i, place in ipairs(places or { 0, 1 }) do words[i] = ("%.17g"):format(place) end
  local output, status = check.shell(("'%s' '%s' %s"):format(reader, file, table.concat(words, " ")))
  if status ~= 0 then error(output) end
  return assert(load(output))()
end
