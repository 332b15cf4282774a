--- "1 case", "2 cases": a number of things.
return function(count, noun)
  return ("%d %s%s"):format(count, noun, count == 1 and "" or "s")
end
