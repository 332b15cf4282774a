-- Where pictures without a file appear.

local core = require "signorini.core"

local display = {}

--- display.screen(picture) shows a picture; a front end sets it. nil where pictures need a file.

function display.show(picture)
  if display.screen then return display.screen(picture) end
  core.fail "pictures need a file here. Hint: file = \"picture.png\", or picture:write \"picture.png\""
end

return display
