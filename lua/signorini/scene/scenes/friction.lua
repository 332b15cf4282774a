--- The friction of a contact; none if mu is zero.
return function(mu, penalty) return mu > 0 and { mu = mu, penalty = penalty } or nil end
