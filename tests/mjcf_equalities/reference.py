"""What MuJoCo computes for `tied.xml` in the coordinates `a` and `f`, which its equalities leave: `reference.json`.

    pip install mujoco==4.0.0
    python tests/mjcf_equalities/reference.py

Fluid, the tendon's forces and the constraint solver are off. The states obey the equalities, which the solver's own
residual says; mass matrix and bias are those of MuJoCo, projected: `J^T M J`, `J^T (qfrc_bias - qfrc_passive)`.
"""

import json
import pathlib

import mujoco
import numpy as np

# How far each joint is from the reference pose, by the displacements of `a` and `f` and a constant.
B = np.array([-0.5, 0.0, 0.1])
C = (B - [0, 0, 0.2]) / 2
D = np.array([0, 0, 0.3])
E = np.array([0, 0, 0.1 + 0.4 * 0.3])
MOVED = np.array([[1, 0, 0], B, C, D, E, [0, 1, 0]])


def main():
    folder = pathlib.Path(__file__).parent
    model = mujoco.MjModel.from_xml_path(str(folder / "tied.xml"))
    model.opt.density = model.opt.viscosity = 0
    model.tendon_stiffness[:] = model.tendon_damping[:] = 0
    random = np.random.default_rng(7)
    jacobian = MOVED[:, :2]
    states = []
    for _ in range(4):
        data = mujoco.MjData(model)
        moved, speeds = random.uniform(-1.5, 1.5, 2), random.normal(size=2)
        data.qpos[:] = model.qpos0 + MOVED @ [*moved, 1]
        data.qvel[:] = jacobian @ speeds
        mujoco.mj_forward(model, data)
        # The first four equalities are those between joints, one row each.
        residual = [data.efc_pos[row] for row in range(data.ne) if data.efc_id[row] < 4]
        assert len(residual) == 4 and np.abs(residual).max() < 1e-14, residual
        mass_matrix = np.zeros((model.nv, model.nv))
        mujoco.mj_fullM(model, data, mass_matrix)
        bias = data.qfrc_bias - data.qfrc_passive
        states.append(
            {
                "q": (model.qpos0[[0, 5]] + moved).tolist(),
                "u": speeds.tolist(),
                "mass_matrix": (jacobian.T @ mass_matrix @ jacobian).flatten().tolist(),
                "bias": (jacobian.T @ bias).tolist(),
            }
        )
    (folder / "reference.json").write_text(json.dumps(states, indent=1) + "\n")


if __name__ == "__main__":
    main()
