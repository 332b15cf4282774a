-- Writes the samples of this folder: a file of each kind that the program writes and reads again. They are kept, so
-- that compatibility_test.lua shows that the present program reads those of the last format. Argument: the folder of
-- the samples. A new format gets new samples, next to those of the last one.

local sg = require "signorini"
local scenes = require "samples.scenes"

local folder = arg[1]
sg.mkdir(folder)

for name, scene in pairs{ run = scenes.plane, disc = scenes.disc } do
  local steps = 0
  pcall(function()
    scene():run(scenes.path, { checkpoint = ("%s/%s.sgn"):format(folder, name), on_step = function()
      steps = steps + 1
      if steps == 3 then error "interrupted" end
    end })
  end)
end

local space = scenes.space()
space:run{ { steps = 1, tool = { -0.2 } } }
space:save(folder .. "/space.sgn")

scenes.study(folder .. "/study"):execute{ jobs = 1 }
