-- Checks of generated scenes by other means than the program's: overlaps at the start by brute force, resultants of
-- loads, pressures without tension, inverted linear bodies, contacts given twice, constants far from usual ones.

local geometry = require "robustness.geometry"

local oracles = {}

function oracles.has_warning(warnings, ...)
  for _, text in ipairs(warnings) do
    local all = true
    for _, part in ipairs{ ... } do all = all and text:find(part, 1, true) ~= nil end
    if all then return true end
  end
  return false
end
local has_warning = oracles.has_warning

-- ── Overlap at the start ─────────────────────────────────────────────────────────────────────────────────────────────

-- The program warns where closing an overlap strains a body by 0.1 % and refuses from 20 % of the mean thickness of
-- the thinner body on. It does not warn where a body is free to move out, which this takes from the supports alone:
-- only overlaps of bodies that are held in all directions must be warnings. Depths and thicknesses of samples differ
-- from those of contact points: what is between is not judged.
local worth_a_warning, refused = 0.05, 0.4

--- Calls visit(reference) with all faces of a face or of a list of them.
local function each_face(faces, visit)
  if faces.body then return visit(faces) end
  for _, one in ipairs(faces) do if not one.obstacle then each_face(one, visit) end end
end

--- Whether supports hold the bodies of faces, and what is joined with them, against translations in all directions.
local function held(scene, faces)
  local bodies, components = {}, ""
  local function add(face) bodies[face.body] = true end
  each_face(faces, add)
  for _, seams in ipairs{ scene.joins, scene.ties, scene.joins, scene.ties } do
    for _, seam in pairs(seams) do
      local joined = false
      each_face({ seam[1], seam[2] }, function(face) joined = joined or bodies[face.body] end)
      if joined then each_face({ seam[1], seam[2] }, add) end
    end
  end
  for _, support in pairs(scene.supports) do
    each_face(support.on, function(face)
      if bodies[face.body] then
        components = components .. (support.fix or "") .. (support.drive or "") .. (support.spring and "xyz" or "")
      end
    end)
  end
  for component in (scene.space and "xyz" or scene.kind == "axisymmetric" and "y" or "xy"):gmatch "." do
    if not components:find(component, 1, true) then return false end
  end
  return true
end

--- A contact that lies so deep in its master before the first step that it must be a warning or an error. Returns the
--- contact, the depth, and what it must be; nil if there is none.
local function deep_contact(scene)
  for _, contact in ipairs(scene.contacts) do
    local law = contact.law
    if law.active == false or law.where or contact.slave[1].obstacle then goto next end
    local slave = geometry.faces(scene, contact.slave, scene.space and 5 or 17)
    if not slave then goto next end
    local allowed, thick = math.max(0, -(law.offset or 0)), geometry.thickness(slave)
    if contact.master[1].obstacle then
      local obstacle
      for _, one in ipairs(scene.obstacles) do
        if one.name == contact.master[1].obstacle then obstacle = one end
      end
      local depth = geometry.depth_in(obstacle, slave)
      if depth and depth - allowed > (law.overlap and 2 or refused) * thick then return contact, depth, "error" end
    else
      local master = geometry.faces(scene, contact.master, scene.space and 12 or 200)
      if not master then goto next end
      thick = math.max(thick, geometry.thickness(master))
      local depth = geometry.depth(slave, master)
      local must = depth - allowed > (law.overlap and 2 or refused) * thick and "error"
        or depth - allowed > (law.overlap and 2 or worth_a_warning) * thick and held(scene, contact.slave)
          and held(scene, contact.master) and "warning" or nil
      if must then return contact, depth, must end
    end
    ::next::
  end
end

--- A deep overlap of a scene that the program has not refused, without a warning.
local function unsaid_overlap(scene, warnings)
  local contact, depth, must = deep_contact(scene)
  if not contact then return nil end
  if must == "warning" and has_warning(warnings, "contacts.", "before the first step") then return nil end
  if has_warning(warnings, "may enter the master between them unseen") then return nil end
  return ("contact %s begins %.3g deep in its master: no %s"):format(contact.name, depth, must)
end

-- ── Loads ────────────────────────────────────────────────────────────────────────────────────────────────────────────

--- ∫ t dA over the faces of a dead load of a scene, in its units: samples' areas times the value at the last stage.
local function expected_load(scene, load)
  if load.follower or not (load.kind == "traction" or load.kind == "pressure") then return nil end
  local factor = load.constant and 1 or 0
  for _, stage in ipairs(scene.stages) do
    factor = stage.loads.push or factor
  end
  local sum, seen = { 0, 0, 0 }, {}
  for _, reference in ipairs(load.on) do
    local key = reference.body .. reference.face
    local faces = not seen[key] and geometry.faces(scene, { reference }, scene.space and 48 or 200)
    seen[key] = true
    if faces == nil then return nil end
    for _, sample in ipairs(faces or {}) do
      local area = sample.area * (1 + (load.slope or 0) * sample.middle[1])
      if scene.kind == "axisymmetric" then area = area * 2 * math.pi * sample.middle[1] end
      for i = 1, #sample.x do
        local t = load.kind == "traction" and load.value[i] or -load.value * sample.normal[i]
        sum[i] = sum[i] + factor * area * t
      end
    end
  end
  if scene.kind == "axisymmetric" then sum[1] = 0 end
  return sum
end

