-- help(): the pages that the bindings and the library register with their functions, and a few on whole subjects.

local core = require "signorini.core"

local subjects = {
  start = [[
signorini: isogeometric contact mechanics.
  help "labels"           discretisation labels such as N2-N2.2
  help "geometry"         patches and how to make them
  help(sg.shapes)         what a table holds
  help(sg.shapes.block)   one function: arguments, units, defaults, an example
  help "refine"           every page with this word
At the prompt: Tab completes, Ctrl-C stops, Ctrl-D leaves. A local variable lives for one line only: leave out `local`.
Units are yours, as long as they are consistent; angles are degrees; directions and indices count from 1.]],
  labels = [[
Discretisation labels, for the directions along the contact face:
  Np          NURBS of degree p, continuity C^(p-1)
  Np.s        Np elevated s times more: degree p + s, still C^(p-1)
  Lp          classical C0 elements of degree p; the geometry is interpolated at p equidistant parameters per span
  Nb-Nc       degree b in the bulk, degree c on the contact face's row of control points only
  Nb-Nc.s     the same, the row elevated s times more
  Nb-Nc.sxr   the same on the first r rows from the contact face, such as N2-N2.2x2 (x1 is the default)
A solid's face has two directions: one label holds for both, order = {"N2-N2.2", "N2"} gives each its own, the direction
of the lower xi first.
Source: V. Agrawal, An Accurate and Efficient Varying Order NURBS Discretization Method (thesis, IIT Guwahati).]],
  geometry = [[
A patch is a NURBS curve, surface or volume, an immutable value.
  sg.shapes.*    ready-made bodies: rectangle, half_annulus, quarter_annulus, block, …
  sg.nurbs.*     curve, surface, volume from knots and points; line, arc, circle, ruled, extrude, revolve, coons
  p(xi)          a point; p:face "south", p:refine{ elements = {8, 3} } and more: help "patch"
Faces: west/east are the ends of xi1, south/north of xi2, front/back of xi3. Points run fastest in xi1.]],
}

local function sorted(set)
  local names = {}
  for name in pairs(set) do names[#names + 1] = name end
  table.sort(names)
  return names
end

--- The first line of a page: how to call it.
local function head(name) return core.docs[name]:match "^[^\n]*" end

local function list(title, names)
  local lines = { title }
  for _, name in ipairs(names) do lines[#lines + 1] = "  " .. head(name) end
  return table.concat(lines, "\n")
end

--- The pages of what a table holds, such as sg.nurbs.
local function table_page(value)
  local names = {}
  local function collect(entries, depth)
    for _, entry in next, entries do
      local name = core.names[entry]
      if name then names[name] = true elseif type(entry) == "table" and depth < 2 then collect(entry, depth + 1) end
    end
  end
  collect(value, 1)
  if next(names) == nil then return "This table has no help page. help() shows where to begin." end
  return list("It holds:", sorted(names))
end

local function word_page(word)
  local exact = subjects[word] or core.docs[word] or core.docs["sg." .. word]
  if exact then return exact end
  local names, last = {}, {}
  for name, page in pairs(core.docs) do
    if (name .. "\n" .. page):lower():find(word:lower(), 1, true) then names[name] = true end
    last[name:match "[^.:]+$"] = true
  end
  if next(names) then return list(("Pages with '%s':"):format(word), sorted(names)) end
  for subject in pairs(subjects) do last[subject] = true end
  local meant = core.nearest(word, sorted(last))
  return ("There is no page on '%s'%s"):format(word, meant and ("; did you mean '%s'?"):format(meant) or ". help() shows where to begin.")
end

local function page_of(...)
  local value = ...
  if select("#", ...) == 0 then return subjects.start end
  if value == nil then return "help(nil): this name stands for nothing. help() shows where to begin." end
  if type(value) == "string" then return word_page(value) end
  if core.names[value] then return core.docs[core.names[value]] end
  if type(value) == "table" then return table_page(value) end
  return core.docs[core.kind(value)] or ("There is no help page for a %s."):format(core.kind(value))
end

return function(...) print(page_of(...)) end
