-- What `require "signorini"` returns: the functions bound in C++, and those written in Lua, which are added here.

local core = require "signorini.core"
local sg, types = core.sg, core.types

-- Files of the library are found whatever a script does to package.path.
local path, searchpath = package.path, package.searchpath
table.insert(package.searchers, function(name)
  local file = name:find "^signorini%." and searchpath(name, path)
  if file then return loadfile(file), file end
end)

--- A function of a module, or the module itself, which the first call loads: scripts that only run models need not wait
--- for studies and reports.
local function later(module, key)
  return function(...)
    local loaded = require(module)
    return (key and loaded[key] or loaded)(...)
  end
end

sg.help = later("signorini.prompt.help", "show")
sg.csv = require "signorini.output.csv"
sg.json = require "signorini.output.json"
sg.table = require("signorini.output.table").text
sg.arguments = later "signorini.call.script_arguments"
sg.files = require "signorini.output.files"
sg.median = require("signorini.call.lists").median
sg.reference = later("signorini.study.reference", "read")
sg.grid = later "signorini.study.grid"
sg.study = later("signorini.study.study", "new")
sg.recommend = later "signorini.study.recommend"
sg.gradients = later("signorini.gradients.gradients", "gradients")
sg.check_gradients = later("signorini.gradients.check")
sg.fit = later "signorini.inverse.fit"
sg.optimize = later "signorini.inverse.optimize"
sg.convergence_map = later "signorini.study.convergence_map"
sg.work_precision = later "signorini.study.work_precision"
sg.cheapest = later "signorini.study.cheapest"
sg.pvd = later "signorini.output.pvd"
sg.scenes = require "signorini.scene.scenes"
sg.rigid.level_set = later("signorini.scene.formula", "level_set")
local profile = require "signorini.study.profile"
sg.profile_error, sg.profile_edges = profile.error, profile.edges
sg.hyperelastic = later("signorini.scene.formula", "hyperelastic")
for _, name in ipairs { "mooney_rivlin", "yeoh", "ogden", "saint_venant_kirchhoff" } do
  sg[name] = later("signorini.scene.elastic_laws", name)
end
require "signorini.scene.compound_type" (sg)

-- Types that the modules of their objects define.
local defined_in = { study = "signorini.study.study", patch_list = "signorini.scene.patch_list",
                     comparison = "signorini.study.work_precision",
                     map = "signorini.study.convergence_map", gradients = "signorini.gradients.gradients",
                     fit = "signorini.inverse.fit_result", optimum = "signorini.inverse.optimum",
                     series = "signorini.output.pvd", modes = "signorini.run.modes",
                     mode = "signorini.run.modes" }
setmetatable(types, { __index = function(_, name)
  if not defined_in[name] then return nil end
  require(defined_in[name])
  return rawget(types, name)
end, __pairs = function()
  for _, module in pairs(defined_in) do require(module) end
  return next, types
end })

types.model.run = require "signorini.run.run"
types.model.modes = later "signorini.run.modes"
types.model.cost = require "signorini.run.cost"(types.model.cost)
local energies, profiles, resultants = types.model.energy, types.model.profile, types.model.contact_resultant
local named = require "signorini.call.named"
function types.model:energy() return named.strict("model:energy()", energies(self)) end
function types.model:profile(contact)
  return named.strict("a contact profile", profiles(self, contact),
    "lists with one value per contact point, such as profile.pressure[1]")
end
function types.model:contact_resultant(contact)
  return named.strict("a contact resultant", resultants(self, contact))
end
for _, kind in ipairs { "model", "state", "patch" } do
  types[kind].show = function(...) return require("signorini.prompt.display").show_object(kind, ...) end
end
function types.picture:show() return require("signorini.prompt.display").show_picture(self) end
sg.robust = require("signorini.run.controls").robust
sg.plain = require("signorini.run.controls").plain

local methods = require "signorini.call.methods"
methods.guard("model", "run modes cost energy profile contact_resultant show")
methods.guard("state", "show")
methods.guard("patch", "show")
methods.guard("picture", "show")
methods.guard("compound", "corner edge face part")
methods.guard("run", "attempts budget column columns csv error hdf5 report residuals states")
methods.guard("files", "draw report")
methods.guard("data", "by column")
methods.offer(sg, "sg")

-- Their names cannot be misspelled or overwritten; print(sg) lists them.
local text = require("signorini.prompt.show.language").of_table
for _, name in ipairs { "shapes", "nurbs", "rigid", "csv", "json", "scenes" } do
  named.seal(sg[name], "sg." .. name, text)
end
named.seal(sg, "sg", text)

print = core.offered(require "signorini.prompt.print")
require "signorini.prompt.prompt" -- has a help page too

return sg
