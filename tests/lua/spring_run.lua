-- model:run for the model of a spring: the language's, behind the check of its arguments.

local check_call, run_path = require("signorini.call.check").call, require "signorini.run.run"
return function(model, ...) return run_path(model, check_call("model:run", model, ...)) end
