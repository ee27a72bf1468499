"""Writes the meshes of this folder, and what MuJoCo makes of them: `python3 make.py`, with mujoco 4.0 and numpy.

`reference.json` lists models: attributes of `compiler`, of a mesh and of the geom that uses it, a body's only one. For each it
has mass, mass centre and inertia (xx, yy, zz, xy, xz, yz about the mass centre, in the body's axes), or the words in which
MuJoCo refuses the model.
"""

import itertools
import json
import struct
from pathlib import Path

import mujoco
import numpy

HERE = Path(__file__).parent
files = {}


def stl(points, faces):
    data = b"\0" * 80 + struct.pack("<I", len(faces))
    for face in faces:
        data += bytes(12) + points[list(face)].astype("<f4").tobytes() + bytes(2)
    return data


def stl_text(points, faces):
    lines = ["solid mesh"]
    for face in faces:
        lines += ["facet normal 0 0 0", "  outer loop"]
        lines += ["    vertex %r %r %r" % tuple(map(float, points[i])) for i in face]
        lines += ["  endloop", "endfacet"]
    return "\n".join(lines + ["endsolid mesh", ""]).encode()


def msh(points, faces):
    counts = struct.pack("<4i", len(points), 0, 0, len(faces))
    return counts + points.astype("<f4").tobytes() + numpy.array(faces, "<i4").tobytes()


def obj(points, polygons):
    lines = ["v %r %r %r" % tuple(map(float, p)) for p in points]
    return "\n".join(lines + ["f " + " ".join(str(i + 1) for i in p) for p in polygons] + [""]).encode()


def inline(points, faces):
    numbers = " ".join(repr(float(x)) for x in points.ravel())
    return {"vertex": numbers, "face": " ".join(str(i) for face in faces for i in face)}


# An L: a plate in the plane z = 0, and the same at z = 0.5, with six walls; off the origin, in single precision.
outline = [(0, 0), (2, 0), (2, 1), (1, 1), (1, 3), (0, 3)]
plate = [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5)]
walls = [(i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6) for i in range(6)]
L = numpy.array([(x, y, z) for z in (0, 0.5) for x, y in outline], numpy.float32) + numpy.float32(0.3)
L_FACES = [(a, c, b) for a, b, c in plate] + [(a + 6, b + 6, c + 6) for a, b, c in plate]
L_FACES += [t for a, b, c, d in walls for t in ((a, b, c), (a, c, d))]
L_POLYGONS = [(5, 4, 3, 2, 1, 0), (6, 7, 8, 9, 10, 11)] + walls
# Nothing of it is in a plane.
BENT = L + numpy.float32(0.05) * numpy.sin(numpy.arange(36, dtype=numpy.float32)).reshape(12, 3)
T = numpy.array([(0.1, 0.2, 0.3), (1.3, 0.1, 0), (0.2, 0.9, 0.1), (0.3, 0.4, 1.7)], numpy.float32)
T_FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
BOX = numpy.array(list(itertools.product((-1, 1), (-2, 2), (-3, 3))), numpy.float32)
BOX_FACES = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
CLOUD = numpy.random.default_rng(1).normal(size=(60, 3)).astype(numpy.float32)

files["l.stl"] = stl(L, L_FACES)
files["l_text.stl"] = stl_text(L, L_FACES)
files["l.msh"] = msh(L, L_FACES)
files["l.obj"] = obj(L, L_FACES)
files["l_polygons.obj"] = obj(L, L_POLYGONS)
files["bent.obj"] = obj(BENT, L_POLYGONS)
files["open.obj"] = obj(L, L_FACES[:-2])
files["inward.obj"] = obj(L, [(a, c, b) for a, b, c in L_FACES])
files["one_inward.obj"] = obj(L, [(0, 1, 2)] + L_FACES[1:])
files["flat.obj"] = obj(L[:6], plate)
files["tetrahedron.stl"] = stl(T, T_FACES)
files["tetrahedron.obj"] = obj(T, T_FACES)
files["box.obj"] = obj(BOX, BOX_FACES)
second = b"o second\nv 9 9 9\nv 10 9 9\nv 9 10 9\nv 9 9 11\nf 13 14 15\ng third\nf -4 -3 -1\n"
# MuJoCo leaves out the face of 101 corners.
circle = numpy.linspace(0, 2 * numpy.pi, 101, endpoint=False)
ROUND = numpy.array([(numpy.cos(x), numpy.sin(x), z) for z in (0, 1) for x in circle], numpy.float32)
ROUND = numpy.append(ROUND, numpy.array([(0, 0, 2)], numpy.float32), axis=0)
sides = [(i, (i + 1) % 101, (i + 1) % 101 + 101, i + 101) for i in range(101)]
tip = [(i + 101, (i + 1) % 101 + 101, 202) for i in range(101)]
files["round.obj"] = obj(ROUND, [tuple(range(100, -1, -1))] + sides + tip)
files["several.obj"] = b"o first\n" + files["l.obj"] + second
files["materials.obj"] = files["l.obj"] + b"usemtl other\nv 9 9 9\nv 10 9 9\nv 9 10 9\nf 13//1 14//1 15//1\n"

