-- Pages: materials.

local t = require "signorini.call.types"

local thesis = "V. Agrawal, thesis, IIT Guwahati, 2020"

local cure = "0.5 is incompressible, which a displacement formulation cannot represent: use 0.49"
local constants = {
  { "E", t.positive, "Young's modulus", unit = "force per area" },
  { "nu", { kind = "number", above = -1, below = 0.5, cure = cure }, "Poisson's ratio" },
}
constants.hints = { poisson = "Poisson's ratio is nu", young = "Young's modulus is E" }
local in_2d = "In 2D the kind of the model decides: plane strain, plane stress or axisymmetric."
local bulk = { "K", t.positive, "bulk modulus", unit = "force per area" }
local function modulus(name, text, default)
  return { name, t.number, text, unit = "force per area", default = default }
end
local isochoric = [[I1' = J^(-2/3) I1 and I2' = J^(-4/3) I2 measure the change of shape, J that of volume. For rubber
K is 1000 to 5000 times the shear modulus, for which elements need degree 2 or more in all directions so as not to lock
(nu near 0.5). ]]
local sources = [[. Change of volume: J. C. Simo, C. Miehe, Comput. Methods Appl. Mech. Eng. 98, 1992.]]

--- As many exponents as moduli.
local ogden = {
  { "mu", t.list(t.number, nil, 1), "one modulus per term", unit = "force per area" },
  { "alpha", t.list(t.number, nil, 1), "one exponent per term, none of them zero" },
  bulk,
}
ogden.conflict = function(values)
  if #values.mu ~= #values.alpha then
    return ("mu and alpha must have one value per term, got %d and %d"):format(#values.mu, #values.alpha)
  end
  for i, alpha in ipairs(values.alpha) do
    if alpha == 0 then return ("alpha[%d] must not be zero"):format(i) end
  end
end

local law = {
  { "energy", { kind = "function", cure = "write energy = function(I1, I2, J) return … end" },
    "W(I1, I2, J) per volume without strain, and with fibers W(I1, I2, J, I4, …)", optional = true },
  { "stretches", { kind = "function", cure = "write stretches = function(l1, l2, l3) return … end" },
    "instead of energy: W of the principal stretches, in any order of which it must be the same", optional = true },
  { "fibers", t.list(t.point, nil, 1), [[directions of fibers without strain, up to four, of any length: each adds an
argument I4 = |F a|^2, the square of its stretch. {x, y} or {x, y, z}; in axisymmetric models {r, y} or {r, y, around},
without twist]], optional = true },
}
law.conflict = function(values)
  if (values.energy == nil) == (values.stretches == nil) then
    return "it must have one of energy = function(I1, I2, J) … end and stretches = function(l1, l2, l3) … end"
  end
end

return {
  title = "Materials, bodies, obstacles", word = "bodies",
  { "sg.neo_hookean",
    "Returns a compressible neo-Hookean material, W = lambda/2 (ln J)^2 + mu/2 (tr C - 3) - mu ln J. " .. in_2d,
    named = constants,
    more = "Source: (3.29) of " .. thesis .. ".",
    returns = t.object "material", example = "sg.neo_hookean{ E = 1, nu = 0.3 }" },
  { "sg.linear_elastic", [[Returns a linear elastic material (Hooke's law of small strains), sigma = lambda tr(eps) I +
2 mu eps; contact still follows the deformed surface. ]] .. in_2d,
    named = constants,
    more = "Source: linear elasticity; its use: share/doc/reference/theory.md, Bodies.",
    returns = t.object "material", example = "sg.linear_elastic{ E = 1, nu = 0.3 }" },
  { "sg.mooney_rivlin",
    "Returns a Mooney-Rivlin material, W = c10 (I1' - 3) + c01 (I2' - 3) + K/4 (J^2 - 1 - 2 ln J). " .. in_2d,
    named = { modulus("c10", "modulus of I1'"), modulus("c01", "modulus of I2'"), bulk },
    more = isochoric .. [[The shear modulus is 2 (c10 + c01).
Source: M. Mooney, J. Appl. Phys. 11, 1940; R. S. Rivlin, Phil. Trans. R. Soc. A 241, 1948]] .. sources,
    returns = t.object "material", example = "sg.mooney_rivlin{ c10 = 0.4, c01 = 0.1, K = 50 }" },
  { "sg.yeoh", [[Returns a Yeoh material, W = c10 (I1' - 3) + c20 (I1' - 3)^2 + c30 (I1' - 3)^3 + K/4 (J^2 - 1 - 2 ln
J), whose stiffness depends on the stretch. ]] .. in_2d,
    named = { modulus("c10", "half of the shear modulus"), modulus("c20", "second modulus, often negative", 0),
              modulus("c30", "third modulus", 0), bulk },
    more = isochoric .. [[Without c20 and c30 it is neo-Hookean.
Source: O. H. Yeoh, Rubber Chem. Technol. 66, 1993]] .. sources,
    returns = t.object "material", example = "sg.yeoh{ c10 = 0.5, c20 = -0.01, c30 = 0.001, K = 50 }" },
  { "sg.ogden", [[Returns an Ogden material, the sum of mu/alpha (l1'^alpha + l2'^alpha + l3'^alpha - 3) over its terms
and K/4 (J^2 - 1 - 2 ln J), with the principal stretches l' = J^(-1/3) l. ]] .. in_2d,
    named = ogden,
    more = [[The shear modulus is half of the sum of mu alpha; some programs have 2 mu/alpha^2 in place of mu/alpha.
Source: R. W. Ogden, Proc. R. Soc. A 326, 1972]] .. sources,
    returns = t.object "material", example = "sg.ogden{ mu = {0.63, 0.0012, -0.01}, alpha = {1.3, 5, -2}, K = 20 }" },
  { "sg.saint_venant_kirchhoff", [[Returns a Saint Venant-Kirchhoff material, W = lambda/2 (tr E)^2 + mu tr E^2 with
Green's strain E: Hooke's law for large rotations and small strains. It softens under compression and is unstable
there. ]] .. in_2d,
    named = constants,
    more = "Source: P. Wriggers, Nonlinear Finite Element Methods, Springer, 2008.",
    returns = t.object "material", example = "sg.saint_venant_kirchhoff{ E = 1, nu = 0.3 }" },
  { "sg.hyperelastic", [[Returns an elastic material from its energy per undeformed volume: a function that is called
once with symbols for the invariants or for the principal stretches, to read its formula. ]] .. in_2d,
    named = law,
    more = [[I1 = tr C and I2 = (I1^2 - tr C^2)/2 are those of C = F^T F, which contain the change of volume J = det F;
those of the change of shape alone are J^(-2/3) * I1 and J^(-4/3) * I2. A formula has + - * / ^ and the functions in
help "formulas"; ==, < and > of symbols are errors, but == of a symbol and a number is false and a symbol counts as
true, which Lua does not report: write no if. The energy must have zero stress and positive moduli without strain. A
run warns where the law becomes unstable (share/doc/reference/theory.md). Checkpoints and studies hold the formula.]],
    returns = t.object "material", example = { [[
sg.hyperelastic{ energy = function(I1, I2, J)
  return 0.2 * (I1 - 3) - 0.4 * sg.log(J) + 0.5 * sg.log(J)^2
end }]], [[
sg.hyperelastic{ stretches = function(l1, l2, l3)
  local J = l1 * l2 * l3
  return 0.1 * (l1^3 + l2^3 + l3^3 - 3) - 0.3 * sg.log(J) + (J - 1)^2
end }]], [[
sg.hyperelastic{ fibers = { {1, 0} }, energy = function(I1, I2, J, I4)
  return 0.2 * (I1 - 3) - 0.4 * sg.log(J) + 0.5 * sg.log(J)^2 + 0.3 * (sg.exp((I4 - 1)^2) - 1)
end }]] } },
  { "sg.viscoelastic", [[Returns a viscoelastic material: an elastic one, whose constants are those of fast loading, and
the fractions of its stress that relax with time. Only stages with a duration relax. ]] .. in_2d,
    named = {
      { "law", t.object "material", "the elastic material, of any kind" },
      { "g", t.list(t.positive, nil, 1), "fraction of the stress that relaxes, one per term; their sum is below 1" },
      { "tau", t.list(t.positive, nil, 1), "relaxation time, one per term", unit = "time" },
      { "relaxes", t.choice { "shape", "all" }, [[what relaxes: the stress of the change of shape, at constant bulk
modulus, or all stress, at constant Poisson's ratio]], default = "shape" },
      conflict = function(values)
        if #values.g ~= #values.tau then
          return ("g and tau must have one value per term, got %d and %d"):format(#values.g, #values.tau)
        end
      end,
    },
    more = [[A held strain relaxes to G(t)/G(0) = 1 - sum of g (1 - exp(-t/tau)), the Prony series of Abaqus, Ansys and
others. At large strains the overstresses are second Piola-Kirchhoff stresses; their work is the column viscous of
model:energy(). A step of any duration is stable; its error is of second order in the duration relative to tau, and zero
where the stress of the elastic law changes in proportion to time. Moduli that a relaxation test gives are divided by
their sum, the one at once.
Source: J. C. Simo, Comput. Methods Appl. Mech. Eng. 60, 1987; G. A. Holzapfel, Int. J. Numer. Methods Eng. 39, 1996;
theory: share/doc/reference/theory.md, Bodies.]],
    returns = t.object "material", example = [[
rubber = sg.viscoelastic{ law = sg.neo_hookean{ E = 1, nu = 0.49 }, g = {0.3, 0.2}, tau = {0.1, 10} }]] },
  { "material", [[A material; print(material) shows law and constants. For a law from an energy E and nu are those of
small strains, with fibers on average over all directions.]] },
}
