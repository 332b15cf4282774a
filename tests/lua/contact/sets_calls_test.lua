-- Wrong arguments of sets of faces (among, except, pairs).

require "check"

check.refusals([[
local slab = sg.body { patch = sg.shapes.rectangle { width = 2, height = 1 }, elements = { 2, 1 }, order = "N2",
                       material = sg.neo_hookean { E = 1, nu = 0.3 } }
local function model(contact, body) return sg.model { bodies = { slab = body or slab }, contacts = { c = contact } } end
local layered = sg.body { patch = sg.shapes.block { size = { 1, 1, 1 } }, elements = { 2, 2, 2 }, order = "N2-N3",
                          contact = "back", material = sg.neo_hookean { E = 1, nu = 0.3 } }
]], 3, {
  { [[model { among = slab:face "north", slave = slab:face "south" }]], "has both among and slave", "has no slave" },
  { [[model { among = slab:face "north", master = slab:face "south" }]], "has both among and master" },
  { [[model { slave = slab:face "north" }]], "needs master", "or among" },
  { [[model { penalty = 1 }]], "needs slave", "or among" },
  { [[model { slave = slab:face "north", master = slab:face "north" }]], "same face", "write among" },
  { [[model { among = "every" }]], [[among must be a face, a list of faces, or "all"]], "every" },
  { [[model { among = { slab:face "north", slab:face "north" } }]], "contacts.c.among", "twice" },
  { [[model { slave = slab:face "north", master = slab:face "south", except = {} }]], "except without among" },
  { [[model { among = "all", except = { slab } }]], "contacts.c.except[1] must be", "write { A, B }" },
  { [[model { among = "all", except = { { slab, slab, slab } } }]], "contacts.c.except[1] must be a list of 2" },
  { [[model { among = "all", pairs = { p = { friction = { mu = 0.1 } } } }]], "contacts.c.pairs.p", "between" },
  { [[model { among = slab:face "north", pairs = { p = { between = { slab:face "south", slab } } } }]],
    "contacts.c.pairs.p.between names no two parts of the set" },
  { [[model { among = "north" }]], "contacts.c.among must be", [[a face is a value: body:face "south"]] },
  { [[model({ among = "all" }, layered)]], "contacts.c: among is",
    "crosses its layer", "list the faces" },
  { [[model { among = 3 }]], "contacts.c.among must be", [[a face is a value: body:face "south"]] },
  { [[model { among = "all", except = { { slab, slab } }, pairs = { p = { between = { slab:face "south", slab } } } }]],
    "contacts.c.pairs.p.between", "except leaves out" },
  { [[model { among = slab:face "north", except = { { slab:face "south", slab } } }]],
    "contacts.c.except[1] names no two parts of the set" },
  { [[model { among = "all", except = { { slab, sg.rigid.plane { point = { 0, 0 }, normal = { 0, 1 } } } } }]],
    "contacts.c.except[1][2] is an obstacle that no support holds" },
  { [[model { among = "all", adhesion = { hamaker = 1, r0 = 0.1 }, pairs = { p = { between = { slab, slab },
      friction = { mu = 0.1 } } } }]], "pairs.p.friction", "adhesion" },
  { [[model { among = "all", method = "mortar" }]], [[among and method = "mortar"]], "at points" },
  { [[model { among = "all", enforcement = "multipliers" }]], "among and enforcement", "at points" },
  { [[model { among = "all", method = "half_passes", multipliers = "equal" }]], "among and multipliers" },
  { [[model { among = "all", cohesive = { strength = 1, energy = 1 } }]], "among and cohesive" },
  { [[model { among = "all", overlap = "interference" }]], "among and overlap" },
  { [[model { among = "all", friction = { mu = function(cosine) return 0.1 * cosine + 0.2 end, along = { 1, 0 } } }]],
    "sign of the direction" },
})
