-- Cases that may run in parallel, and those that must run alone, from a list of positions.

return function(study, list)
  local together, alone = {}, {}
  for _, i in ipairs(list) do
    local asks = study.sequential
    if type(asks) == "function" then asks = asks(study.cases[i].case) end
    table.insert(asks and alone or together, i)
  end
  return together, alone
end
