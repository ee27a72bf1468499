"""Reference values of MuJoCo for the models of this folder: `reference.json` beside each `NAME/NAME.xml`.

    pip install mujoco==4.0.0
    python tests/mjcf/reference.py

Contacts, limits, dry friction, equalities and actuators are off; armature, damping and springs are on. Random states
have a fixed seed for each model. What the keys mean, and in which order MuJoCo counts, stands in README.md.
"""

import json
import pathlib
import zlib

import mujoco
import numpy as np

# Beyond this many speeds, fewer states: the mass matrix fills the file.
MANY_SPEEDS = 14
# In the order of mjtJoint.
JOINTS = ["free", "ball", "slide", "hinge"]


def model(path):
    model = mujoco.MjModel.from_xml_path(str(path))
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONSTRAINT
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_ACTUATION
    model.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
    return model


def matrix(quaternion):
    flat = np.zeros(9)
    mujoco.mju_quat2Mat(flat, quaternion)
    return flat.reshape(3, 3)


def centers(model, centers, origins):
    """The mass centres; the origin of a body without mass, for which MuJoCo has an arbitrary point."""
    massless = (model.body_mass == 0)[:, None]
    return np.where(massless, origins, centers)


def bodies(model):
    mass_centers = centers(model, model.body_ipos, np.zeros((model.nbody, 3)))
    for body in range(1, model.nbody):
        axes = matrix(model.body_iquat[body])
        inertia = axes @ np.diag(model.body_inertia[body]) @ axes.T
        yield {
            "name": model.body(body).name,
            "parent": int(model.body_parentid[body]),
            "mass": model.body_mass[body],
            "mass_center": mass_centers[body],
            "inertia": inertia[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]],
        }


def joints(model):
    for joint in range(model.njnt):
        yield {
            "name": model.joint(joint).name,
            "body": int(model.jnt_bodyid[joint]),
            "type": JOINTS[model.jnt_type[joint]],
            "qpos": int(model.jnt_qposadr[joint]),
            "qvel": int(model.jnt_dofadr[joint]),
        }


def sites(model):
    """The sites that have names."""
    return [site for site in range(model.nsite) if model.site(site).name]


def quaternion(matrix):
    result = np.zeros(4)
    mujoco.mju_mat2Quat(result, matrix)
    return result


def jacobians(model, data):
    """Of each site, a row for each axis of the world."""
    linear = np.zeros((len(sites(model)), 3, model.nv))
    angular = np.zeros_like(linear)
    for place, site in enumerate(sites(model)):
        mujoco.mj_jacSite(model, data, linear[place], angular[place], site)
    return linear, angular


def lifted(model, data):
    """The potential energy of the forces of `gravcomp`, which MuJoCo leaves out."""
    masses = model.body_gravcomp * model.body_mass
    return masses @ (data.xipos @ model.opt.gravity)


def qpos(model, random):
    values = random.uniform(-1.5, 1.5, model.nq)
    for joint in range(model.njnt):
        start = model.jnt_qposadr[joint]
        kind = JOINTS[model.jnt_type[joint]]
        if kind in ("free", "ball"):
            start += 3 if kind == "free" else 0
            quaternion = random.normal(size=4)
            values[start : start + 4] = quaternion / np.linalg.norm(quaternion)
    return values


def state(model, random):
    data = mujoco.MjData(model)
    data.qpos[:] = qpos(model, random)
    data.qvel[:] = random.normal(size=model.nv)
    data.qfrc_applied[:] = random.normal(size=model.nv) * 3
    mujoco.mj_forward(model, data)
    mass_matrix = np.zeros((model.nv, model.nv))
    mujoco.mj_fullM(model, data, mass_matrix)
    bias = data.qfrc_bias - data.qfrc_passive
    tau = data.qfrc_applied.copy()
    values = {
        "qpos": data.qpos.copy(),
        "qvel": data.qvel.copy(),
        "mass_matrix": mass_matrix,
        "bias": bias,
        "forward": {"tau": tau, "qacc": data.qacc.copy()},
        "xpos": data.xpos[1:].copy(),
        "xquat": data.xquat[1:].copy(),
        "xipos": centers(model, data.xipos, data.xpos)[1:],
        "potential_energy": data.energy[0] + lifted(model, data),
        "kinetic_energy": data.energy[1],
    }
    if sites(model):
        values["site_xpos"] = data.site_xpos[sites(model)]
        values["site_xquat"] = [quaternion(data.site_xmat[site]) for site in sites(model)]
        values["site_jacp"], values["site_jacr"] = jacobians(model, data)
    close(mass_matrix @ data.qacc + bias, tau)
    close(0.5 * data.qvel @ mass_matrix @ data.qvel, data.energy[1])
    data.qacc[:] = random.normal(size=model.nv) * 3
    mujoco.mj_inverse(model, data)
    values["inverse"] = {"qacc": data.qacc.copy(), "tau": data.qfrc_inverse.copy()}
    close(mass_matrix @ data.qacc + bias, data.qfrc_inverse)
    return values


def close(found, expected):
    """The convention M qacc + bias = tau, with gravity, damping and springs in bias."""
    assert np.allclose(found, expected, rtol=1e-9, atol=1e-9), (found, expected)


def plain(value):
    """Lists of Python's floats, whose text reads back to the last bit."""
    if isinstance(value, dict):
        return {key: plain(entry) for key, entry in value.items()}
    if isinstance(value, list):
        return [plain(entry) for entry in value]
    return value.tolist() if isinstance(value, (np.ndarray, np.generic)) else value


def text(value, indent=""):
    """JSON with a list of numbers a line."""
    if isinstance(value, dict):
        inner = indent + " "
        lines = [f"{inner}{json.dumps(key)}: {text(entry, inner)}" for key, entry in value.items()]
        return "{\n" + ",\n".join(lines) + f"\n{indent}}}"
    if isinstance(value, list) and value and isinstance(value[0], (dict, list)):
        inner = indent + " "
        lines = [inner + text(entry, inner) for entry in value]
        return "[\n" + ",\n".join(lines) + f"\n{indent}]"
    return json.dumps(value)


def reference(path):
    m = model(path)
    random = np.random.default_rng(zlib.crc32(path.stem.encode()))
    named = [{"name": m.site(site).name, "body": int(m.site_bodyid[site])} for site in sites(m)]
    return {
        "mujoco": mujoco.__version__,
        "model": path.name,
        "nq": m.nq,
        "nv": m.nv,
        "bodies": list(bodies(m)),
        "joints": list(joints(m)),
        **({"sites": named} if named else {}),
        "states": [state(m, random) for _ in range(8 if m.nv <= MANY_SPEEDS else 4)],
    }


def main():
    folder = pathlib.Path(__file__).parent
    for path in sorted(folder.glob("*/*.xml")):
        if path.stem == path.parent.name:
            output = path.parent / "reference.json"
            output.write_text(text(plain(reference(path))) + "\n")


if __name__ == "__main__":
    main()
