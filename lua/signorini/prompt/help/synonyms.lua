-- Terms of the field and of other programs that have no page of their own: { words, answer, page, … }. words: separated
-- by commas, in lower case; answer: a sentence, for features that are not available with the alternative; pages: names
-- of help pages, listed below the answer.

return {
  -- Boundary conditions and loads
  { "dirichlet, boundary condition, prescribed displacement, essential boundary condition, constraint, clamp, bc",
    "Displacements are prescribed by supports: `fix` sets components to zero, `drive` leaves them to the stages.",
    "support", "stage" },
  { "neumann, natural boundary condition, surface load, distributed load, force",
    "Forces are applied as tractions or pressures on faces, or per volume of bodies.", "load", "stage" },
  { "gravity, body force, weight, self weight, volume force, body load",
    "`force` of a load acts on bodies per reference volume, as in { on = slab, force = {0, -9.81e-3} }.", "load" },
  { "follower load, follower, live load, fluid pressure, pressure load, pressure, hydrostatic pressure, inflation",
    [[`pressure` of a load acts on faces: along the reference normal, or with `follower = true` along the current one,
per current area. Other loads are dead.]], "load" },
  { "point load, concentrated force, nodal force", [[`force` of a load acts on corners, in 3D also on edges per length,
as in { on = slab:corner "north-east", force = {0, -1} }.]], "load" },
  { "spring, foundation, elastic support, robin",
    "`spring` of a support holds faces by springs, with a stiffness per reference area by component.", "support" },
  { "torque, moment load, couple, rolling, pulley, rotating tool, free rigid body, rigid body motion", [[Obstacles turn
by `rotate` of their support, are free by `free` and `angle = "free"`, and loaded by `force` and `moment`. Bodies have
no moment loads; the support of a face that rotates returns its moment.]], "support", "load", "obstacle" },
  { "multi point constraint, mpc, rigid coupling, kinematic coupling, remote displacement", [[A support with `rotate`
couples a face as a rigid body; other multi-point constraints are not available.]], "support" },
  { "pretension, bolt, bolt pretension, preload, pre tension", [[A pretension is a load or a driven displacement of a
first stage, which later stages keep: list it in that stage only. Bolts have no element of their own; an interference of
a head is an `offset` of a contact.]], "stage", "load", "contact" },
  { "initial condition, prestress, residual stress, thermal, temperature", [[Initial stresses and temperatures are not
available. Models start from the stress-free reference shape.]], "sg.model" },
  -- Contact
  { "multipatch, multi patch, several patches, merge, weld, share nodes, interface of patches",
    "`joins` of sg.model make one body of several patches, with one sg.body per patch.", "join", "sg.model" },
  { "tied, bonded, glue, mesh tying", [[`ties` of sg.model make faces move as one, also with meshes that do not match:
one body per patch.]], "tie", "sg.model" },
  { "mortar, segment to segment, node to surface, nts, gpts, contact formulation", [[Contact is Gauss-point-to-surface
with a penalty, or mortar: method = "mortar". Node-to-surface contact is not available.]], "contact" },
  { "lagrange multiplier, augmented lagrangian, uzawa", [[The key `enforcement` of a contact chooses between a penalty
and, in mortar contact, Lagrange multipliers as unknowns of one semi-smooth Newton method.]], "contact" },
  { "interference fit, shrink fit, press fit, overclosure, shim, clearance", [[`overlap = "interference"` of a contact
closes the overlap of the shapes over the first stage in which it is active; `offset` is a shim or a clearance, which
stages change.]], "contact", "stage" },
  { "model change, contact pair removal, birth and death, switch off contact, change friction, friction onset",
    "The key `contacts` of a stage changes friction, penalty, offset and `active` of contacts.", "stage", "contact" },
  { "delamination, cohesive, cohesive zone, cohesive element, czm, fracture, crack, adhesive joint", [[Bonds between
faces break by a cohesive law with the key `cohesive` of a contact; van der Waals forces act with `adhesion`. Cracks
within a body are not available: make it of two bodies with a bonded contact.]], "contact" },
  { "static friction, kinetic friction, stribeck, friction coefficient, rate-dependent friction, slip weakening, "
    .. "anisotropic friction, orthotropic friction, directional friction",
    "mu of `friction` is a number, { static, kinetic, over }, { mu1, mu2 } in two directions, or a function of "
    .. "pressure, slip rate, slip, place and direction.",
    "contact" },
  { "pressure-overclosure, soft contact, exponential contact, asperities, rough surface, winkler",
    "The key `pressure` of a contact is a function of the gap in place of the penalty.", "contact" },
  { "wear, archard, abrasion", [[The key `wear` of a contact is Archard's law; `offset`, which stages change, sets a
depth that is known.]], "contact", "stage" },
  { "self contact, general contact, contact pair",
    'The key `among` of a contact: faces that touch themselves and each other, or "all".', "contact" },
  { "rigid body, rigid wall, analytical rigid surface, indenter, tool", [[Rigid bodies are obstacles, the master of a
contact.]], "obstacle", "sg.rigid.plane", "sg.rigid.cylinder", "sg.rigid.sphere", "sg.rigid.surface" },
  -- Bodies
  { "hyperelasticity, rubber, elastomer, nonlinear elastic, large deformation, finite strain", [[Materials for large
strains are ready laws of rubber, and any law from its energy.]], "sg.neo_hookean", "sg.mooney_rivlin", "sg.yeoh",
    "sg.ogden", "sg.hyperelastic" },
  { "strain energy, energy function, fiber reinforced, anisotropic, orthotropic, user material, umat", [[A function of
the invariants or of the principal stretches defines an elastic law; `fibers` are its directions.]],
    "sg.hyperelastic" },
  { "incompressible, nearly incompressible, incompressibility, hybrid element, volumetric locking", [[nu must be below
0.5; close to it, volumetric = "projected" of sg.body avoids locking, see share/doc/decide/locking.md.]], "sg.body",
    "sg.neo_hookean" },
  { "plasticity, plastic, yield, yield stress, damage, steel", [[Materials are elastic or viscoelastic: plasticity and
damage are not available. Steel below its yield stress is sg.linear_elastic at small rotations.]],
    "sg.linear_elastic", "sg.hyperelastic" },
  { "viscoelasticity, prony series, relaxation, creep, relaxation time", [[A Prony series makes any elastic material
viscoelastic; stages with a `duration` relax.]], "sg.viscoelastic", "stage" },
  { "plane stress, thin plate",
    "The key `kind` of sg.model chooses plane stress, for all bodies of a model.", "sg.model" },
  { "shell, beam, membrane, truss, plate",
    "Structural elements are not available. Bodies are plane, axisymmetric or 3D solids.", "sg.body" },
  { "mesh, meshing, node, element size, mesh refinement", [[The mesh of a body is the knot spans of its NURBS patch:
`elements`, `grading` and `order` of sg.body.]], "sg.body", "patch:refine" },
  { "cad, step file, iges, abaqus, stl, gmsh, import, mesh import, import mesh, inp file, orphan mesh", [[Geometry is
read from NURBS files of G+Smo, GeoPDEs and MFEM; other CAD and mesh files are not supported.]], "sg.nurbs.read" },
  -- Solution
  { "dynamics, dynamic, inertia, transient, explicit", [[Analyses are quasi-static; dynamics is not available. Arc
length follows paths past limit points; model:modes returns free vibrations.]], "model:run", "model:modes" },
  { "vibration, modal, natural frequency, eigenfrequency, eigenvalue, buckling, flutter", [[model:modes returns the free
vibration modes of a state, under load and in contact, and tells whether it is stable.]], "model:modes" },
  { "convergence, diverges, does not converge, not converging", [[A failed run states the reason and possible remedies
in run.failure; sg.robust{} lists the default controls.]], "model:run", "run", "model:diagnose", "sg.robust",
    "sg.convergence_map" },
  { "mesh convergence, convergence study, error estimate, accuracy", [[Compare discretizations by a study, or let
sg.recommend choose one.]], "sg.recommend", "sg.work_precision", "sg.study" },
  { "calibrate, parameter identification, inverse problem, least squares, curve fitting, sensitivity",
    "sg.fit finds parameters from measured data, with intervals; sg.gradients returns derivatives of all results.",
    "sg.fit", "sg.gradients", "sg.optimize" },
  { "optimization, design optimization, shape optimization, minimize",
    "sg.optimize finds the parameters at which a result is least while others stay within limits.", "sg.optimize" },
  { "riks, arc length, snap through, snap back, limit point, continuation",
    "`arc_length = true` of model:run follows the path where steps fail.", "model:run", "model:solve_arc" },
  { "load step, time step, increment, physical time, amplitude, step size, load curve, load history, tabular amplitude",
    [[Targets of a stage are numbers, reached in equal steps, or functions of the fraction of the stage. Stages divide
the load path into steps; the option `step` of model:run controls increments.]], "stage", "model:run" },
  { "restart, resume, checkpoint, load state", [[`checkpoint` and `resume = true` of model:run continue a run;
model:save and sg.load write and read a model.]], "model:run", "model:save", "sg.load" },
  { "progress, verbose, verbosity, quiet, silent, log file, monitor", [[Runs show their progress on standard error
unless the program was started with -q. on_step and on_iteration of model:run report more.]], "model:run",
    "run:attempts", "run:residuals" },
  { "cluster, slurm, sbatch, queue, hpc, job array", [[signorini study.lua --on slurm submits the cases of a study to
Slurm.]], "study:execute", "study:watch", "study:cancel" },
  { "parallel, mpi, cores, gpu, multithreading", [[The options --threads and --jobs of the program set the threads of
assembly and the number of cases of a study solved in parallel; linear = "mumps" factors in parallel under mpirun
(share/doc/develop/mumps.md). GPUs are not supported.]], "model:run",
    "study:execute" },
  -- Results and interfaces
  { "plot, plotting, graph, image, visualization, postprocessing, animation", [[sg.picture draws states, sg.chart
curves, sg.heatmap maps, sg.film animations.]], "sg.picture", "sg.chart", "sg.heatmap", "sg.film" },
  { "export, output, write results, results file", [[Results are written as CSV tables, JSON, VTU files for ParaView,
HDF5 and pictures.]], "run:csv", "run:hdf5", "sg.csv.write", "sg.json.write", "sg.vtu", "sg.pvd", "picture:write",
    "sg.nurbs.write" },
  { "html page, web page, run report, dashboard, share results", [[A report is one HTML page with charts, tables,
failures and the script.]], "study:report", "run:report", "map:report" },
  { "history output, history variable, field output, time history, output request", [[Every run has columns with one
value per step: forces, motions, contact areas and pressures; on_step adds own ones. `states` of model:run stores states
for pictures.]], "run:column", "run:csv", "model:run" },
  { "reaction force, contact force, contact pressure, contact stress", [[Forces and pressures are results of the model,
and columns of a run.]], "model:reaction", "model:contact_resultant", "model:profile", "run:column" },
  { "python, numpy, matlab, julia, api", [[Scripts are in Lua only. CSV, JSON, HDF5 and VTU files of results can be read
in Python and other programs.]], "run:csv", "run:hdf5", "sg.json.write", "sg.vtu" },
  { "editor, ide, vscode, vs code, neovim, helix, language server, autocomplete, linter", [[Editors with a Lua language
server complete and check scripts by the settings that signorini --new writes: share/doc/use/editor.md.]], "sg.help" },
  { "gui, graphical interface", [[A graphical interface is not available: use scripts or the prompt, and pictures or
ParaView.]], "sg.picture", "sg.vtu" },
}
