-- The order of the pages for readers: groups by subject. An entry is a page's name, or the beginning of such names,
-- which ends with a dot or a colon; a page stands where its own name does, else with the first beginning that fits.

local core = require "signorini.core"

local subjects = {}

--- { word for help, title, entries }. What belongs to none is not part of the language: signorini.core, and locks.
subjects.groups = {
  { word = "patches", title = "Shapes and patches", "sg.shapes.", "sg.nurbs.", "patch", "patch:" },
  { word = "bodies", title = "Materials, bodies, obstacles", "sg.neo_hookean", "sg.linear_elastic", "material",
    "sg.body", "body", "body:", "face", "sg.rigid.", "obstacle" },
  { word = "solving", title = "Models and load paths", "sg.model", "model", "model:warnings", "model:run", "sg.robust",
    "sg.plain", "run", "run:", "state", "model:cost", "model:save", "sg.load" },
  { word = "results", title = "Results of a model", "model:profile", "model:sample", "model:energy", "model:reaction",
    "model:contact_resultant", "sg.profile_error", "sg.profile_edges" },
  { word = "verbs", title = "Small verbs: loops of one's own", "model:", "snapshot" },
  { word = "pictures", title = "Pictures and charts", "sg.picture", "sg.frame", "frame", "sg.chart", "sg.heatmap" },
  { word = "studies", title = "Studies", "sg.study", "sg.grid", "study", "study:", "sg.work_precision", "comparison",
    "comparison:", "sg.cheapest", "sg.recommend", "sg.stability_map", "map", "map:" },
  { word = "scripts", title = "Tables, files, scripts", "sg.arguments", "sg.files", "files", "files:", "sg.mkdir",
    "sg.table", "sg.csv.", "sg.reference", "data", "data:", "sg.vtu", "sg.pvd", "series", "series:", "sg.median",
    "sg.wall_time", "help", "traceback" },
}

local found = {} -- what place() returned, by name: each group asks for the places of all names

--- Where a page stands: the group and the place of the entry in it; nothing for pages that are not part of the
--- language.
local function find_place(name)
  for _, beginning in ipairs { false, true } do
    for g, group in ipairs(subjects.groups) do
      for i, entry in ipairs(group) do
        local fits = entry == name
        if beginning then fits = entry:find "[.:]$" and name:sub(1, #entry) == entry end
        if fits then return g, i end
      end
    end
  end
end

local function place(name)
  if not found[name] then found[name] = table.pack(find_place(name)) end
  return found[name][1], found[name][2]
end

--- The names of a group's pages in order.
function subjects.pages(group)
  local names, places = {}, {}
  for name in pairs(core.docs) do
    local g, i = place(name)
    if subjects.groups[g] == group then names[#names + 1], places[name] = name, i end
  end
  table.sort(names, function(a, b)
    if places[a] ~= places[b] then return places[a] < places[b] end
    return a < b
  end)
  return names
end

--- The group of a word such as "patches", or nil.
function subjects.group(word)
  for _, group in ipairs(subjects.groups) do
    if group.word == word then return group end
  end
end

--- Whether a page is part of the language.
function subjects.is_public(name) return place(name) ~= nil end

return subjects
