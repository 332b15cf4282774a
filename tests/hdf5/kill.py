"""Opens a run's file again and again while the run goes, and kills the process (SIGKILL) once the file has so many
   rows; then the file must have all steps that were accepted before the last one.
   kill.py <rows> <file> <file with the accepted step> <command> …"""

import os
import subprocess
import sys

import h5py

rows, path, accepted = int(sys.argv[1]), sys.argv[2], sys.argv[3]


def look():
    with h5py.File(path, "r") as file:
        steps = file["columns/step"][:]
        assert list(steps) == list(range(1, len(steps) + 1)), steps
        for name in file["columns"].attrs["names"]:
            assert len(file["columns"][name]) == len(steps), name
        assert len(file["profiles/step"]) == len(steps) + 1
        assert len(file["states/step"]) == len(steps) + 1
        assert len(file["contacts/touch/pressure"]) == len(steps) + 1
        assert len(file["bodies/strip/displacement"]) == len(steps) + 1
        assert len(file["rows/stage"]) == len(steps)
        assert file.attrs["steps"] == len(steps)
        return len(steps), file.attrs["reason"]


process = subprocess.Popen(sys.argv[4:])
looks = set()
while not os.path.exists(path):
    assert process.poll() is None, "the run has ended without a file"
while True:
    found, reason = look()
    assert reason == "running", reason
    assert process.poll() is None, "the run has ended too early"
    looks.add(found)
    if found >= rows:
        break
process.kill()
process.wait()
found, reason = look()
with open(accepted) as file:
    last = int(file.read())
assert reason == "running", reason
assert found >= last - 1, (found, last)
print("whole with", len(looks), "looks")
