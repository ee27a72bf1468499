"""Motions of frames at 60 digits: `NAME.frames.json` beside `NAME.json`, at the states of that file.

    pip install mpmath==1.3.0
    python tests/reference/frames.py

Only positions are written down: where each body's origin is, and how its axes stand. Jacobians are their differences, with
a step of 1e-20. The speeds are the rates of the coordinates, in the notes' order: all angles, then all translations.
"""

import json
import pathlib

from mpmath import cos, matrix, mp, mpf, sin

mp.dps = 60
STEP = mpf(10) ** -20
MODELS = ["chain3", "star5", "two_roots"]
POINT = [0.3, -0.2, 0.5]
# Offsets along the body's axes, m, and matrices from the body's components to the frame's.
TURNED = [[0.6, 0.8, 0.0], [-0.8, 0.6, 0.0], [0.0, 0.0, 1.0]]
SWAPPED = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
FRAMES = {"hand": (-1, [0.31, -0.22, 0.73], TURNED), "camera": (1, [-0.14, 0.05, 0.42], SWAPPED)}


def about(axis, angle):
    """Components turn the other way than axes."""
    result = matrix(3, 3)
    first, second = (axis + 1) % 3, (axis + 2) % 3
    result[axis, axis] = 1
    result[first, first] = result[second, second] = cos(angle)
    result[first, second], result[second, first] = sin(angle), -sin(angle)
    return result


def bodies(model, q):
    """Of each body the place of its origin, inertial components, and the matrix from its components to inertial ones."""
    number = len(model["lower"])
    placed = []
    for body, lower in enumerate(model["lower"]):
        origin, axes = placed[lower - 1] if lower > 0 else (matrix(3, 1), mp.eye(3))
        angles = q[3 * body : 3 * body + 3]
        moved = q[3 * (number + body) : 3 * (number + body) + 3]
        offset = matrix([mpf(a) + b for a, b in zip(model["bodies"][body]["q"], moved)])
        turned = about(2, angles[2]) * about(1, angles[1]) * about(0, angles[0])
        placed.append((origin + axes * offset, axes * turned.T))
    return placed


def frame(placed, name):
    body, offset, rotation = FRAMES[name]
    origin, axes = placed[body]
    return origin + axes * matrix(offset), axes * matrix(rotation).T


def seen(placed, point, camera):
    """A point of the hand and the axes of the hand, from the inertial frame or from the camera."""
    origin, axes = frame(placed, "hand")
    origin = origin + axes * matrix(point)
    if camera:
        other, from_other = frame(placed, "camera")
        # Its matrix is one of doubles: the inverse is the transpose but for their rounding.
        return from_other.T * (origin - other), from_other.T * axes
    return origin, axes


def columns(model, q, point, camera):
    linear, angular = [], []
    _, axes = seen(bodies(model, q), point, camera)
    for place in range(len(q)):
        sides = []
        for sign in (1, -1):
            moved = list(q)
            moved[place] += sign * STEP
            sides.append(seen(bodies(model, moved), point, camera))
        (after, turned), (before, back) = sides
        linear.append((after - before) / (2 * STEP))
        spin = (turned - back) / (2 * STEP) * axes.T
        angular.append([spin[2, 1], spin[0, 2], spin[1, 0]])
    rows = [[column[row] for column in linear] for row in range(3)]
    return rows + [[column[row] for column in angular] for row in range(3)]


def case(model, state):
    q = [mpf(x) for x in sum(state["theta"], []) + sum(state["s"], [])]
    values = {}
    for suffix, camera in (("", False), (", camera", True)):
        origin, axes = seen(bodies(model, q), [0, 0, 0], camera)
        rotation = [axes[column, row] for row in range(3) for column in range(3)]
        values[f"pose(hand{suffix})"] = rotation + list(origin)
        values[f"jacobian(hand{suffix})"] = sum(columns(model, q, [0, 0, 0], camera), [])
        values[f"point_jacobian(hand{suffix})"] = sum(columns(model, q, POINT, camera), [])
    return {name: [float(x) for x in numbers] for name, numbers in values.items()}


def main():
    folder = pathlib.Path(__file__).parent
    for name in MODELS:
        reference = json.loads((folder / f"{name}.json").read_text())
        cases = [case(reference["model"], one["state"]) for one in reference["cases"]]
        lines = [f"  {json.dumps(key)}: {json.dumps(own[key])}" for own in cases for key in own]
        size = len(cases[0])
        groups = [",\n".join(lines[k : k + size]) for k in range(0, len(lines), size)]
        text = "[\n" + ",\n".join(f" {{\n{group}\n }}" for group in groups) + "\n]\n"
        (folder / f"{name}.frames.json").write_text(text)


if __name__ == "__main__":
    main()
