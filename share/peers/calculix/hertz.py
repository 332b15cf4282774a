# CalculiX 2.20 (Debian 12, calculix-ccx): Hertz's line contact on a rigid plane, see ../hertz_mesh.py. Writes the input
# file hertz.inp to the present folder, runs ccx on one processor and reads the pressure at the nodes.
# Run: /usr/bin/python3.11 hertz.py <level 0 …> [element = C3D8I: or C3D20R] [contact = N2S: node to surface, or S2S:
# surface to surface] [stiffness = 1000]
# Prints one line: RESULT name unknowns iterations processor_seconds error_of_pressure error_of_peak
import os
import re
import resource
import subprocess
import sys
import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from hertz_mesh import breaks, errors  # noqa: E402

level = int(sys.argv[1])
element = sys.argv[2] if len(sys.argv) > 2 else "C3D8I"
kind = {"S2S": "SURFACE TO SURFACE", "N2S": "NODE TO SURFACE"}[sys.argv[3] if len(sys.argv) > 3 else "N2S"]
stiffness = float(sys.argv[4]) if len(sys.argv) > 4 else 1000.0
depth, overlap, quadratic = 0.02, 5e-5, "20" in element
phi, s = breaks(level)
n, m = len(phi) - 1, len(s) - 1


def halved(x):
    return np.sort(np.concatenate([x, (x[1:] + x[:-1]) / 2]))


P, S = (halved(phi), halved(s)) if quadratic else (phi, s)
Z = [0, depth / 2, depth] if quadratic else [0, depth]


def node(i, j, k):
    return 1 + i + len(P) * (j + len(S) * k)


corner = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2)]
middle = [(1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2),
          (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1)]
elements, used = [], set()
for j in range(m):
    for i in range(n):
        if quadratic:
            nodes = [node(2 * i + a, 2 * j + b, k) for a, b, k in corner + middle]
        else:
            nodes = [node(i + a // 2, j + b // 2, k // 2) for a, b, k in corner]
        elements.append(nodes)
        used.update(nodes)
position = {}
with open("hertz.inp", "w") as f:
    f.write("*NODE, NSET=NCYL\n")
    for k, z in enumerate(Z):
        for j, deep in enumerate(S):
            for i, angle in enumerate(P):
                q = node(i, j, k)
                if q in used:
                    position[q] = ((1 - deep) * np.sin(angle), 1 - (1 - deep) * np.cos(angle))
                    f.write(f"{q},{position[q][0]:.12g},{position[q][1] - overlap:.12g},{z:.12g}\n")
    first = max(used) + 1
    plane = [(x, y, z) for z in (-depth, 2 * depth) for x, y in ((-0.2, -0.1), (0.4, -0.1), (0.4, 0), (-0.2, 0))]
    f.write("*NODE, NSET=NRIG\n" + "".join(f"{first + q},{x},{y},{z}\n" for q, (x, y, z) in enumerate(plane)))
    f.write(f"*ELEMENT, TYPE={element}, ELSET=ECYL\n")
    for q, nodes in enumerate(elements):
        row = [q + 1] + nodes
        f.write(",".join(map(str, row[:16])) + (",\n" + ",".join(map(str, row[16:])) if len(row) > 16 else "") + "\n")
    last = len(elements) + 1
    f.write(f"*ELEMENT, TYPE=C3D8, ELSET=ERIG\n{last}," + ",".join(str(first + q) for q in range(8)) + "\n")
    f.write("*NSET, NSET=NSYM\n" + "".join(f"{q}\n" for q in sorted(used) if abs(position[q][0]) < 1e-12))
    f.write("*SURFACE, NAME=SLAVE, TYPE=ELEMENT\n" + "".join(f"{i + 1},S3\n" for i in range(n) if phi[i] < 0.12))
    f.write(f"*SURFACE, NAME=MASTER, TYPE=ELEMENT\n{last},S5\n*MATERIAL, NAME=M\n*ELASTIC\n1.,0.3\n"
            "*SOLID SECTION, ELSET=ECYL, MATERIAL=M\n*SOLID SECTION, ELSET=ERIG, MATERIAL=M\n"
            "*BOUNDARY\nNSYM,1,1\nNRIG,1,3\nNCYL,3,3\n*SURFACE INTERACTION, NAME=SI\n"
            f"*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{stiffness:g}\n"
            f"*CONTACT PAIR, INTERACTION=SI, TYPE={kind}\nSLAVE,MASTER\n*STEP, INC=1000\n*STATIC\n0.25,1.,1e-6,0.5\n"
            "*DLOAD\n" + "".join(f"{j * n + n},P4,{1e-3 / 0.9:.12g}\n" for j in range(m))
            + "*NODE FILE\nU\n*CONTACT FILE\nCDIS,CSTR\n*END STEP\n")

one = dict(os.environ, OMP_NUM_THREADS="1", CCX_NPROC_EQUATION_SOLVER="1", NUMBER_OF_CPUS="1")
said = subprocess.run(["ccx", "hertz"], capture_output=True, text=True, env=one).stdout
spent = resource.getrusage(resource.RUSAGE_CHILDREN)
unknowns = re.findall(r"number of equations\s*\n\s*(\d+)", said)
iterations = len(re.findall(r"^ iteration \d+", said, re.M))

# Pressures of the last increment at nodes of the cylinder, means over the depth.
places, pressures, block = {}, {}, None
for line in open("hertz.frd"):
    if line.startswith("    2C"):
        block = places
    elif line.startswith(" -4"):
        block = {} if line.startswith(" -4  CONTACT") else None
    elif line.startswith(" -3"):
        pressures = block if block is not None and block is not places else pressures
        block = None
    elif line.startswith(" -1") and block is not None:
        count = 3 if block is places else 6
        block[int(line[3:13])] = [float(line[13 + 12 * k:25 + 12 * k]) for k in range(count)]
columns = {}
for q, values in pressures.items():
    if q in places and abs(np.hypot(places[q][0], places[q][1] + overlap - 1) - 1) < 1e-4:
        columns.setdefault(round(places[q][0], 7), []).append(values[3])
if not columns:
    sys.exit("ccx has written no pressures")
x = np.array(sorted(columns))
error, peak = errors(x, np.array([np.mean(columns[k]) for k in sorted(columns)]))
print(f"RESULT {element}_{kind.split()[0].lower()}_{level} {unknowns[-1] if unknowns else 0} {iterations} "
      f"{spent.ru_utime + spent.ru_stime:.2f} {error:.6f} {peak:.6f}")
