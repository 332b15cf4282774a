"""Prints a file of HDF5 as a Lua table for tests/lua/output/hdf5_test.lua: by path { shape, values, attributes }.
   read.py <file>"""

import sys

import h5py
import numpy


def lua(value):
    if isinstance(value, bytes):
        value = value.decode()
    if isinstance(value, str):
        return '"' + "".join("\\%03d" % byte for byte in value.encode()) + '"'
    if isinstance(value, numpy.ndarray):
        return "{" + ",".join(lua(one) for one in value.flatten()) + "}"
    if isinstance(value, (int, numpy.integer)):
        return str(int(value))
    return repr(float(value)) if numpy.isfinite(value) else "0/0"


def entry(item):
    attributes = ",".join("[%s]=%s" % (lua(name), lua(value)) for name, value in item.attrs.items())
    if not isinstance(item, h5py.Dataset):
        return "{attributes={%s}}" % attributes
    values = item.asstr()[:] if item.dtype.kind == "O" else item[()]
    return "{shape=%s,values=%s,compression=%s,attributes={%s}}" % (
        lua(numpy.array(item.shape)), lua(values), lua(item.compression or "none"), attributes)


with h5py.File(sys.argv[1], "r") as file:
    print('return {["/"]=%s,' % entry(file))
    file.visititems(lambda path, item: print("[%s]=%s," % (lua("/" + path), entry(item))))
    print("}")
