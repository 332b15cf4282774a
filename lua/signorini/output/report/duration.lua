--- Seconds in the unit that readers expect.
return function(seconds)
  if seconds < 60 then return ("%.3g s"):format(seconds) end
  if seconds < 3600 then return ("%d min %02d s"):format(seconds // 60, math.floor(seconds % 60)) end
  return ("%d h %02d min"):format(seconds // 3600, math.floor(seconds % 3600 / 60))
end
