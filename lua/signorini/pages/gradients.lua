-- Pages: derivatives of results.

local t = require "signorini.call.types"

local scene = { "scene", t.callback_of({ { "q", t.map(t.number) } }, t.object "model", t.any, t.or_nil(t.any)),
  [[function of a table of the parameters that returns a model, its stages, and options of model:run. It makes a new
scene in each call, and the same one for the same values; meshes, names, stages and steps must not depend on them]] }
local at = { "at", t.map(t.number, nil, 1), "values of the parameters by name, such as { E = 1, mu = 0.3 }" }
local of = { "of", t.list(t.text, nil, 1), "columns of results that print and csv show", otherwise = "all" }
local scale = { "scale", t.map(t.positive),
  "typical sizes of parameters by name, of which changes are a fraction; needed where a value is 0",
  otherwise = "the values" }
local measure = { "measure", t.callback_of({ { "model", t.object "model" } }, t.map(t.number)),
  "function as the option of model:run, whose results become columns with derivatives",
  otherwise = "that which scene returns" }

local parameter = { "parameter", t.name(function(gradients) return gradients.parameters end), "a parameter" }

return {
  title = "Gradients", word = "derivatives",
  { "sg.gradients", [[Returns the derivatives of all results of a run with respect to parameters of its scene:
constants of materials and contacts, loads, motions, sizes and positions of tools, shapes of bodies. Two models with
each parameter a little above and below its value follow the run increment by increment; the difference of their states
is corrected with the factors of the run until it is exact, and the difference of their results is the derivative. Each
parameter costs less than the run.]],
    named = { scene, at, of, scale, measure },
    more = [[
Derivatives are those of the path as it was solved, with its steps and cuts. States of points (open, stick, slip) change
at kinks of the results; where points do so within the distance of the two models, a relative 3e-5, the derivative is
the mean of those on both sides: `kinks` lists them, and a warning tells if they carry 1 % of the forces. Not with the
options arc_length, errors and tolerance.]],
    returns = t.object "gradients",
    example = [[print(sg.gradients{ scene = press_to, at = { depth = 0.1 }, of = { "grip.fy" } })]] },
  { "gradients", "The result of sg.gradients. print shows the last values, and their change per 1 % of each parameter.",
    fields = {
      { "run", t.object "run", "the run itself, with all its results" },
      { "at", t.map(t.number), "values of the parameters" },
      { "parameters", t.list(t.text), "their names" },
      { "names", t.list(t.text), "the columns that print and csv show" },
      { "results", t.list(t.text), "all columns that have derivatives" },
      { "passes", t.number, "corrections of all neighbors in all steps" },
      { "residual", t.number, [[of the equations of the derivatives, relative to the forces per parameter, the largest
of all steps and parameters: about their relative error]] },
      { "reach", t.map(t.number), [[by parameter, how far slopes hold: the relative change at which, by derivatives of
pressure and friction, points with 1 % of the contact forces open or begin to slip, the least of all steps]] },
      { "kinks", t.list(t.any), [[{ step, parameter, points, share (of the contact forces), contact, X (of the point
with the largest force) } of steps in which points change their state between the two models]] },
      { "warnings", t.list(t.text), "sentences about derivatives that are doubtful" } } },
  { "gradients:column", [[Returns the derivative of a result of the run with respect to a parameter, one value per step.
Counts have no derivative.]],
    arguments = { { "name", t.name(function(gradients) return gradients.results end), "a column of results" },
                  parameter },
    returns = t.numbers(nil, true), example = "gradients:column(\"grip.fy\", \"depth\")" },
  { "gradients:profile", [[Returns the derivative of a contact profile at the end of the run: tables as those of
model:profile, with derivatives in place of numbers.]],
    arguments = { { "contact", t.text, "a contact" }, parameter },
    returns = t.map(t.any), example = "gradients:profile(\"interface\", \"depth\").pressure" },
  { "gradients:energy", "Returns the derivatives of the energies at the end of the run, by the names of model:energy.",
    arguments = { parameter }, returns = t.map(t.number), example = "gradients:energy(\"depth\").stored" },
  { "gradients:csv", "Writes the columns and their derivatives to a CSV file.",
    arguments = { { "file", t.text, "name of the file" } }, example = "gradients:csv \"gradients.csv\"" },
  { "sg.check_gradients", [[Compares derivatives with differences of whole runs at larger distances: secants. Their
difference falls with the square of the distance where results are smooth, and with the distance at kinks; it tells how
far a derivative holds, and whether it is right.]],
    named = { scene, at, of, scale, measure,
      { "by", t.list(t.positive, nil, 1), "distances on both sides, relative to the parameters or their scale",
        default = { 1e-4, 1e-3, 1e-2 } } },
    returns = t.record("rows", t.list(t.any), "by", t.list(t.number), "gradients", t.object "gradients"),
    more = [[
print shows the largest difference over the steps, relative to the largest derivative, for each column, parameter and
distance; nan where the derivative vanishes or a run has failed. The result has gradients, by, and rows: { name,
parameter, by, difference }.]],
    example = [[
print(sg.check_gradients{ scene = press_to, at = { depth = 0.1 }, of = { "grip.fy" }, by = { 1e-4 } })]] },
}