--- A load whose resultant is not that of its faces, unless a warning says that Gauss points miss the geometry; the run
--- has completed.
local function wrong_load(model, scene, frame, warnings)
  local load = scene.loads.push
  if has_warning(warnings, "Gauss points find") then return nil end
  local expected = load and expected_load(scene, load)
  if not expected then return nil end
  local force, size = model:reaction(frame:name "push"), scene.space and 3 or 2
  local difference, most = 0, 0
  for i = 1, size do
    local sum = 0
    for j = 1, size do sum = sum + frame.matrix[j][i] * force[j] / frame:force() end
    if scene.kind ~= "axisymmetric" or i > 1 then difference = math.max(difference, math.abs(sum - expected[i])) end
    most = math.max(most, math.abs(expected[i]))
  end
  local size_of_value = type(load.value) == "table" and math.abs(load.value[size]) or math.abs(load.value)
  if difference > 0.02 * most + 1e-9 * size_of_value then
    return ("the load is off by %.3g of %.3g"):format(difference, most)
  end
end

-- ── Pressures ────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A contact without adhesion that pulls, unless the tolerance or a warning about rounding errors excuses it.
local function tension(model, scene, frame, warnings)
  if (scene.options.newton and scene.options.newton.tolerance or 0) > 1e-6 then return nil end
  if has_warning(warnings, "rounding errors of forces") then return nil end
  local stiffest, speck = 0, 1e-9 * frame.length ^ (scene.space and 2 or 1) -- no force to speak of
  for _, body in ipairs(scene.bodies) do stiffest = math.max(stiffest, body.material.E * frame.stress) end
  for _, contact in ipairs(scene.contacts) do
    local law = contact.law
    if law.adhesion or law.cohesive then goto next end
    local half = (law.formulation or ""):find("half", 1, true)
    for _, name in ipairs{ frame:name(contact.name), half and frame:name(contact.name) .. ".master" or nil } do
      local least, most, profile = 0, 0, model:profile(name)
      for i, p in ipairs(profile.pressure) do
        if profile.area[i] > speck then least, most = math.min(least, p), math.max(most, p) end
      end
      if least < -1e-9 * (most + stiffest) then
        return ("contact %s pulls by %.3g of %.3g"):format(contact.name, least, most)
      end
    end
    ::next::
  end
end

-- ── Warnings ─────────────────────────────────────────────────────────────────────────────────────────────────────────

--- A linear elastic body that is inverted at a sample although no warning says so.
local function unsaid_inversion(model, scene, frame, warnings)
  for _, body in ipairs(scene.bodies) do
    if body.patch and body.material.law == "linear_elastic" and not scene.space then
      local patch = frame:patch(body.patch, body.name)
      for i = 1, 5 do
        for j = 1, 5 do
          local xi, F = geometry.parameters(patch, { (i - 0.5) / 5, (j - 0.5) / 5 }), {}
          for _, field in ipairs{ "F11", "F12", "F21", "F22" } do
            F[field] = model:sample(frame:name(body.name), field, xi)
          end
          local J = F.F11 * F.F22 - F.F12 * F.F21
          if J < -0.5 and not has_warning(warnings, frame:name(body.name), "linear elastic body turns") then
            return ("linear elastic body %s is inverted (J = %.3g) without a warning"):format(body.name, J)
          end
        end
      end
    end
  end
end

local function same(a, b)
  if #a ~= #b then return false end
  for i = 1, #a do
    if a[i].body ~= b[i].body or a[i].face ~= b[i].face or a[i].obstacle ~= b[i].obstacle then return false end
  end
  return true
end

--- Two contacts of the same faces without a warning.
local function unsaid_twins(scene, warnings)
  for i, one in ipairs(scene.contacts) do
    for k = i + 1, #scene.contacts do
      local other = scene.contacts[k]
      local alike = same(one.slave, other.slave) and same(one.master, other.master)
      local a, b = one.law, other.law
      local comparable = not (a.where or b.where or a.adhesion or b.adhesion or a.cohesive or b.cohesive
        or a.active == false or b.active == false) and a.formulation == b.formulation
      if alike and comparable and not has_warning(warnings, "act between the same faces") then
        return ("contacts %s and %s are the same without a warning"):format(one.name, other.name)
      end
    end
  end
end

--- A constant far from any that is usual, or a load that acts in full from the first step, without a warning.
local function unsaid_constant(scene, frame, warnings)
  for _, contact in ipairs(scene.contacts) do
    if contact.law.mu >= 5 and not contact.law.adhesion and not has_warning(warnings, "friction.mu") then
      return ("mu = %g without a warning"):format(contact.law.mu)
    end
  end
  for _, body in ipairs(scene.bodies) do
    local material = body.material
    local locks = material.nu >= 0.4999 and not body.volumetric and scene.kind ~= "plane_stress"
    if locks and material.law ~= "fibers" and not material.unstable
      and not has_warning(warnings, "bodies." .. frame:name(body.name), "Poisson's ratio") then
      return ("nu = %g of body %s without a warning"):format(material.nu, body.name)
    end
  end
  local newton = scene.options.newton
  if newton and (newton.tolerance or 0) >= 0.5 and not has_warning(warnings, "newton.tolerance") then
    return "a tolerance without a warning"
  end
  for name, load in pairs(scene.loads) do
    if load.constant and not has_warning(warnings, "no stage changes", frame:name(name)) then
      return ("load %s acts in full without a warning"):format(name)
    end
  end
end

-- ── All of them ──────────────────────────────────────────────────────────────────────────────────────────────────────

--- What is wrong with a run that was not refused: a list of texts.
function oracles.flaws(model, run, scene, frame)
  local found, warnings = {}, run.warnings
  found[#found + 1] = unsaid_overlap(scene, warnings)
  found[#found + 1] = unsaid_twins(scene, warnings)
  found[#found + 1] = unsaid_inversion(model, scene, frame, warnings)
  found[#found + 1] = unsaid_constant(scene, frame, warnings)
  found[#found + 1] = tension(model, scene, frame, warnings)
  found[#found + 1] = run.reason == "completed" and wrong_load(model, scene, frame, warnings) or nil
  return found
end

return oracles
