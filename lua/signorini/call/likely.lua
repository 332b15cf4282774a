-- The hint for a value of another kind than expected, where what was meant is likely.

local pages = require "signorini.pages"

--- `expected`: the expectation in words. Returns nil where nothing is likely.
return function(expected, value)
  if not expected:find "a face" then return nil end
  if pages.kind(value) == "body" then return 'take a face of the body, such as body:face "south"' end
  return type(value) == "string" and 'a face is a value: body:face "south"' or nil
end
