-- sg.scenes: models to begin with, each a file below scenes/ that is loaded by its first call and returns a function of
-- the checked arguments. It returns the model, its load path for model:run, and what a closed form predicts, if there
-- is one.

local scenes = {}

for _, name in ipairs { "block", "bumper", "hertz", "ironing", "patch_test", "peeling", "rings" } do
  scenes[name] = function(o) return require("signorini.scene.scenes." .. name)(o) end
end

return scenes
