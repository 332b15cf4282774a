-- A file of HDF5 as h5py (tests/hdf5/read.py) finds it: by path { shape, values, attributes }.

local check = require "check"
local core = require "signorini.core"

return function(file)
  -- Debian's Python, which finds python3-h5py
  local output, status = check.shell(("/usr/bin/python3 '%s/tests/hdf5/read.py' '%s'"):format(core.home, file))
  if status ~= 0 then error(output) end
  return assert(load(output))()
end
