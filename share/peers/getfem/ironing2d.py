# GetFEM 5.4.2 (Debian 12, python3-getfem): frictional ironing in the plane, the scene of scripts/peers.lua. Half ring
# 0.3/0.5, E = 1000, on a slab 3 x 1, E = 1, neo-Hookean, nu = 0.3, mu = 0.3; 0.075 down in 10 steps, then 2.0 along in
# 100. Q2 displacements, Q1 multipliers on the die, augmented Lagrangian, brick of large sliding contact (raytracing).
# Run: /usr/bin/python3.11 ironing2d.py <elements along the slab> [steps of the slide = 100] [augmentation = 10]
# Prints one line: RESULT name unknowns iterations processor_seconds Px Py oscillation_x% oscillation_y%
import sys
import time
import numpy as np
import getfem as gf

began = time.process_time()
nx, slide = int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 100
augmentation = float(sys.argv[3]) if len(sys.argv) > 3 else 10.0
gf.util_trace_level(0)
ny, nc, nr = max(4, nx // 4), max(12, nx * 3 // 4), 2
transformation = gf.GeoTrans("GT_QK(2,2)")


def mesh_of(a, b, position):
    mesh = gf.Mesh("empty", 2)
    for j in range(len(b) - 1):
        for i in range(len(a) - 1):
            u, v = np.linspace(a[i], a[i + 1], 3), np.linspace(b[j], b[j + 1], 3)
            mesh.add_convex(transformation, np.array([position(u[p], v[q]) for q in range(3) for p in range(3)]).T)
    return mesh


def faces(mesh, condition):
    chosen = [(c, f) for c, f in mesh.outer_faces().T
              if condition(mesh.pts(mesh.pid_in_faces(np.array([[c], [f]]))))]
    return np.array(chosen).T


die = mesh_of(np.linspace(-np.pi / 2, np.pi / 2, nc + 1), np.linspace(0, 0.2, nr + 1),
              lambda u, v: (0.5 + (0.5 - v) * np.sin(u), 1.5 - (0.5 - v) * np.cos(u)))
slab = mesh_of(np.linspace(0, 3, nx + 1), 1 - (1 - np.linspace(0, 1, ny + 1)) ** 1.3, lambda u, v: (u, v))
OUTSIDE, CUT, TOP, BOTTOM = 1, 2, 3, 4
die.set_region(OUTSIDE, faces(die, lambda X: np.allclose(np.hypot(X[0] - 0.5, X[1] - 1.5), 0.5, atol=1e-9)
                              and X[1].mean() < 1.25))
die.set_region(CUT, faces(die, lambda X: np.allclose(X[1], 1.5)))
slab.set_region(TOP, faces(slab, lambda X: np.allclose(X[1], 1.0)))
slab.set_region(BOTTOM, faces(slab, lambda X: np.allclose(X[1], 0.0)))

model, integration = gf.Model("real"), gf.Integ("IM_GAUSS_PARALLELEPIPED(2,5)")
spaces, methods = {}, {}
for name, mesh, E in (("d", die, 1000.0), ("s", slab, 1.0)):
    spaces[name] = gf.MeshFem(mesh, 2)
    spaces[name].set_fem(gf.Fem("FEM_QK(2,2)"))
    methods[name] = gf.MeshIm(mesh, integration)
    model.add_fem_variable("u" + name, spaces[name])
    model.add_initialized_data("l" + name, [E * 0.3 / 1.3 / 0.4])
    model.add_initialized_data("m" + name, [E / 2.6])
    model.add_macro("F" + name, f"(Id(2)+Grad_u{name})")
    model.add_nonlinear_term(methods[name], f"(m{name}*(F{name}-Inv(F{name})')+l{name}*log(Det(F{name}))"
                                            f"*Inv(F{name})'):Grad_Test_u{name}")
    model.add_fem_data("w" + name, spaces[name])
model.add_initialized_data("dd", [0.0, 0.0])
model.add_Dirichlet_condition_with_simplification("ud", CUT, "dd")
model.add_Dirichlet_condition_with_simplification("us", BOTTOM)
for name, value in (("r", augmentation), ("mu", 0.3), ("alpha", 1.0)):
    model.add_initialized_data(name, [value])
brick = model.add_integral_large_sliding_contact_brick_raytracing("r", 0.1, "mu", "alpha", 0)
multipliers = gf.MeshFem(die, 2)
multipliers.set_fem(gf.Fem("FEM_QK(2,1)"))
model.add_filtered_fem_variable("lm", multipliers, OUTSIDE)
model.add_slave_contact_boundary_to_large_sliding_contact_brick(brick, methods["d"], OUTSIDE, "ud", "lm", "wd")
model.add_master_contact_boundary_to_large_sliding_contact_brick(brick, methods["s"], TOP, "us", "ws")

iterations, history, variables = 0, [], ["ud", "us", "lm"]
end, now, step = 1 + slide / 10, 0.0, 0.1
while now < end - 1e-9:
    target = min(now + step, end)
    model.set_variable("dd", [2.0 * max(0, target - 1) / (end - 1), -0.075 * min(1, target)])
    old = [model.variable(v).copy() for v in variables]
    model.set_variable("wd", old[0])
    model.set_variable("ws", old[1])
    try:
        count, converged = model.solve("max_res", 1e-7, "max_iter", 25, "lsolver", "mumps", "lsearch", "simplest",
                                       "alpha min", 0.8)
    except RuntimeError:
        count, converged = 25, 0
    iterations += count
    if not converged or not np.isfinite(model.variable("us")).all():
        for v, value in zip(variables, old):
            model.set_variable(v, value)
        step /= 2
        if step < 1e-4:
            sys.exit("no convergence at %.3f of %.1f" % (now, end))
        continue
    now, step = target, min(0.1, step * 1.5)
    force = gf.asm("generic", methods["d"], 0, "lm", OUTSIDE, model)
    history.append([now, -force[0], force[1]])

h = np.array(history)
part = h[(h[:, 0] > 1 + 0.3 * (end - 1)) & (h[:, 0] < 1 + 0.8 * (end - 1) + 1e-9)]
means = part[:, 1:].mean(axis=0)
oscillation = [100 * np.ptp(part[:, k] - np.polyval(np.polyfit(part[:, 0], part[:, k], 2), part[:, 0])) / means[k - 1]
               for k in (1, 2)]
print(f"RESULT Q2/Q1_{nx}x{ny} {model.nbdof()} {iterations} {time.process_time() - began:.2f} {means[0]:.6f} "
      f"{means[1]:.6f} {oscillation[0]:.3f} {oscillation[1]:.3f}")
