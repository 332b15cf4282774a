-- How often layers have followed the contact (adapt.lua) in the runs of a model: a run whose model has other control
-- points now cannot be written with those of its states.

local layer_moves = {}

local by_model = setmetatable({}, { __mode = "k" })
local at_run = setmetatable({}, { __mode = "k" }) -- when the run was made

--- Counts a move of a model's layers.
function layer_moves.count(model) by_model[model] = (by_model[model] or 0) + 1 end

--- Remembers the present state for a run of the model.
function layer_moves.begin(run, model) at_run[run] = by_model[model] or 0 end

--- True if layers have moved since the run was made.
function layer_moves.since(run, model) return (by_model[model] or 0) ~= at_run[run] end

return layer_moves
