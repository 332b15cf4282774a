-- sg.pvd: a time series for ParaView: one .vtu file per state, and the .pvd file that lists them.

local check = require "signorini.call.check"
local counted = require("signorini.call.text").counted
local on_behalf_of = require "signorini.call.on_behalf_of"
local core = require "signorini.core"
local lists = require "signorini.call.lists"

local Series = {}
Series.__index = Series
Series.__name = "series"
core.types.series = Series

local header = '<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1" byte_order="LittleEndian">\n'

local function unescaped(text) return (text:gsub("&quot;", '"'):gsub("&lt;", "<"):gsub("&amp;", "&")) end
local function escaped(text) return (text:gsub("&", "&amp;"):gsub("<", "&lt;"):gsub('"', "&quot;")) end

--- Writes the list so far, so that it can be opened during a run, or after the process was killed.
local function write_list(series)
  local lines = lists.map(series, function(state)
    return ('    <DataSet timestep="%.17g" part="0" file="%s"/>\n'):format(state.time, escaped(state.name))
  end)
  on_behalf_of("sg.pvd", "core.write_output", core.write_output, series.file,
    header .. "  <Collection>\n" .. table.concat(lines) .. "  </Collection>\n</VTKFile>\n", "vtk")
end

local function read_list(series)
  local text = on_behalf_of("sg.pvd", "core.read_file", core.read_file, series.file)
  if text:sub(1, #header) ~= header then
    core.fail(("sg.pvd: '%s' was not written by sg.pvd, so it cannot be continued. Hint: leave out resume, or choose "
      .. "another name"):format(series.file))
  end
  for time, name in text:gmatch '<DataSet timestep="([^"]*)" part="0" file="([^"]*)"/>' do
    local number, last = tonumber(time), series[#series]
    if not number or number ~= number or last and number <= last.time then
      core.fail(("sg.pvd: '%s' is damaged: state %d has the time '%s'. Hint: leave out resume, or choose another name")
        :format(series.file, #series + 1, time))
    end
    series[#series + 1] = { time = number, name = unescaped(name) }
  end
  series.taken_up = #series
end

--- Drops states from an earlier process that the run reaches again.
local function drop_from(series, time)
  while series.taken_up == #series and #series > 0 and series[#series].time >= time do
    series[#series], series.taken_up = nil, #series - 1
  end
end

function Series:add(state)
  local time = state.time
  drop_from(self, time)
  local last = self[#self]
  if last and time <= last.time then
    core.fail(("series:add: time is %g, but the state before it has %g: times must increase"):format(time, last.time))
  end
  local name = ("%s_%04d.vtu"):format(self.stem, #self + 1)
  on_behalf_of("series:add", "sg.vtu", core.sg.vtu,
    { model = state.model, file = self.folder .. name, deformed = state.deformed, cells = state.cells,
      subdivisions = state.subdivisions })
  self[#self + 1] = { time = time, name = name }
  write_list(self)
end

function Series:__tostring() return ("series %s: %s"):format(self.file, counted(#self, "state")) end

require("signorini.call.methods").guard("series", "add")

--- A series without states; its file is written at once, so that a folder that is not writable is reported at once.
return function(file, options)
  local folder, stem = file:match "^(.-)([^/]*)%.[pP][vV][dD]$"
  if not stem or stem == "" then check.reject("sg.pvd", "file", "a name that ends with .pvd", file) end
  local series = setmetatable({ file = file, folder = folder, stem = stem, taken_up = 0 }, Series)
  if options.resume and core.exists(file) then read_list(series) end
  write_list(series)
  return series
end
