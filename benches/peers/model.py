"""Reads a URDF with Pinocchio and writes what the C++ programs read: MODEL.txt and, for MuJoCo, MODEL.xml.

usage: model.py URDF fixed|free FOLDER SNAP

Text: the name, the number of joints, then for each: parent, kind, name, axis, placement (rotation row by row, origin), mass,
mass centre, inertia about it, all in SI units. Continuous joints are one angle, as in every other candidate. Entries of rotations
that are nearer than SNAP to 0, 1 or -1 are made so.
"""

import re
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pinocchio as pin

GRAVITY = (0.0, 0.0, -9.81)  # m/s^2


def main():
    urdf, base, folder = Path(sys.argv[1]), sys.argv[2], Path(sys.argv[3])
    text = urdf.read_text()
    root = [pin.JointModelFreeFlyer()] if base == "free" else []
    model = pin.buildModelFromXML(text, *root)
    axes = {
        joint.get("name"): numbers(joint.find("axis").get("xyz"))
        for joint in ET.fromstring(text).findall("joint")
        if joint.find("axis") is not None
    }
    for placement in model.jointPlacements:
        placement.rotation = snapped(placement.rotation, float(sys.argv[4]))
    joints = [joint_of(model, i, axes) for i in range(1, model.njoints)]
    lines = [f"{urdf.stem} {len(joints)}"] + [as_text(joint) for joint in joints]
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{urdf.stem}.txt").write_text("\n".join(lines) + "\n")
    (folder / f"{urdf.stem}.xml").write_text(as_mjcf(urdf.stem, joints))


def numbers(text):
    return np.array([float(number) for number in text.split()])


def snapped(rotation, tolerance):
    nearest = np.round(rotation)
    return np.where(np.abs(rotation - nearest) < tolerance, nearest, rotation)


def joint_of(model, i, axes):
    kind = re.sub("^JointModel", "", model.joints[i].shortname())
    kind = kind.replace("RevoluteUnbounded", "Revolute").replace("RUB", "R")
    axis = axes.get(model.names[i], np.array([0.0, 0.0, 1.0]))
    return {
        "parent": model.parents[i],
        "kind": kind,
        "name": model.names[i].replace(" ", "_"),
        "axis": axis / np.linalg.norm(axis),
        "placement": model.jointPlacements[i],
        "body": model.inertias[i],
    }


def shown(*values):
    return " ".join(repr(float(x)) for value in values for x in np.ravel(value))


def as_text(joint):
    placement, body = joint["placement"], joint["body"]
    values = shown(joint["axis"], placement.rotation, placement.translation, body.mass, body.lever, body.inertia)
    return f"{joint['parent']} {joint['kind']} {joint['name']} {values}"


def as_mjcf(name, joints):
    """Bodies without shape; whatever costs time and is not dynamics is off. Refused inertias are balanced by MuJoCo."""

    def body(i):
        joint = joints[i]
        q = pin.Quaternion(joint["placement"].rotation)
        own, inertia = joint["body"], joint["body"].inertia
        moves = "<freejoint/>" if joint["kind"] == "FreeFlyer" else f'<joint axis="{shown(joint["axis"])}"/>'
        entries = inertia[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
        above = "".join(body(k) for k in range(len(joints)) if joints[k]["parent"] == i + 1)
        return (
            f'<body name="{joint["name"]}" pos="{shown(joint["placement"].translation)}" quat="{shown(q.w, q.x, q.y, q.z)}">'
            f'{moves}<inertial pos="{shown(own.lever)}" mass="{shown(own.mass)}" fullinertia="{shown(entries)}"/>{above}</body>\n'
        )

    bodies = "".join(body(i) for i in range(len(joints)) if joints[i]["parent"] == 0)
    flags = " ".join(f'{flag}="disable"' for flag in ("contact", "limit", "constraint", "actuation", "sensor"))
    return (
        f'<mujoco model="{name}"><compiler angle="radian" inertiafromgeom="false" autolimits="false" balanceinertia="true"/>\n'
        f'<option gravity="{shown(GRAVITY)}"><flag {flags}/></option>\n<worldbody>\n{bodies}</worldbody></mujoco>\n'
    )


if __name__ == "__main__":
    main()
