#!/usr/bin/env python3
"""Robots that people publish: which of them `kane` takes, and whether its numbers are those of Pinocchio and MuJoCo.

Downloads packages from PyPI, finds URDF and MJCF files in them, runs `kane` on each file, and compares the mass matrix, inverse
and forward dynamics at one random state. Prints tables in Markdown. README.md beside this file says how to run it.
"""

import argparse
import collections
import hashlib
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import xml.etree.ElementTree as xml
import zipfile

import mujoco
import numpy
import pinocchio

# Options that leave something out, tried in this order where a model is refused without them.
OPTIONS = {
    "urdf": [["--remove-massless"]],
    "mjcf": [
        ["--leave-out", "equalities,fluid,tendons,gravcomp"],
        ["--leave-out", "equalities,fluid,tendons,gravcomp", "--remove-massless"],
    ],
}
# Seconds that a command may take.
PATIENCE = 120


def download(package, folder):
    """The package's sdist and wheel, unpacked; nothing of it is run."""
    target, part = folder / package, folder / f"{package}.part"
    if target.exists():
        return target
    shutil.rmtree(part, ignore_errors=True)
    part.mkdir(parents=True)
    for kind in ["--no-binary=:all:", "--only-binary=:all:"]:
        with tempfile.TemporaryDirectory() as files:
            command = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--no-build-isolation", kind, "--dest", files, package]
            subprocess.run(command, capture_output=True, timeout=1800)
            for file in pathlib.Path(files).iterdir():
                unpack(file, part / file.suffix.strip("."))
    part.rename(target)
    return target


def unpack(file, target):
    target.mkdir(parents=True, exist_ok=True)
    if zipfile.is_zipfile(file):
        zipfile.ZipFile(file).extractall(target)
    elif tarfile.is_tarfile(file):
        tarfile.open(file).extractall(target, filter="data")


def kind_of(file):
    """`urdf`, `mjcf`, or None: by the name of the root element."""
    try:
        text = file.read_text(encoding="utf-8", errors="replace")
    except OSError:
        return None
    root = re.search(r"<\s*(mujoco|robot)[\s>]", text)
    if root is None or "xacro:" in text:
        return None
    return {"mujoco": "mjcf", "robot": "urdf"}[root.group(1)]


def models(folder):
    """Every model once, whatever its name."""
    known = set()
    for file in sorted(folder.rglob("*")):
        if file.suffix.lower() not in {".urdf", ".xml", ".mjcf"} or not file.is_file():
            continue
        content = hashlib.sha256(file.read_bytes()).hexdigest()
        kind = kind_of(file)
        if kind and content not in known:
            known.add(content)
            yield kind, file


def oracle(kind, file):
    """The other tool's model, or None where it loads none."""
    try:
        if kind == "mjcf":
            return mujoco.MjModel.from_xml_path(str(file))
        return pinocchio.buildModelFromUrdf(str(file))
    except Exception:
        return None


def moves(kind, model):
    return model is not None and model.nv > 0


def has_mass(kind, model):
    if kind == "mjcf":
        return model.body_mass.sum() > 0
    return sum(inertia.mass for inertia in model.inertias) > 0


def run(kane, *arguments):
    try:
        return subprocess.run([kane, *map(str, arguments)], capture_output=True, text=True, timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        return None


def take(kane, kind, file):
    """What `kane` makes of a model: (result, options, report)."""
    refusal = "took too long"
    for options in [[], *OPTIONS[kind]]:
        ran = run(kane, "info", file, "--json", "--functions", "mass_matrix", *options)
        if ran is not None and ran.returncode == 0:
            return ("taken with an option" if options else "taken"), options, json.loads(ran.stdout)
        if ran is not None and not options:
            first = re.search(r"error: (.*)", ran.stderr)
            refusal = first.group(1) if first else "an exit code of its own"
    return "refused: " + re.sub(r"`[^`]*`|-?\d[\d.e+-]*", "..", refusal)[:80], None, None


def compare(kane, kind, file, options, report, model):
    """The largest relative error of M, inverse and forward dynamics; None where coordinates cannot be matched by joints' names;
    infinite where `kane` evaluates nothing."""
    if "--leave-out" in options:
        # The other tool has the forces that are left out.
        return None
    speeds = sum(len(body["free"]) for body in report["bodies"])
    if speeds != model.nv or any(body["mimics"] for body in report["bodies"]):
        return None
    joints = [body["joint"] for body in report["bodies"]]
    if any(len(body["free"]) != 1 for body in report["bodies"]):
        return None
    generator = numpy.random.default_rng(1)
    q, u, a = (generator.uniform(-1, 1, speeds) for _ in range(3))
    if kind == "mjcf":
        expected = of_mujoco(model, joints, q, u, a)
    else:
        expected = of_pinocchio(model, joints, q, u, a)
    if expected is None:
        return None
    matrix, forces = expected
    state = {"q": list(q), "u": list(u), "u_dot": list(a), "tau": list(forces)}
    # Rotations as they are written, as the others take them.
    options = [*options, "--snap", "0"]
    found = [evaluated(kane, file, name, state, options) for name in ["mass_matrix", "inverse_dynamics", "forward_dynamics"]]
    if any(one is None for one in found):
        return [numpy.inf] * 3
    condition = max(1.0, numpy.linalg.cond(matrix) / 1e4)
    return [
        difference(found[0], matrix),
        difference(found[1], forces),
        difference(found[2], a) / condition,
    ]


def difference(found, expected):
    """Relative to the largest number; not a number stays one."""
    scale = max(numpy.abs(expected).max(), 1e-300)
    return float(numpy.abs(numpy.asarray(found) - expected).max() / scale)


def evaluated(kane, file, function, state, options):
    with tempfile.NamedTemporaryFile("w", suffix=".json") as written:
        json.dump(state, written)
        written.flush()
        ran = run(kane, "eval", file, "--function", function, "--state", written.name, *options)
    if ran is None or ran.returncode != 0:
        return None
    value = json.loads(ran.stdout)
    if isinstance(value, dict):
        value = next(iter(value.values()))
    return numpy.array(value, dtype=float)


def of_mujoco(model, joints, q, u, a):
    ids = [mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, name) for name in joints]
    single = {int(mujoco.mjtJoint.mjJNT_HINGE), int(mujoco.mjtJoint.mjJNT_SLIDE)}
    if any(one < 0 or int(model.jnt_type[one]) not in single for one in ids):
        return None
    # Friction, limits and contacts are data here, and actuators left out.
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONSTRAINT | mujoco.mjtDisableBit.mjDSBL_ACTUATION
    model.opt.density = model.opt.viscosity = 0.0
    data = mujoco.MjData(model)
    places, speeds = model.jnt_qposadr[ids], model.jnt_dofadr[ids]
    data.qpos[places], data.qvel[speeds], data.qacc[speeds] = q, u, a
    mujoco.mj_inverse(model, data)
    matrix = numpy.zeros((model.nv, model.nv))
    for column, unit in zip(matrix, numpy.eye(model.nv)):
        mujoco.mj_mulM(model, data, column, unit)
    return matrix[numpy.ix_(speeds, speeds)], data.qfrc_inverse[speeds].copy()


