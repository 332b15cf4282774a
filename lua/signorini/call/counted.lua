--- A number with its noun: "1 case", "2 cases".
return function(count, noun)
  return ("%d %s%s"):format(count, noun, count == 1 and "" or "s")
end
