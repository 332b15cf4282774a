---@meta signorini
-- Generated from the help pages by scripts/reference; read by editors, not by the program.

---Isogeometric contact mechanics: what `require "signorini"` returns.
---@class sg
---@field csv sg.csv
---@field json sg.json
---@field nurbs sg.nurbs
---@field rigid sg.rigid
---@field scenes sg.scenes
---@field shapes sg.shapes
local sg = {}

---No value is of this class: it marks arguments that a function does not have, such as misspelled ones.
---@class sg.unknown_argument

return sg
