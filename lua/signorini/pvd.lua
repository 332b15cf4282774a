-- sg.pvd: a time series for ParaView: one .vtu file per state, and the .pvd file that lists them.

local arguments = require "signorini.arguments"
local core = require "signorini.core"

local Series = {}
Series.__index = Series
Series.__name = "series"

local function escaped(text) return (text:gsub("&", "&amp;"):gsub("<", "&lt;"):gsub('"', "&quot;")) end

--- The list as it stands, so that what is there can be opened while a run goes on, or after it was killed.
local function write_list(series)
  local lines = { '<?xml version="1.0"?>', '<VTKFile type="Collection" version="0.1" byte_order="LittleEndian">', "  <Collection>" }
  for _, state in ipairs(series) do
    lines[#lines + 1] = ('    <DataSet timestep="%.17g" part="0" file="%s"/>'):format(state.time, escaped(state.name))
  end
  core.write_file(series.file, table.concat(lines, "\n") .. "\n  </Collection>\n</VTKFile>\n")
end

--- Writes the model's present state and adds it to the list.
function Series:add(state)
  if getmetatable(self) ~= Series then core.fail "series:add: write series:add{ … } with a colon" end
  state = arguments.table("series:add", "the argument", state, { "model", "time", "deformed" })
  local time = arguments.number("series:add", "time", state.time)
  local last = self[#self]
  if last and time <= last.time then
    core.fail(("series:add: time is %g, but the state before it has %g: times must grow"):format(time, last.time))
  end
  if core.kind(state.model) ~= "model" then
    arguments.reject("series:add", "model", "a model made by sg.model", state.model)
  end
  local name = ("%s_%04d.vtu"):format(self.stem, #self + 1)
  core.sg.vtu { model = state.model, file = self.folder .. name, deformed = state.deformed }
  self[#self + 1] = { time = time, name = name }
  write_list(self)
end

function Series:__tostring()
  return ("series %s: %d %s"):format(self.file, #self, #self == 1 and "state" or "states")
end

--- A series without states; its file is there at once, so that a place that cannot be written to is told at once.
local function new(file)
  arguments.string("sg.pvd", "file", file)
  local folder, stem = file:match "^(.-)([^/]*)%.[pP][vV][dD]$"
  if not stem or stem == "" then arguments.reject("sg.pvd", "file", "a name that ends with .pvd", file) end
  local series = setmetatable({ file = file, folder = folder, stem = stem }, Series)
  write_list(series)
  return series
end

return { new = new, methods = Series }
