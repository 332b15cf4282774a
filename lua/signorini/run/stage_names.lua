-- The names of the stages of a run's rows, from row number `first` on.

return function(run, first)
  local names, index, last = {}, 1, run.stages[1] and run.stages[1].steps or 0
  for row = 1, run.rows do
    while index < #run.stages and math.ceil(run.step_column[row]) > last do
      index = index + 1
      last = last + run.stages[index].steps
    end
    if row >= first then names[#names + 1] = run.stages[index].name end
  end
  return names
end
