-- A chart with one curve per formulation.

local sg = require "signorini"

--- Draws value(formulation, i) of the formulations over abscissae[i] to a file of `files` (the result of sg.files);
--- points without value, and zeros on a logarithmic axis, are left out. `chart`: what sg.chart takes besides.
return function(files, name, formulations, abscissae, value, chart)
  local log = chart.log and chart.log:find "y"
  for _, formulation in ipairs(formulations) do
    local line = { x = {}, y = {}, label = formulation.label, markers = true }
    for i, x in ipairs(abscissae) do
      local y = value(formulation, i)
      if y and not (log and y == 0) then line.x[#line.x + 1], line.y[#line.y + 1] = x, y end
    end
    if #line.x > 0 then chart[#chart + 1] = line end
  end
  files:draw(name, "a case that converged", function(file)
    chart.file = file
    if #chart > 0 then sg.chart(chart) end
    return #chart > 0
  end)
end
