-- A disc of four arcs, whose map has parallel directions in four corners: fields, pictures, files and profiles of it.

require "check"

local function arc(from, to) return sg.nurbs.arc{ radius = 1, from = from, to = to } end

local function disc(material)
  return sg.body{ patch = sg.nurbs.coons{ south = arc(225, 315), north = arc(135, 45), west = arc(225, 135),
                                          east = arc(-45, 45) },
                  elements = {8, 8}, order = "N2", material = (material or sg.neo_hookean){ E = 1, nu = 0.3 } }
end

local corners = { {0, 0}, {1, 0}, {0, 1}, {1, 1} }

--- A disc between two flat grips, or pulled at two corners of its patch.
local function gripped(body)
  local model = scenes.model{ bodies = { b = body }, supports = {
    s = { on = "south", fix = "xy" }, n = { on = "north", drive = "y" } } }
  check.equal(model:run{ { steps = 1, n = -0.05 } }.reason, "completed")
  return model
end
local function pulled(body)
  local model = scenes.model{ bodies = { b = body }, supports = {
    s = { on = "south-west", fix = "xy" }, n = { on = "north-east", drive = "xy" } } }
  check.equal(model:run{ { steps = 1, n = {0.05, 0.05} } }.reason, "completed")
  return model
end

local fields = { "von_mises", "sxx", "sxy", "pressure", "F11", "F21", "I1" }

check.case("fields are finite everywhere, with both materials and loads", function()
  for _, material in ipairs { sg.neo_hookean, sg.linear_elastic } do
    for _, load in ipairs { gripped, pulled } do
      local model = load(disc(material))
      for _, field in ipairs(fields) do
        local nearby = math.abs(model:sample("b", field, {0.015, 0.015}))
        for i = 0, 40 do
          for j = 0, 40 do
            local value = model:sample("b", field, {i / 40, j / 40})
            check.equal({ field, i, j, value - value }, { field, i, j, 0 }) -- neither infinite nor nan
          end
        end
        local at_corner = math.abs(model:sample("b", field, {0, 0}))
        check.equal({ field, at_corner <= 3 * nearby + 0.1 }, { field, true })
      end
    end
  end
end)

check.case("pictures and files are written, and one color range reports what it excludes", function()
  local folder = check.folder()
  local model = pulled(disc())
  for _, field in ipairs(fields) do
    local file = ("%s/%s.png"):format(folder, field)
    sg.picture{ model = model, field = field, file = file, size = 400 }
    check.equal(check.png(file).width > 0, true)
  end
  sg.picture{ model = model, field = "von_mises", file = folder .. "/corner.png", size = 400,
              crop = { -0.72, -0.68, -0.72, -0.68 } }
  sg.vtu{ model = model, file = folder .. "/disc.vtu" }
  local text = require("signorini.core").read_file(folder .. "/disc.vtu")
  check.equal(text:find "nan", nil)
end)
