-- Contact formulations that the studies compare: one row each. A new formulation is a new row.

local rows = {}

--- name: on the command line; label: in tables and charts; keys: of the contact; two_faces: the master must be a face
--- of a body; swapped: exchanges slave and master (multipliers should be on the softer body).
local list = {
  { name = "gpts", label = "GPTS", keys = {} },
  { name = "equal", label = "mortar equal", keys = { method = "mortar", multipliers = "equal" } },
  { name = "equal-multipliers", label = "mortar equal, multipliers",
    keys = { method = "mortar", multipliers = "equal", enforcement = "multipliers" } },
  { name = "reduced", label = "mortar reduced", keys = { method = "mortar", multipliers = "reduced" } },
  { name = "reduced-multipliers", label = "mortar reduced, multipliers",
    keys = { method = "mortar", multipliers = "reduced", enforcement = "multipliers" } },
  { name = "equal-multipliers-swapped", label = "mortar equal, multipliers, swapped", two_faces = true, swapped = true,
    keys = { method = "mortar", multipliers = "equal", enforcement = "multipliers" } },
  { name = "reduced-multipliers-swapped", label = "mortar reduced, multipliers, swapped", two_faces = true,
    swapped = true, keys = { method = "mortar", multipliers = "reduced", enforcement = "multipliers" } },
  { name = "half-passes", label = "half passes", keys = { method = "half_passes" }, two_faces = true },
  { name = "half-passes-equal", label = "half passes, mortar equal", two_faces = true,
    keys = { method = "half_passes", multipliers = "equal" } },
  { name = "half-passes-reduced", label = "half passes, mortar reduced", two_faces = true,
    keys = { method = "half_passes", multipliers = "reduced" } },
}

--- Names of all formulations, and of those that are not swapped: most studies choose the slave themselves.
rows.choices, rows.names = {}, {}
for i, row in ipairs(list) do
  rows.choices[i], rows[row.name] = row.name, row
  if not row.swapped then rows.names[#rows.names + 1] = row.name end
end

--- The rows with these names.
function rows.of(names)
  local chosen = {}
  for i, name in ipairs(names) do chosen[i] = rows[name] end
  return chosen
end

--- The names of those that a condition keeps.
function rows.where(condition)
  local names = {}
  for _, name in ipairs(rows.names) do
    if condition(rows[name]) then names[#names + 1] = name end
  end
  return names
end

--- A script's argument for one formulation (a name) or several (a list), as sg.arguments takes it.
function rows.argument(default) return { default, choices = rows.choices } end

--- A contact with the keys of a formulation; unchanged without one. With multipliers penalties only scale equations:
--- they are left to the program unless `chosen`.
function rows.contact(row, contact, chosen)
  for key, value in pairs(row and row.keys or {}) do contact[key] = value end
  if row and row.swapped then contact.slave, contact.master = contact.master, contact.slave end
  if contact.enforcement == "multipliers" and not chosen then
    contact.penalty = nil
    contact.friction = contact.friction and { mu = contact.friction.mu }
  end
  return contact
end

return rows
