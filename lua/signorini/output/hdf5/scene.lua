-- What a run's HDF5 file holds of a model: bodies and contacts, and the arrays of a state, each { path, values, kind =,
-- entry = (shape), quantity =, text =, more = (attributes) }.

local core = require "signorini.core"
local lists = require "signorini.call.lists"
local quantities = require "signorini.output.hdf5.quantities"

local scene = {}

--- A name as a part of a path: HDF5 reserves "/" and ".", names in Lua may have any bytes.
function scene.link(name)
  if name == "" or name == "." then return name == "" and "%" or "%2E" end
  return (name:gsub("%%(%x%x)", "%%25%1"):gsub("[/\0]", function(byte) return ("%%%02X"):format(byte:byte()) end))
end

local function group(kind, name) return ("/%s/%s"):format(kind, scene.link(name)) end

-- ── Parts that do not change ─────────────────────────────────────────────────────────────────────────────────────────

local function write_body(file, model, name, set_about)
  local data, path = core.body_data(model, name), group("bodies", name)
  local count, dimension = #data.weights, data.dimension
  file:write(path .. "/points", "number", { count, dimension }, data.points)
  set_about(path .. "/points", "length", "control points of the reference shape")
  file:write(path .. "/weights", "number", { count }, data.weights)
  file:write(path .. "/row_start", "integer", { #data.row_start }, data.row_start)
  file:write(path .. "/row_spaces", "integer", { #data.row_start - 1, dimension - 1 }, data.row_spaces)
  for i, space in ipairs(data.spaces) do
    local place = ("%s/spaces/%d"):format(path, i - 1)
    if space.knots then
      file:write(place, "number", { #space.knots }, space.knots)
      file:set(place, "degree", "integer", space.degree)
    else
      file:write(place .. "/breaks", "number", { #space.breaks }, space.breaks)
      file:write(place .. "/degrees", "integer", { #space.degrees }, space.degrees)
      file:write(place .. "/first", "integer", { #space.first }, space.first)
      file:write(place .. "/extraction", "number", { #space.extraction }, space.extraction)
    end
  end
  file:set(path, "name", "text", name)
  file:set(path, "kind", "text", data.kind)
  file:set(path, "description", "text", tostring(data.body))
  file:set(path, "material", "text", ("%s: E = %s, nu = %s"):format(data.law,
    core.number_text(data.E), core.number_text(data.nu)))
  file:set(path, "thickness_direction", "integer", data.through)
end

--- A contact or a tie with the reference positions of its points.
local function write_faces(file, model, path, name, profile, law, set_about)
  file:make_group(path)
  file:set(path, "name", "text", name)
  for side, place in pairs(core.contact_faces(model, name)) do file:set(path, side, "text", place) end
  for _, key in ipairs(lists.sorted_names(law)) do
    local value = law[key]
    local kind = math.type(value) == "integer" and "integer" or type(value) == "number" and "number" or "text"
    file:set(path, key, kind, kind == "text" and tostring(value) or value)
  end
  for _, key in ipairs { "X", "Y", "Z" } do
    local values = rawget(profile, key)
    if values then
      file:write(("%s/%s"):format(path, key), "number", { #values }, values)
      set_about(("%s/%s"):format(path, key), table.unpack(quantities.of(key)))
    end
  end
end

--- Writes bodies, contacts and ties.
function scene.write(file, model, set_about)
  for _, name in ipairs(model:body_names()) do write_body(file, model, name, set_about) end
  for _, name in ipairs(model:contact_names()) do
    write_faces(file, model, group("contacts", name), name, model:profile(name), model:contact_law(name), set_about)
  end
  for _, name in ipairs(model:tie_names()) do
    write_faces(file, model, group("ties", name), name, model:tie_profile(name), {}, set_about)
  end
end

--- True if the file has the bodies of the model: their control points and weights.
function scene.is_in(file, model)
  return not lists.any(model:body_names(), function(name)
    local data, path = core.body_data(model, name), group("bodies", name)
    return core.pack(file:numbers(path .. "/weights")) ~= core.pack(data.weights)
      or core.pack(file:numbers(path .. "/points")) ~= core.pack(data.points)
  end)
end

-- ── The arrays of a state ────────────────────────────────────────────────────────────────────────────────────────────

--- The displacements of the present state.
function scene.displacements(model)
  return lists.map(model:body_names(), function(name)
    local values, dimension = core.body_displacement(model, name)
    return { group("bodies", name) .. "/displacement", values, kind = "number",
             entry = { #values // dimension, dimension }, quantity = "length",
             text = "displacements of the control points" }
  end)
end

local states = { "open", "stick", "slip", "adhesion", "bonded" }
local number_of_state = {}
for i, name in ipairs(states) do number_of_state[name] = i - 1 end

local function about(key, path, values, entry)
  local quantity, text = table.unpack(quantities.of(key))
  return { ("%s/%s"):format(path, scene.link(key)), values, kind = "number", entry = entry, quantity = quantity,
           text = text }
end

--- Adds the lists of a profile, one value per point, and the numbers of a resultant.
local function add_faces(fields, path, profile, resultant)
  for _, key in ipairs(lists.sorted_names(profile)) do
    local values = profile[key]
    local entry = { #values }
    if key == "state" then
      local numbers = lists.map(values, function(name) return number_of_state[name] end)
      local field = about(key, path, numbers, entry)
      field.kind, field.more = "integer", { states = states }
      fields[#fields + 1] = field
    elseif not key:find "^[XYZ]$" then
      fields[#fields + 1] = about(key, path, values, entry)
    end
  end
  for _, key in ipairs(lists.sorted_names(resultant)) do
    if type(resultant[key]) == "number" then
      fields[#fields + 1] = about(key, path .. "/resultant", { resultant[key] }, {})
    end
  end
end

--- Profiles and resultants of contacts and ties, and energies, of the present state.
function scene.profiles(model)
  local fields = {}
  for _, name in ipairs(model:contact_names()) do
    add_faces(fields, group("contacts", name), model:profile(name), model:contact_resultant(name))
  end
  for _, name in ipairs(model:tie_names()) do
    add_faces(fields, group("ties", name), model:tie_profile(name), model:tie_resultant(name))
  end
  local energies = model:energy()
  for _, key in ipairs(lists.sorted_names(energies)) do
    fields[#fields + 1] = about(key, "/energies", { energies[key] }, {})
  end
  return fields
end

return scene
