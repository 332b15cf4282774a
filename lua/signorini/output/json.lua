-- Data as JSON files, for other programs.

local core = require "signorini.core"
local on_behalf_of = require "signorini.call.on_behalf_of"

local json = {}

function json.write(file, value)
  local text = core.write_json(value, "sg.json.write: value", true)
  on_behalf_of("sg.json.write", "core.write_output", core.write_output, file, text, "json")
end

function json.read(file)
  local text = on_behalf_of("sg.json.read", "core.read_file", core.read_file, file)
  return on_behalf_of(("sg.json.read: '%s'"):format(file), "core.read_json", core.read_json, text)
end

return json
