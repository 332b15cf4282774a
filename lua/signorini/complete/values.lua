-- The texts that may stand between quotes at a place in a call: closed sets, and names of an object's parts.

local core = require "signorini.core"
local columns_of = require("signorini.study.values").columns
local sorted_names = require("signorini.lists").sorted_names

local faces = { "west", "east", "south", "north", "front", "back" }
local corners = { "south-west", "south-east", "north-west", "north-east" }
local axes = { "x", "y", "z", "xy", "xz", "yz", "xyz" }
local directions = { "x", "y", "z", "-x", "-y", "-z" }
local labels = { "N1", "N2", "N3", "N4", "N2-N2.1", "N2-N2.2", "N2-N4", "L1", "L2" } -- the usual ones
local step = { line_search = { "none", "residual", "energy" }, predictor = { "tangent", "constant", "linear" },
               linear = core.linear_solvers }
local picture = { field = core.fields, fields = core.fields, colormap = core.colormaps, camera = core.cameras,
                  cut = directions, normal = directions, mirror = axes }
local chart = { log = { "x", "y", "xy" } }

--- By page and key.
local keyed = {
  ["sg.body"] = { order = labels, contact = faces, at = { "start", "end" } },
  ["patch:refine"] = { at = { "start", "end" } },
  ["sg.shapes.hollow_hemisphere"] = { poles = { "ends", "bottom" } },
  ["sg.model"] = { kind = { "plane_strain", "axisymmetric" }, fix = axes, drive = axes, rotate = { "x", "y", "z" } },
  ["model:run"] = step, ["sg.robust"] = step, ["sg.plain"] = step, ["model:solve_step"] = step,
  ["model:iterate"] = step,
  ["model:solve_arc"] = { linear = core.linear_solvers },
  ["sg.picture"] = picture, ["sg.frame"] = picture,
  ["sg.chart"] = chart, ["study:chart"] = chart,
  ["sg.heatmap"] = { colormap = core.colormaps }, ["study:heatmap"] = { colormap = core.colormaps },
  ["sg.profile_error"] = { value = { "pressure", "traction" }, quadrature = { "profile", "reference", "union" },
                           zone = { "either", "both" }, edge = { "point", "gap" } },
}

--- The keys of a page whose texts are columns of a study.
local columns = {
  ["study:chart"] = "x y series", ["study:heatmap"] = "x y value",
  ["study:table"] = "columns sort", ["study:csv"] = "columns sort",
  ["sg.cheapest"] = "error cost", ["sg.work_precision"] = "error time series marker",
}

local function dimension(owner) return #owner:points()[1] end

local function moved_and_held(model)
  local names = model:support_names()
  return table.move(model:load_names(), 1, #model:load_names(), #names + 1, names)
end

--- The names of what `count` faces of a solid have in common: edges of two, corners of three.
local function meetings(count, from, begun, list)
  if count == 0 then list[#list + 1] = begun end
  for direction = from, count > 0 and 3 or 0 do
    for side = 2 * direction - 1, 2 * direction do
      meetings(count - 1, direction + 1, begun and begun .. "-" .. faces[side] or faces[side], list)
    end
  end
  return list
end

--- By page, the first argument from the object that a method is called on.
local named = {
  ["patch:face"] = function(patch) return table.move(faces, 1, 2 * #patch:degrees(), 1, {}) end,
  ["body:face"] = function(body) return table.move(faces, 1, 2 * dimension(body), 1, {}) end,
  ["body:corner"] = function(body) return dimension(body) == 2 and corners or meetings(3, 1, nil, {}) end,
  ["body:edge"] = function(body) return dimension(body) == 3 and meetings(2, 1, nil, {}) or {} end,
  ["model:body"] = function(model) return model:body_names() end,
  ["model:profile"] = function(model) return model:contact_names() end,
  ["model:contact_resultant"] = function(model) return model:contact_names() end,
  ["model:reaction"] = moved_and_held,
  ["model:target"] = function(model) return model:driven_names() end,
  ["model:driven"] = function(model) return model:driven_names() end,
  ["model:set_target"] = function(model) return model:driven_names() end,
  ["model:sample"] = function(model) return model:body_names() end,
  ["run:column"] = function(run) return run:columns() end,
  ["study:column"] = columns_of, ["study:by"] = columns_of,
  ["study:median"] = function(study) return study.parameters end,
}

--- Words that help knows.
function named.help()
  local texts, subjects = require "signorini.help.texts", require "signorini.help.subjects"
  local words = sorted_names(texts)
  for _, group in ipairs(subjects.groups) do
    words[#words + 1] = group.word
    for _, name in ipairs(subjects.pages(group)) do words[#words + 1] = name end
  end
  return words
end

local values = {}

--- Whether the names of a page's arguments are the columns of the study that it is called on.
function values.is_filter(page) return page == "study:where" or page == "study:row" end

--- The texts in a column of a study, each once.
local function texts_in(study, column)
  local list, seen = {}, {}
  for _, row in ipairs(study.rows) do
    local text = row[column]
    if type(text) == "string" and not seen[text] then seen[text], list[#list + 1] = true, text end
  end
  return list
end

--- The texts for a key of a page; `study`: the study that the call is about, if any.
function values.of_key(page, key, study)
  if values.is_filter(page) then return texts_in(study, key) end
  local names = columns[page]
  if names and study and (" " .. names .. " "):find(" " .. key .. " ", 1, true) then return columns_of(study) end
  return keyed[page] and keyed[page][key] or {}
end

--- The texts for the first argument of a method.
function values.of_argument(page, owner)
  local ok, list = pcall(named[page] or error, owner)
  return ok and list or {}
end

return values
