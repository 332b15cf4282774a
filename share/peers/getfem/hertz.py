# GetFEM 5.4.2 (Debian 12, python3-getfem): Hertz's line contact on a rigid plane, see ../hertz_mesh.py. Q2 elements,
# small strains, multipliers of degree 1 with an augmented Lagrangian, or a penalty.
# Run: /usr/bin/python3.11 hertz.py <level 0 …> [penalty = 0: multipliers]
# Prints one line: RESULT name unknowns iterations processor_seconds error_of_pressure error_of_peak
import os
import sys
import time
import numpy as np
import getfem as gf

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from hertz_mesh import breaks, errors  # noqa: E402

began = time.process_time()
level, penalty = int(sys.argv[1]), float(sys.argv[2]) if len(sys.argv) > 2 else 0.0
gf.util_trace_level(0)
phi, s = breaks(level)
mesh, transformation = gf.Mesh("empty", 2), gf.GeoTrans("GT_QK(2,2)")
for j in range(len(s) - 1):
    for i in range(len(phi) - 1):
        P, S = np.linspace(phi[i], phi[i + 1], 3), np.linspace(s[j], s[j + 1], 3)
        mesh.add_convex(transformation, np.array([[(1 - S[b]) * np.sin(P[a]), 1 - (1 - S[b]) * np.cos(P[a])]
                                                  for b in range(3) for a in range(3)]).T)
CONTACT, TOP, AXIS = 1, 2, 3
regions = {CONTACT: [], TOP: [], AXIS: []}
for c, f in mesh.outer_faces().T:
    X = mesh.pts(mesh.pid_in_faces(np.array([[c], [f]])))
    if np.allclose(np.hypot(X[0], X[1] - 1), 1, atol=1e-9):
        if X[0].max() < 0.12:
            regions[CONTACT].append((c, f))
    elif np.allclose(X[1], 1):
        regions[TOP].append((c, f))
    elif np.allclose(X[0], 0):
        regions[AXIS].append((c, f))
for number, chosen in regions.items():
    mesh.set_region(number, np.array(chosen).T)

space = gf.MeshFem(mesh, 2)
space.set_fem(gf.Fem("FEM_QK(2,2)"))
bulk = gf.MeshIm(mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(2,6)"))
contact = gf.MeshIm(mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(2,8)"))
model = gf.Model("real")
model.add_fem_variable("u", space)
model.add_initialized_data("lambda", [0.3 / 1.3 / 0.4])
model.add_initialized_data("mu", [1 / 2.6])
model.add_isotropic_linearized_elasticity_brick(bulk, "u", "lambda", "mu")
model.add_initialized_data("H", np.array([[1.0, 0.0], [0.0, 0.0]]))
model.add_initialized_data("zero", [0.0, 0.0])
model.add_generalized_Dirichlet_condition_with_penalization(bulk, "u", 1e8, AXIS, "zero", "H")
model.add_initialized_data("load", [0.0, -1e-3 / 0.9])
model.add_source_term_brick(bulk, "u", "load", TOP)
height = gf.MeshFem(mesh, 1)
height.set_fem(gf.Fem("FEM_QK(2,2)"))
model.add_initialized_fem_data("obstacle", height, height.eval("y"))
model.add_initialized_data("r", [penalty or 10.0])
if penalty:
    model.add_penalized_contact_with_rigid_obstacle_brick(contact, "u", "obstacle", "r", CONTACT, 1)
else:
    multipliers = gf.MeshFem(mesh, 1)
    multipliers.set_fem(gf.Fem("FEM_QK(2,1)"))
    model.add_filtered_fem_variable("lm", multipliers, CONTACT)
    model.add_integral_contact_with_rigid_obstacle_brick(contact, "u", "lm", "obstacle", "r", CONTACT, 1)
start = np.zeros(space.nbdof())
start[1::2] = -5e-5  # so that the first iteration finds points in contact
model.set_variable("u", start)
iterations = model.solve("max_res", 1e-9, "max_iter", 100, "lsolver", "mumps")[0]

line = gf.Slice(("boundary",), mesh, 16, mesh.region(CONTACT))
points = line.pts()
order = np.argsort(points[0])
if penalty:
    u = gf.compute(space, model.variable("u"), "interpolate_on", line)
    pressure = penalty * np.maximum(0, -(points[1] + u[1]))
else:
    pressure = -gf.compute(model.mesh_fem_of_variable("lm"), model.variable("lm"), "interpolate_on", line)
error, peak = errors(points[0][order], pressure[order])
name = f"penalty_{penalty:g}" if penalty else "multipliers"
print(f"RESULT Q2_{name}_{level} {model.nbdof()} {iterations} {time.process_time() - began:.2f} {error:.6f} {peak:.6f}")
