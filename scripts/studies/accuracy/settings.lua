-- Settings that the studies of accuracy compare, by the name that tables and legends show: options of a problem's
-- scene(o). The default gives nothing that the program chooses: controls, thickness degree, penalty, formulation.

local settings = {
  ["default"]             = {},
  ["published"]           = { plain = true, arc = true, thickness_degree = 1, stiffness = 1 },
  ["thickness degree 1"]  = { thickness_degree = 1 },
  ["mortar equal"]        = { contact = { method = "mortar", multipliers = "equal" } },
  ["mortar reduced"]      = { contact = { method = "mortar", multipliers = "reduced" } },
  ["multipliers"]         = { contact = { method = "mortar", enforcement = "multipliers" } },
  ["reduced multipliers"] = { contact = { method = "mortar", multipliers = "reduced", enforcement = "multipliers" } },
  ["half passes"]         = { contact = { method = "half_passes" } },
  ["penalty / 10"]        = { stiffness = 0.1 },
  ["published penalty"]   = { stiffness = 1 },
  ["penalty × 10"]        = { stiffness = 10 },
  ["penalty × 100"]       = { stiffness = 100 },
  ["local layer"]         = { place = "contact" },
  ["layer at the edge"]   = { place = "edge" },
  ["layer knots"]         = { place = "contact", knots = 2 },
  ["following layer"]     = { follow = true },
  ["rigid body"]          = { rigid = true },
  ["whole model"]         = { whole = true },
  ["plane model"]         = { plane = true },
  ["solid model"]         = { solid = true },
  ["longer strip"]        = { long = true },
  ["projected volume"]    = { volumetric = "projected" },
  ["half the steps"]      = { coarser = 2 },
  ["steps × 4"]           = { coarser = 4 },
}

--- The options of a case { order, mesh, setting, coarser, plain }; names of settings can be joined: "rigid body +
--- penalty × 10".
function settings.of(case)
  local o = { order = case.order, mesh = case.mesh, coarser = 1 }
  for name in (case.setting .. " + "):gmatch "(.-) %+ " do
    local setting = settings[name] or error(("there is no setting '%s'"):format(name), 0)
    for key, value in pairs(setting) do o[key] = value end
  end
  o.coarser = o.coarser * (case.coarser or 1)
  o.plain = case.plain or o.plain
  return o
end

--- The contact { slave, master, mu } with the formulation of `o` and, unless it is the default, the penalty
--- `o.stiffness` times the published one.
function settings.contact(o, contact, published)
  local mu = contact.mu
  contact.mu = nil
  for key, value in pairs(o.contact or {}) do contact[key] = value end
  contact.penalty = o.stiffness and o.stiffness * published or nil
  if mu and mu > 0 then contact.friction = { mu = mu, penalty = contact.penalty } end
  return contact
end

--- Number of steps, `o.coarser` times as long.
function settings.steps(o, count) return math.max(1, math.ceil(count / o.coarser - 1e-9)) end

return settings
