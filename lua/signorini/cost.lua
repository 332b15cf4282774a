-- model:cost: what a model is made of in numbers, and what of it could be saved, in words.

local core = require "signorini.core"
local format_table = require "signorini.table"

local Cost = {}
Cost.__index = Cost
Cost.__name = "cost"

-- ── Advice ───────────────────────────────────────────────────────────────────────────────────────────────────────────
-- Each kind is a function of the model's figures that calls add(kind, saves, needs, text).

--- "x = 1.5".
local function plane_text(plane) return ("%s = %.6g"):format(plane.axis, plane.place) end

--- "'grip' and 'rest' are".
local function subject(names)
  return ("'%s' %s"):format(table.concat(names, "' and '"), #names == 1 and "is" or "are")
end

local function symmetries(figures, add)
  for _, choice in ipairs(figures.symmetries) do
    local names, axes, driven = {}, {}, choice.planes[1].driven
    for i, plane in ipairs(choice.planes) do names[i], axes[i] = plane_text(plane), plane.axis end
    local saves, part = figures.unknowns - choice.needs, ({ "half", "quarter", "eighth" })[#names]
    if saves > 0 then
      local sure = #choice.planes > 1 or #driven == 0
      local condition = sure and "" or (" as long as %s not driven along %s"):format(subject(driven), axes[1])
      add(sure and "symmetry" or "symmetry if fixed", saves, choice.needs, ("The scene is its own mirror image in "
        .. "%s%s: one %s of it, with %s fixed on %s, would need %d unknowns, %d fewer. The path must be symmetric, "
        .. "too; forces are then those of the %s."):format(table.concat(names, ", "), condition, part,
          table.concat(axes, " and "), #names == 1 and "that plane" or "these planes", choice.needs, saves, part))
    end
  end
end

local function revolution(figures, add)
  local found = figures.revolution
  if not found then return end
  local saves, centre = figures.unknowns - found.needs, {}
  for i, value in ipairs(found.centre) do centre[i] = ("%.6g"):format(value) end
  add("axisymmetry", saves, found.needs, ("All bodies turn around one axis, parallel to %s through (%s): a plane scene "
    .. "of their section with kind = \"axisymmetric\" would need %d unknowns, %d fewer. The path must not leave the "
    .. "axis, and wrinkles around it cannot be seen.")
    :format(found.axis, table.concat(centre, ", "), found.needs, saves))
end

local function rigid(figures, add)
  for _, stiff in ipairs(figures.stiff) do
    add("rigid", stiff.saves, figures.unknowns - stiff.saves, ("Body '%s' is %.4g times as stiff as '%s' and one "
      .. "support moves it: as a rigid obstacle, sg.rigid.surface of its contact face, it would save all of its %d "
      .. "unknowns. This leaves out its own deformation, about 1/%.4g of the other's.")
      :format(stiff.body, stiff.ratio, stiff.partner, stiff.saves, stiff.ratio))
  end
end

--- A label, or one per direction, as a script has it, with the degree in the thickness direction where it is needed.
local function order_text(choice)
  local labels, through = choice.labels, choice.through and (", through = %d"):format(choice.through) or ""
  for i = 2, #labels do
    if labels[i] ~= labels[1] then return ("order = {\"%s\"}%s"):format(table.concat(labels, "\", \""), through) end
  end
  return ("order = \"%s\"%s"):format(labels[1], through)
end

local function layers(figures, add)
  for _, choice in ipairs(figures.layers) do
    local saves = figures.bodies[choice.body].unknowns - choice.needs
    add("layer", saves, figures.unknowns - saves, ("Body '%s' has its high degree everywhere: %s keeps it on the "
      .. "contact face alone and would need %d unknowns in this body, %d fewer. Whether that is accurate enough, a run "
      .. "of both tells."):format(choice.body, order_text(choice), choice.needs, saves))
  end
  for _, choice in ipairs(figures.idle_layers) do
    local saves = figures.bodies[choice.body].unknowns - choice.needs
    add("idle layer", saves, figures.unknowns - saves, ("The layer of body '%s' is on a face without contact: %s would "
      .. "need %d unknowns in this body, %d fewer.")
      :format(choice.body, order_text(choice), choice.needs, saves))
  end
end

local function dense(figures, add)
  for _, found in ipairs(figures.dense) do
    add("points", 0, figures.unknowns, ("Contact '%s' has points = %d per element and direction, more than twice the "
      .. "usual 3(p+1) = %d: those would be %d contact points in place of %d.")
      :format(found.contact, found.points, found.enough, found.needs, figures.contacts[found.contact].points))
  end
end

local function advise(figures)
  local advice = {}
  local function add(kind, saves, needs, text)
    advice[#advice + 1] = { kind = kind, saves = saves, needs = needs, text = text }
  end
  for _, find in ipairs { revolution, symmetries, rigid, layers, dense } do find(figures, add) end
  return advice
end

-- ── Text ─────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- "1.25 MB".
local function bytes_text(bytes)
  for _, unit in ipairs { "bytes", "kB", "MB" } do
    if bytes < 1000 then return (unit == "bytes" and "%d %s" or "%.3g %s"):format(bytes // 1 | 0, unit) end
    bytes = bytes / 1000
  end
  return ("%.3g GB"):format(bytes)
end

local function sorted_names(list)
  local names = {}
  for name in pairs(list) do names[#names + 1] = name end
  table.sort(names)
  return names
end

local function bodies_text(cost)
  local rows, total = {}, { "all", 0, 0, 0, 0, 0, 0 }
  for i, name in ipairs(sorted_names(cost.bodies)) do
    local body = cost.bodies[name]
    rows[i] = { name, body.unknowns, body.bulk, body.contact_layer, body.prescribed, body.elements, body.gauss_points }
    for k = 2, #total do total[k] = total[k] + rows[i][k] end
  end
  rows[#rows + 1] = total
  return format_table {
    columns = { "body", "unknowns", "bulk", "contact faces", "prescribed", "elements", "Gauss points" }, rows = rows,
  }
end

local function contacts_text(cost)
  local rows = {}
  for i, name in ipairs(sorted_names(cost.contacts)) do
    local contact = cost.contacts[name]
    rows[i] = { name, contact.points, contact.rigid and "rigid obstacle, no unknowns" or "body" }
  end
  return format_table { columns = { "contact", "points", "master" }, rows = rows }
end

--- The tables, a line on the linear system and the memory, then what could be saved.
function Cost:__tostring()
  local parts = { bodies_text(self) }
  if next(self.contacts) then parts[#parts + 1] = contacts_text(self) end
  local of = self.memory_of
  parts[#parts + 1] = ("%d nonzeros in the tangent; memory %s: bodies %s, contacts %s, tangent %s, factors "
    .. "(%s, %s) %s"):format(self.nonzeros, bytes_text(self.memory), bytes_text(of.bodies), bytes_text(of.contacts),
      bytes_text(of.tangent), self.linear, self.factors_are, bytes_text(of.factors))
  for _, advice in ipairs(self.advice) do parts[#parts + 1] = advice.text end
  if #self.advice == 0 then parts[#parts + 1] = "Nothing to save in sight." end
  return table.concat(parts, "\n")
end

core.docs["model:cost"] = [[
model:cost()
What a model is made of, before a solve or after it, and what could be saved. print(model:cost()) shows tables and
advice.
cost.unknowns:   of the linear system; obstacles (cost.obstacles, how many) have none.
cost.bodies:     by name { unknowns, contact_layer, bulk, prescribed, elements, gauss_points }: contact_layer are the
                 unknowns on the faces that `contact` names, bulk all others, prescribed what supports fix or drive.
cost.contacts:   by name { points, rigid }: contact points, and whether the master is an obstacle.
cost.nonzeros:   of the tangent; it grows where contacts touch.
cost.memory:     bytes, the sum of cost.memory_of { bodies, contacts, tangent, factors }: tables of Gauss points,
                 contact points with their history, the tangent with its patterns, its factors by the solver
                 cost.linear. cost.factors_are is "measured" once a solver has told, before that "counted": from the
                 pattern in the order of nested dissection.
cost.advice:     a list of { kind, saves, needs, text }: unknowns saved and left in the whole scene, and why, as far as
                 the scene alone can tell:
  symmetry:    it is its own mirror image in planes x, y or z = c (in an axisymmetric scene y = c): control points,
               weights, knots, supports, loads, contacts, obstacles. What turns or has moved through it breaks it.
  symmetry if fixed: the same, but a support may drive through the plane: only while it does not.
  axisymmetry: solids of revolution about one axis, or sectors that supports hold in their end planes.
  rigid:       a body at least 100 times as stiff as those that it touches, which one support moves without turning it.
  layer:       a uniform degree above 2 on a body whose contact face alone may need it.
  idle layer:  a layer on a face that is in no contact.
  points:      more than twice 3(p+1) contact points per element and direction; it saves no unknowns.
Paths are not looked at: they must be symmetric, too.
Example: for _, advice in ipairs(model:cost().advice) do print(advice.saves, advice.text) end]]
return function(model)
  local figures = core.types.model.cost_figures(model) -- says so when it is no model
  local cost = {
    unknowns = figures.unknowns, bodies = figures.bodies, contacts = figures.contacts, obstacles = figures.obstacles,
    nonzeros = figures.nonzeros, memory = figures.memory, memory_of = figures.memory_of,
    factors_are = figures.factors_are, linear = figures.linear, advice = advise(figures),
  }
  return setmetatable(cost, Cost)
end
