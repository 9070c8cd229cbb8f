#!/usr/bin/env python3
"""Checks the STEP files of `grafika render` with a CAD kernel. Run by hand:

    pip install "cadquery-ocp-novtk<7.9"
    cargo build
    python3 tests/step_kernel.py target/debug/grafika

For every kind of net and every method the kernel (Open CASCADE) has to read one valid face, a solid of positive
volume where the surface is closed, and a surface that agrees with `grafika sample` to 1e-9 at every sample. Of plane
curves it has to read one edge for each part of an offset, which agrees with `grafika offset` to 1e-9; of nets with
normals the surface and its offsets, rational ones.
"""

import csv
import io
import json
import math
import pathlib
import subprocess
import sys
import tempfile

from OCP.BRep import BRep_Tool
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepGProp import BRepGProp
from OCP.GProp import GProp_GProps
from OCP.IFSelect import IFSelect_RetDone
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_SHELL, TopAbs_SOLID
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS

TOLERANCE = 1e-9


def sphere(radius, turn=1):
    """8 meridians of 5 points."""
    place = lambda fi, psi: [
        radius * math.sin(fi) * math.cos(psi), radius * math.sin(fi) * math.sin(psi), radius * math.cos(fi)]
    net = [[place(math.pi * l / 4, turn * math.pi * k / 4) for l in range(5)] for k in range(8)]
    for row in net:
        row[0], row[4] = [0.0, 0.0, radius], [0.0, 0.0, -radius]
    return net


def torus(large, small):
    """8 circles of 5 points."""
    def place(fi, psi):
        q = large + small * math.sin(fi)
        return [q * math.cos(psi), q * math.sin(psi), small * math.cos(fi)]
    return [[place(math.tau * l / 5 + math.pi / 2, math.tau * k / 8) for l in range(5)] for k in range(8)]


def moved(net, *changes):
    """The net with some points elsewhere."""
    net = json.loads(json.dumps(net))
    for k, l, point in changes:
        net[k][l] = point
    return net


def flat(rows, columns, step):
    """Points over a square lattice."""
    return [[[(k - (rows - 1) / 2) * step, (l - (columns - 1) / 2) * step, 0] for l in range(columns)]
            for k in range(rows)]


HILLS = moved(flat(5, 5, 80), (2, 2, [0, 0, 100]), (1, 3, [-80, 80, -60]), (3, 1, [100, -60, 50]))
HERMITE = [[[-150, -150, 100], [-150, 150, 0], [0, 300, -100], [0, 300, 0]],
           [[150, -150, 0], [150, 150, 60], [0, 300, 0], [0, 300, 0]],
           [[300, 0, 200], [300, 0, 0], [0, 0, 400], [0, 0, 0]],
           [[300, 0, 0], [300, 0, -200], [0, 0, 0], [0, 0, 0]]]
COLLAPSED = moved(HILLS, *[(0, l, [-160, 0, 20]) for l in range(5)])
# Nets whose surfaces do not cut themselves: of others a kernel cannot tell the inside.
BALL = moved(sphere(120), (2, 2, [0, 180, 30]), (5, 1, [-80, -120, 100]))
RING = moved(torus(120, 40), (1, 0, [150, 150, 60]), (4, 0, [-190, 0, 40]))

METHODS = [["spline"], ["local", "--k0", "0.7"], ["bspline2"], ["bspline3"], ["bspline3", "--extended"],
           ["beta", "--bias", "1.6", "--tension-u", "2", "--tension-v", "5"], ["beta", "--tension", "3"], ["bezier"]]

# Kind, net, whether it is closed.
NETS = [("FPS", flat(5, 5, 80), False), ("FPS", HILLS, False), ("FEM", flat(8, 5, 70), False),
        ("FPB", flat(4, 4, 120), False), ("FBS", COLLAPSED, False), ("FHC", HERMITE, False),
        ("ZMS", sphere(120), True), ("ZMS", sphere(120, -1), True), ("ZMB", BALL, True),
        ("ZYS", torus(120, 40), True), ("ZYB", torus(160, 60), True), ("ZYP", RING, True),
        ("ZYP", RING[::-1], True)]


# Points of plane curves, whether they are closed, and distances.
CURVES = [([[430, 190], [395, 290], [290, 330], [190, 300], [150, 200], [185, 105], [270, 60], [350, 85]], True,
           [0, 20, 90, -30, 110]),
          ([[60, 120], [150, 300], [250, 170], [330, 110], [420, 190], [500, 320]], False, [0, -40, 51, 60, -70]),
          ([[0, 0], [300, 100]], False, [25])]

# Samples with normals, and distances.
NORMALS = [("G.PN", [0, 4, -10]), ("P.PN", [0, 6, -12]), ("N.PN", [0, 0.5, 3]), ("Y.PN", [0, 12, -9])]
DATA = pathlib.Path(__file__).resolve().parent.parent / "data"

# Releases of the bindings differ in the name.
as_face = getattr(TopoDS, "Face_s", None) or TopoDS.Face
as_edge = getattr(TopoDS, "Edge_s", None) or TopoDS.Edge


def run(*arguments):
    return subprocess.run(arguments, check=True, capture_output=True, text=True).stdout


def explore(shape, kind):
    explorer, found = TopExp_Explorer(shape, kind), []
    while explorer.More():
        found.append(explorer.Current())
        explorer.Next()
    return found


