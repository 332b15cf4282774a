# GetFEM 5.4.2 (Debian 12, python3-getfem): block ironing in space without friction, the scene of
# scripts/problems/block_ironing3d.lua: a cube of edge 4, E = 10, is pressed by 1 into a slab of 20 x 10 x 10, E = 1,
# and dragged 12.5 along; neo-Hookean, nu = 0.3. Q2 displacements, Q1 multipliers, augmented Lagrangian, raytracing.
# Run: /usr/bin/python3.11 block_ironing3d.py <refinement> <steps of the slide> [slave = block: or slab]
# Prints one line: RESULT name unknowns iterations processor_seconds Rz oscillation%
import sys
import time
import numpy as np
import getfem as gf

began = time.process_time()
fine, slide = int(sys.argv[1]), int(sys.argv[2])
slave = sys.argv[3] if len(sys.argv) > 3 else "block"
gf.util_trace_level(0)


def cube(x, y, z):
    return gf.Mesh("cartesian", *(np.linspace(low, high, fine * count + 1) for low, high, count in (x, y, z)))


block, slab = cube((1.75, 5.75, 4), (3, 7, 4), (10, 14, 4)), cube((0, 20, 8), (0, 10, 4), (0, 10, 4))
CONTACT, HELD = 1, 2


def mark(mesh, region, height):
    chosen = [(c, f) for c, f in mesh.outer_faces().T
              if np.allclose(mesh.pts(mesh.pid_in_faces(np.array([[c], [f]])))[2], height)]
    mesh.set_region(region, np.array(chosen).T)


for mesh, region, height in ((block, CONTACT, 10), (block, HELD, 14), (slab, CONTACT, 10), (slab, HELD, 0)):
    mark(mesh, region, height)
model, spaces, methods = gf.Model("real"), {}, {}
for name, mesh, E in (("b", block, 10.0), ("s", slab, 1.0)):
    spaces[name] = gf.MeshFem(mesh, 3)
    spaces[name].set_fem(gf.Fem("FEM_QK(3,2)"))
    methods[name] = gf.MeshIm(mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(3,5)"))
    model.add_fem_variable("u" + name, spaces[name])
    model.add_initialized_data("l" + name, [E * 0.3 / 1.3 / 0.4])
    model.add_initialized_data("m" + name, [E / 2.6])
    model.add_macro("F" + name, f"(Id(3)+Grad_u{name})")
    model.add_nonlinear_term(methods[name], f"(m{name}*(F{name}-Inv(F{name})')+l{name}*log(Det(F{name}))"
                                            f"*Inv(F{name})'):Grad_Test_u{name}")
model.add_initialized_data("dd", [0.0, 0.0, 0.0])
model.add_Dirichlet_condition_with_simplification("ub", HELD, "dd")
model.add_Dirichlet_condition_with_simplification("us", HELD)
model.add_initialized_data("r", [10.0])
brick = model.add_integral_large_sliding_contact_brick_raytracing("r", 1.5)
first, second, mesh = ("b", "s", block) if slave == "block" else ("s", "b", slab)
multipliers = gf.MeshFem(mesh, 3)
multipliers.set_fem(gf.Fem("FEM_QK(3,1)"))
model.add_filtered_fem_variable("lm", multipliers, CONTACT)
model.add_slave_contact_boundary_to_large_sliding_contact_brick(brick, methods[first], CONTACT, "u" + first, "lm")
model.add_master_contact_boundary_to_large_sliding_contact_brick(brick, methods[second], CONTACT, "u" + second)

end, now, step, iterations, history, variables = 1 + slide / 10, 0.0, 0.1, 0, [], ["ub", "us", "lm"]
while now < end - 1e-9:
    target = min(now + step, end)
    model.set_variable("dd", [12.5 * max(0, target - 1) / (end - 1), 0.0, -min(1, target)])
    old = [model.variable(v).copy() for v in variables]
    try:
        count, converged = model.solve("max_res", 1e-6, "max_iter", 25, "lsolver", "mumps", "lsearch", "simplest",
                                       "alpha min", 0.8)
    except RuntimeError:
        count, converged = 25, 0
    iterations += count
    if not converged or not np.isfinite(model.variable("us")).all():
        for v, value in zip(variables, old):
            model.set_variable(v, value)
        step /= 2
        if step < 2e-3:
            sys.exit("no convergence at %.3f of %.1f" % (now, end))
        continue
    now, step = target, min(0.1, step * 1.5)
    history.append([now, abs(gf.asm("generic", methods[first], 0, "lm", CONTACT, model)[2])])

h = np.array(history)
part = h[(h[:, 0] > 1 + 0.15 * (end - 1)) & (h[:, 0] < 1 + 0.85 * (end - 1) + 1e-9)]
rest = part[:, 1] - np.polyval(np.polyfit(part[:, 0], part[:, 1], 2), part[:, 0])
print(f"RESULT Q2/Q1_{fine} {model.nbdof()} {iterations} {time.process_time() - began:.2f} {part[:, 1].mean():.5f} "
      f"{100 * np.ptp(rest) / part[:, 1].mean():.3f}")
