-- model:run for the model of a spring: the language's, behind the check of its arguments. As part of the library, so
-- that errors appear at the test's line.

local core = require "signorini.core"

return load([[
local check_call, run_path = require("signorini.call.check").call, require "signorini.run.run"
return function(model, ...) return run_path(model, check_call("model:run", model, ...)) end
]], ("@%s/lua/spring_run.lua"):format(core.home))()
