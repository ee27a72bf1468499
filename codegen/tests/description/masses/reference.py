"""Writes reference.json: mass matrices of the robots beside this file, by Pinocchio (`pip install pin`)."""

import json
from pathlib import Path

import numpy
import pinocchio

HERE = Path(__file__).parent


def mass_matrix(model, q):
    upper = numpy.triu(pinocchio.crba(model, model.createData(), numpy.array(q)))
    return (upper + numpy.triu(upper, 1).T).tolist()


def reference(name):
    model = pinocchio.buildModelFromUrdf(str(HERE / f"{name}.urdf"))
    states = numpy.random.default_rng(1).uniform(-1.5, 1.5, (3, model.nq)).round(3).tolist()
    return [{"q": q, "mass_matrix": mass_matrix(model, q)} for q in states]


names = ["negative", "tiny", "without_mass"]
text = json.dumps({name: reference(name) for name in names}, indent=1)
(HERE / "reference.json").write_text(text + "\n")