def of_pinocchio(model, joints, q, u, a):
    ids = [model.getJointId(name) for name in joints]
    if any(one >= model.njoints or model.joints[one].nv != 1 for one in ids):
        return None
    data = model.createData()
    state, speed, change = pinocchio.neutral(model), numpy.zeros(model.nv), numpy.zeros(model.nv)
    speeds = [model.joints[one].idx_v for one in ids]
    for one, position in zip(ids, q):
        joint = model.joints[one]
        state[joint.idx_q] = numpy.cos(position) if joint.nq == 2 else position
        if joint.nq == 2:
            state[joint.idx_q + 1] = numpy.sin(position)
    speed[speeds], change[speeds] = u, a
    forces = pinocchio.rnea(model, data, state, speed, change)
    # A URDF's dampers act here, and not in Pinocchio's recursion.
    forces = forces + model.damping * speed if hasattr(model, "damping") else forces
    matrix = pinocchio.crba(model, data, state)
    matrix = numpy.triu(matrix) + numpy.triu(matrix, 1).T
    return matrix[numpy.ix_(speeds, speeds)], forces[speeds]


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--kane", default="kane", help="the command")
    arguments.add_argument("--folder", type=pathlib.Path, required=True, help="where packages are unpacked")
    arguments.add_argument("packages", nargs="*", help="instead of packages.txt")
    given = arguments.parse_args()
    listed = (pathlib.Path(__file__).parent / "packages.txt").read_text().split()
    results = {kind: collections.Counter() for kind in OPTIONS}
    errors, worst = {kind: [] for kind in OPTIONS}, []
    for package in given.packages or listed:
        for kind, file in models(download(package, given.folder)):
            model = oracle(kind, file)
            if not moves(kind, model):
                continue
            result, options, report = take(given.kane, kind, file)
            if kind == "urdf" and not has_mass(kind, model):
                result = "no link has a mass"
            results[kind][result] += 1
            found = report and compare(given.kane, kind, file, options, report, model)
            if found:
                errors[kind].append(found)
                worst.append((max(found), str(file.relative_to(given.folder))))
    tables(results, errors, worst)


def tables(results, errors, worst):
    for kind, counter in results.items():
        total = sum(counter.values())
        print(f"\n| {kind.upper()}: {total} files that {'MuJoCo' if kind == 'mjcf' else 'Pinocchio'} loads and that move | files |\n| --- | --- |")
        for result, count in counter.most_common():
            print(f"| {result} | {count} |")
    print("\n| compared | files | largest error of M | inverse dynamics | forward dynamics | medians |\n| --- | --- | --- | --- | --- | --- |")
    for kind, found in errors.items():
        if found:
            found = numpy.array(found)
            largest, medians = found.max(axis=0), numpy.median(found, axis=0)
            cells = [f"{error:.1e}" for error in largest] + [", ".join(f"{error:.0e}" for error in medians)]
            print(f"| {kind.upper()} | {len(found)} | {' | '.join(cells)} |")
    beyond = sorted((pair for pair in worst if not pair[0] < 1e-9), reverse=True)
    for error, file in beyond[:20]:
        print(f"\nabove 1e-9: {error:.1e} {file}")


if __name__ == "__main__":
    main()
