-- What holds of each die that is pressed into a symmetric slab in space and dragged over it without friction.

require "check"

--- `o`: places { step = x } along the way; pressed, the step at which it begins; symmetry and balance, tolerances;
--- lateral = false: no force across the way; pitch, first and last step over which oscillations are measured.
return function(study, o)
  check.case("Pz is symmetric about the slab's middle, Px its opposite", function()
    for _, case in ipairs(study.cases) do
      for step, x in pairs(o.places) do check.near(case.x[step], x, 1e-12) end
      local last = case.run.steps
      for step = o.pressed, last do
        local mirrored = last + o.pressed - step
        check.near(case.Pz[step], case.Pz[mirrored], o.symmetry)
        check.near(case.Px[step], -case.Px[mirrored], o.symmetry)
      end
    end
  end)

  check.case("the forces on the die equal those on the bed", function()
    for _, case in ipairs(study.cases) do
      for _, axis in ipairs { ".fx", ".fy", ".fz" } do
        local bed, grip = case.run:column("bed" .. axis), case.run:column("grip" .. axis)
        for step = 1, case.run.steps do
          check.near(bed[step] + grip[step], 0, o.balance)
          if axis == ".fy" and o.lateral == false then check.near(bed[step], 0, o.balance) end
        end
      end
    end
  end)

  check.case("a layer reduces the oscillations to less than a third", function()
    local layer = study.cases["N2-N2.1"]
    check.equal({ layer.first, layer.last }, o.pitch)
    for _, force in ipairs { "dPx", "dPz" } do
      for _, kind in ipairs { "raw_percent", "detrended_percent" } do
        if layer[force][kind] > 33 then error(("%s %s is %g"):format(force, kind, layer[force][kind])) end
      end
    end
  end)
end