def check(grafika, folder, kind, net, closed, method):
    """The largest distance between the kernel's surface and the samples."""
    file, step = folder / "net.json", folder / "net.step"
    file.write_text(json.dumps({"format": kind, "points": net}))
    choice = ["--method", *method] if kind != "FHC" else []
    run(grafika, "render", file, *choice, "-o", step)
    # Models of spheres are always led to their poles.
    extended = ["--extended"] if kind in ("ZMS", "ZMB") and method == ["bspline3"] else []
    samples = run(grafika, "sample", file, *choice, *extended, "--per-span", "5")
    return compare(step, samples, closed)


def check_normals(grafika, folder, file, method, distance):
    """The same of the offset of a net with normals."""
    step = folder / "net.step"
    command = [grafika, "offset", file, "--method", method, f"--distance={distance}"]
    run(*command, "-o", step)
    return compare(step, run(*command, "--to", "csv", "--per-span", "5"), False)


def compare(step, samples, closed):
    """The largest distance between the surface in a file and samples of it."""
    samples = list(csv.DictReader(io.StringIO(samples)))
    reader = STEPControl_Reader()
    assert reader.ReadFile(str(step)) == IFSelect_RetDone, "not read"
    reader.TransferRoots()
    shape = reader.OneShape()
    assert BRepCheck_Analyzer(shape).IsValid(), "not valid"
    assert shape.ShapeType() == (TopAbs_SOLID if closed else TopAbs_SHELL), shape.ShapeType()
    if closed:
        properties = GProp_GProps()
        BRepGProp.VolumeProperties_s(shape, properties)
        assert properties.Mass() > 0, properties.Mass()
    [face] = explore(shape, TopAbs_FACE)
    surface = BRep_Tool.Surface_s(as_face(face))
    knots = [[surface.UKnot(n + 1) for n in range(surface.NbUKnots())],
             [surface.VKnot(n + 1) for n in range(surface.NbVKnots())]]
    worst = 0.0
    for row in samples:
        place = []
        for d, (span, at) in enumerate((("i", "u"), ("j", "v"))):
            start, end = knots[d][int(row[span])], knots[d][int(row[span]) + 1]
            place.append(start + float(row[at]) * (end - start))
        point = surface.Value(*place)
        theirs = (point.X(), point.Y(), point.Z())
        worst = max([worst, *(abs(a - float(row[axis])) for a, axis in zip(theirs, "xyz"))])
    assert worst < TOLERANCE, worst
    return worst


def check_offset(grafika, folder, points, closed, distance, trim, knots):
    """The largest distance between the kernel's curves and the points of an offset."""
    file, step, per_span = folder / "curve.json", folder / "curve.step", 7
    settings = {"method": "phspline", "closed": closed, "knots": knots}
    file.write_text(json.dumps({"format": "IP2", "points": points, "settings": settings}))
    command = [grafika, "offset", file, f"--distance={distance}", *(["--trim"] if trim else [])]
    run(*command, "-o", step)
    rows = list(csv.DictReader(io.StringIO(run(*command, "--to", "csv", "--per-span", str(per_span)))))
    reader = STEPControl_Reader()
    assert reader.ReadFile(str(step)) == IFSelect_RetDone, "not read"
    reader.TransferRoots()
    # The ends of every span, from 0, of one edge after the other.
    places = []
    for edge in explore(reader.OneShape(), TopAbs_EDGE):
        curve = BRep_Tool.Curve_s(as_edge(edge), 0.0, 1.0)
        curve = curve[0] if isinstance(curve, tuple) else curve
        first, last = curve.FirstParameter(), curve.LastParameter()
        places += [(curve, first + k) for k in range(round(last - first))]
    assert len(places) * (per_span + 1) == len(rows), f"{len(places)} spans for {len(rows)} rows"
    worst = 0.0
    for index, row in enumerate(rows):
        curve, start = places[index // (per_span + 1)]
        point = curve.Value(start + index % (per_span + 1) / per_span)
        worst = max(worst, math.hypot(point.X() - float(row["x"]), point.Y() - float(row["y"])), abs(point.Z()))
    assert worst < TOLERANCE, worst
    return worst


def main():
    grafika = str(pathlib.Path(sys.argv[1]).resolve())
    worst, count = 0.0, 0
    with tempfile.TemporaryDirectory() as folder:
        for kind, net, closed in NETS:
            for method in METHODS:
                if closed and method == ["bezier"] or kind == "FHC" and method != ["spline"]:
                    continue
                if kind.startswith("ZY") and method[-1] == "--extended":
                    continue
                try:
                    worst = max(worst, check(grafika, pathlib.Path(folder), kind, net, closed, method))
                except (AssertionError, subprocess.CalledProcessError) as error:
                    sys.exit(f"{kind} {' '.join(method)}: {getattr(error, 'stderr', '')} {error}")
                count += 1
        for name, distances in NORMALS:
            for distance in distances:
                for method in ("pn", "pn-thesis"):
                    case = (DATA / name, method, distance)
                    try:
                        worst = max(worst, check_normals(grafika, pathlib.Path(folder), *case))
                    except (AssertionError, subprocess.CalledProcessError) as error:
                        sys.exit(f"{case}: {getattr(error, 'stderr', '')} {error}")
                    count += 1
        for points, closed, distances in CURVES:
            for distance in distances:
                for trim in (False, True):
                    for knots in ("chord", "uniform"):
                        case = (points, closed, distance, trim, knots)
                        try:
                            worst = max(worst, check_offset(grafika, pathlib.Path(folder), *case))
                        except (AssertionError, subprocess.CalledProcessError) as error:
                            sys.exit(f"{case}: {getattr(error, 'stderr', '')} {error}")
                        count += 1
    print(f"{count} files, largest distance {worst:.1e}")


if __name__ == "__main__":
    main()