MODES = ["legacy", "exact", "convex", "shell"]
SCALES = ["1 1 1", "-1 1 1", "0.1 -0.2 -0.3", "-0.02 -0.01 -0.03"]
cases = []


def case(mesh, geom=None, compiler=None):
    cases.append({"compiler": compiler or {}, "mesh": mesh, "geom": geom or {"type": "mesh"}})


for source in [{"file": f} for f in ("l.stl", "l_text.stl", "l.msh", "l.obj")] + [inline(L, L_FACES)]:
    for scale, mode in itertools.product(SCALES, MODES):
        case({**source, "scale": scale, "inertia": mode})
for name in ["l_polygons", "bent", "open", "inward", "one_inward", "flat", "tetrahedron", "box", "several", "materials", "round"]:
    for mode in MODES:
        # Nothing that collides may be flat.
        geom = {"type": "mesh", "contype": "0", "conaffinity": "0"} if name == "flat" else None
        case({"file": name + ".obj", "inertia": mode}, geom)
case({"file": "tetrahedron.stl"})
placed = {"type": "mesh", "pos": "0.1 -0.2 0.3", "euler": "20 30 40", "density": "700"}
for mode in MODES:
    case({"file": "tetrahedron.stl", "inertia": mode, "refpos": "0.1 0.2 -0.5", "refquat": "1 0.2 0.3 -0.4", "scale": "1 2 -0.5"}, placed)
    case({"file": "tetrahedron.stl", "inertia": mode}, {**placed, "mass": "3"})
    # So small that MuJoCo leaves its products of inertia where they are.
    case({"file": "tetrahedron.stl", "inertia": mode, "scale": "0.01 0.01 0.01"}, placed)
    case({"vertex": inline(CLOUD, [])["vertex"], "inertia": mode})
case({"vertex": inline(CLOUD, [])["vertex"], "scale": "1 1 -2"})
for kind in ["sphere", "capsule", "cylinder", "ellipsoid", "box"]:
    for compiler in [{}, {"fitaabb": "true"}]:
        case({"file": "l.stl"}, {**placed, "type": kind}, compiler)
        case({"file": "tetrahedron.obj", "inertia": "shell"}, {**placed, "type": kind, "fitscale": "0.7"}, compiler)
case({"file": "l.stl"}, {"density": "1000"})
case({"file": "l.stl"}, {"type": "sdf"})


def element(name, attributes):
    return "<%s%s/>" % (name, "".join(f' {key}="{value}"' for key, value in attributes.items()))


def reference(case):
    mesh = {"name": "m", **case["mesh"]}
    # MuJoCo reads no STL that is text.
    if mesh.get("file") == "l_text.stl":
        mesh["file"] = "l.stl"
    geom = {**case["geom"], "mesh": "m"}
    text = f"""<mujoco>{element("compiler", case["compiler"])}<asset>{element("mesh", mesh)}</asset>
<worldbody><body><freejoint/>{element("geom", geom)}</body></worldbody></mujoco>"""
    try:
        model = mujoco.MjModel.from_xml_string(text, files)
    except ValueError as error:
        return {"refused": str(error).splitlines()[0]}
    turn = numpy.zeros(9)
    mujoco.mju_quat2Mat(turn, model.body_iquat[1])
    turn = turn.reshape(3, 3)
    inertia = turn @ numpy.diag(model.body_inertia[1]) @ turn.T
    six = [inertia[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
    return {"mass": model.body_mass[1], "center": list(model.body_ipos[1]), "inertia": six}


for name, data in files.items():
    (HERE / name).write_bytes(data)
for one in cases:
    one["reference"] = reference(one)
with open(HERE / "reference.json", "w", encoding="utf-8") as out:
    lines = ",\n".join(json.dumps(one) for one in cases)
    out.write(f"[\n{lines}\n]\n")
