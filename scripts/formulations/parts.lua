-- What compare.lua takes from other scripts: by name, the script, the words it is called with, and rows(study), the
-- rows of its table, made of what the script returns. Those of parts.joined have one row for each of five
-- formulations, and are columns of one table. Texts of several numbers: "a / b".

local formulations = require "formulations.rows"

local names = "gpts,equal,reduced,equal-multipliers,half-passes"
local compared = {}
for name in names:gmatch "[^,]+" do compared[#compared + 1] = formulations[name] end

--- Numbers, times a factor, as a text; differences at the level of rounding are 0, nil is a failed run.
local function text(factor, ...)
  local list = table.pack(...)
  for i = 1, list.n do
    local value = list[i]
    list[i] = value and (math.abs(value) < 1e-9 and "0" or ("%.2g"):format(factor * value)) or "fails"
  end
  return table.concat(list, " / ")
end

--- One row per formulation: its label, and cells(formulation).
local function rows_of(cells)
  local rows = {}
  for i, formulation in ipairs(compared) do rows[i] = { formulation.label, table.unpack(cells(formulation)) } end
  return rows
end

local parts = { joined = { "patch", "swapped", "hold", "slip" }, names = { "patch", "swapped", "hold", "slip", "die" } }

parts.patch = {
  script = "formulations/uniform_pressure", words = "dimensions=2 orders=N2 points=9 skews=0 formulations=" .. names,
  columns = { "patch test: pressure (%), with 3 / 9 points" },
  rows = function(study)
    return rows_of(function(formulation)
      for _, one in ipairs(study.series) do -- the coarse block is the slave
        if one.formulation == formulation and one.slave == "lower" then
          return { text(100, one[1].error, one[#one].error) }
        end
      end
    end)
  end,
}

parts.swapped = {
  script = "formulations/swapped_faces", words = "orders=N2,N2-N2.2 meshes=m1,m2,m3 formulations=" .. names,
  columns = { "slave and master swapped: drag (%), N2 m1 / m2 / m3", "N2-N2.2" },
  rows = function(study)
    return rows_of(function(formulation)
      local cells = {}
      for i, order in ipairs{ "N2", "N2-N2.2" } do
        local function drag(mesh) return study.cases[("%s %s %s"):format(order, mesh, formulation.name)].drag end
        cells[i] = text(100, drag "m1", drag "m2", drag "m3")
      end
      return cells
    end)
  end,
}

parts.hold = {
  script = "formulations/load_and_hold", words = "orders=N2-N2.2 steps=25,50 formulations=" .. names,
  columns = { "held: force (%), first step / others", "halved steps: drag (%)" },
  rows = function(study)
    return rows_of(function(formulation)
      local case = study.series["N2-N2.2 " .. formulation.name][1]
      return { text(100, case.first, case.later), text(100, case.change) }
    end)
  end,
}

parts.slip = {
  script = "formulations/partial_slip", words = "orders=N2-N2.2 counts=8 formulations=" .. names,
  columns = { "partial slip: traction (%)", "slip of sticking points (10⁻⁶ a)" },
  rows = function(study)
    return rows_of(function(formulation)
      local state = study.cases["N2-N2.2 8 " .. formulation.name].states[2] or {}
      return { text(100, state.error), state.mean_slip and ("%.2g"):format(1e6 * state.mean_slip) or "fails" }
    end)
  end,
}

parts.die = {
  script = "formulations/stiff_die", words = "slabs=24,32 dies=9,18,36",
  columns = { "slab", "slave", "die of 9 / 18 / 36 elements: iterations per step", "cuts", "drag (N/mm)",
              "its oscillation (%)" },
  rows = function(study)
    local list, at = {}, {}
    for _, row in ipairs(study.rows) do
      local slab, slave = ("%d × %d"):format(row[2], row[2] // 4), row[4]
      if not at[slab .. slave] then
        at[slab .. slave] = { {}, {}, {}, {} }
        list[#list + 1] = { slab, slave, at[slab .. slave] }
      end
      local drag, oscillation = row[8] and ("%.5f"):format(row[8]), row[10] and ("%.2f"):format(row[10])
      local cells = { ("%.1f"):format(row[5]), ("%d"):format(row[6]), drag or "fails", oscillation or "fails" }
      for i, cell in ipairs(cells) do
        table.insert(at[slab .. slave][i], cell)
      end
    end
    for _, row in ipairs(list) do
      for i, cells in ipairs(table.remove(row)) do row[2 + i] = table.concat(cells, " / ") end
    end
    return list
  end,
}

return parts
