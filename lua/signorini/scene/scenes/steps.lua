--- The number of steps of at most `length` that cover a distance; rounding error adds none.
return function(distance, length) return math.ceil(distance / length - 1e-9) end
