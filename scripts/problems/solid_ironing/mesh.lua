-- Meshes of block and cylinder ironing, as scripts take them on the command line.

local mesh = {}

--- The elements of a mesh such as "4x4x4/8x4x4": { name, die = {4, 4, 4}, slab = {8, 4, 4} }; nil if the name is not a
--- mesh.
function mesh.read(text)
  local counts = {}
  for i, part in ipairs { text:match "^(%d+)x(%d+)x(%d+)/(%d+)x(%d+)x(%d+)$" } do
    counts[i] = math.tointeger(tonumber(part))
    if counts[i] < 1 then return nil end
  end
  if #counts ~= 6 then return nil end
  return { name = text, die = { table.unpack(counts, 1, 3) }, slab = { table.unpack(counts, 4, 6) } }
end

--- A script's argument that names one mesh, or a list of them, as sg.arguments takes it.
function mesh.argument(default)
  return { default, check = mesh.read, expected = "elements of die and slab per direction such as 4x4x4/8x4x4" }
end

return mesh
