-- What `require "signorini"` returns: the functions bound in C++, and those written in Lua, which are added here.

local core = require "signorini.core"
local sg, types = core.sg, core.types

sg.help = require("signorini.help").show
sg.csv = require "signorini.csv"
sg.json = require "signorini.json"
sg.table = require "signorini.table"
sg.arguments = require "signorini.script_arguments"
sg.files = require "signorini.files"
sg.median = require "signorini.median"
sg.reference = require("signorini.reference").read
sg.grid = require "signorini.study.grid"
sg.study = require("signorini.study").new
sg.recommend = require "signorini.recommend"
sg.convergence_map = require "signorini.convergence_map"
sg.work_precision = require "signorini.work_precision"
sg.cheapest = require "signorini.cheapest"
sg.pvd = require "signorini.pvd"
sg.scenes = require "signorini.scenes"
function sg.rigid.level_set(values) return require "signorini.level_set" (values) end
local profile = require "signorini.profile"
sg.profile_error, sg.profile_edges = profile.error, profile.edges
function sg.hyperelastic(values) return require("signorini.hyperelastic").new(values) end
for _, name in ipairs { "mooney_rivlin", "yeoh", "ogden", "saint_venant_kirchhoff" } do
  sg[name] = function(values) return require("signorini.elastic_laws")[name](values) end
end
require "signorini.compound_type" (sg)
types.model.run = require "signorini.run"
types.model.cost = require "signorini.cost"(types.model.cost)
local energies, profiles, named = types.model.energy, types.model.profile, require "signorini.named"
function types.model:energy() return named.strict("model:energy()", energies(self)) end
function types.model:profile(contact)
  return named.strict("a contact profile", profiles(self, contact),
    "lists with one value per contact point, such as profile.pressure[1]")
end
for _, kind in ipairs { "model", "state", "patch" } do
  types[kind].show = function(...) return require("signorini.display").method(kind)(...) end
end
function types.picture:show() return require("signorini.display").show_picture(self) end
sg.robust = require("signorini.controls").robust
sg.plain = require("signorini.controls").plain

local methods = require "signorini.methods"
methods.guard("model", "run cost energy profile show")
methods.guard("state", "show")
methods.guard("patch", "show")
methods.guard("picture", "show")
methods.guard("compound", "corner edge face part")
methods.guard("run", "attempts column columns csv hdf5 report residuals states")
methods.guard("study", "by cancel chart column csv execute heatmap median read report row table watch where with")
methods.guard("comparison", "front table")
methods.guard("map", "cell compare converged csv heatmap picture report table")
methods.guard("files", "draw report")
methods.guard("data", "by column")
methods.guard("series", "add")
methods.offer(sg, "sg")

-- A misspelled name is an error, not nil; print(sg) lists the names.
local language = require "signorini.show.language"
local sorted_names = require("signorini.lists").sorted_names
local function strict(entries, path)
  setmetatable(entries, { __index = function(_, key)
    core.fail(("there is no %s.%s%s"):format(path, tostring(key),
      require "signorini.meant"(tostring(key), sorted_names(entries))))
  end, __tostring = function() return language.of_table(entries, path) end })
end
for _, name in ipairs { "shapes", "nurbs", "rigid", "csv", "json", "scenes" } do
  strict(sg[name], "sg." .. name)
end
strict(sg, "sg")

print = core.offered(require "signorini.print")
require "signorini.prompt" -- has a help page too

return sg
