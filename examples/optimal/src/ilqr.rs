//! Trajectories by iterated linear-quadratic regulators, with limits of the forces.
//!
//! A motion is a state a node and forces between them. Each iteration takes the derivatives `A`, `B` of every step, goes back from the
//! end with a quadratic model of the cost that is left, which gives new forces and how they answer to the state, and drives the
//! system with these. Forces stay within their limits: where one holds, the step is that of a quadratic cost between limits
//! ([`bounded_quadratic`](super::bounded_quadratic)), and there is no answer to the state. States are compared on their manifold,
//! so quaternions are no different.

use kane::discrete::StepDerivatives;
use kane::functions::{ForwardDynamics, ForwardDynamicsAndDerivatives};
use kane::manifold::q_minus;
use kane::{System, view};
use nalgebra::{SMatrix, SVector};

use super::bounded_quadratic::minimum;

/// A system with `N` speeds, as the optimiser wants it.
pub trait Differentiable<const N: usize>:
    System<f64, U = [f64; N]>
    + ForwardDynamics<f64>
    + ForwardDynamicsAndDerivatives<f64, Matrix = [[f64; N]; N]>
{
}

impl<S, const N: usize> Differentiable<N> for S where
    S: System<f64, U = [f64; N]>
        + ForwardDynamics<f64>
        + ForwardDynamicsAndDerivatives<f64, Matrix = [[f64; N]; N]>
{
}

/// A step: `(system, tau, dt, q, u)`.
pub type Step<S, const N: usize> =
    fn(&S, &[f64; N], f64, &mut <S as System<f64>>::Q, &mut [f64; N]);

/// A step with its derivatives.
pub type Linearized<S, const N: usize> = fn(
    &S,
    &[f64; N],
    f64,
    (&mut <S as System<f64>>::Q, &mut [f64; N]),
    &mut StepDerivatives<[[f64; N]; N]>,
);

/// A cost near a node: gradients and Hessians by the change of the state, `q` before `u`, and by the forces.
#[derive(Clone, Copy, Debug)]
pub struct Quadratic<const N2: usize, const M: usize> {
    /// By the state.
    pub x: SVector<f64, N2>,
    /// Twice by the state.
    pub xx: SMatrix<f64, N2, N2>,
    /// By the forces.
    pub f: SVector<f64, M>,
    /// Twice by the forces.
    pub ff: SMatrix<f64, M, M>,
}

/// What is to be small: of each node's state and forces, and of the last state, where there are none.
pub trait Cost<S: System<f64>, const N2: usize, const M: usize> {
    /// The cost of a node.
    fn of(&self, state: (&S::Q, &S::U), forces: Option<&SVector<f64, M>>) -> f64;
    /// The same nearby.
    fn near(&self, state: (&S::Q, &S::U), forces: Option<&SVector<f64, M>>) -> Quadratic<N2, M>;
}

/// States, and the forces that lead from each to the next.
#[derive(Clone, Debug)]
pub struct Motion<Q, U, const M: usize> {
    /// One more than there are forces.
    pub states: Vec<(Q, U)>,
    /// N m, N.
    pub forces: Vec<SVector<f64, M>>,
}

/// What is optimised.
#[derive(Debug)]
pub struct Ilqr<'s, S: Differentiable<N>, C, const N: usize, const M: usize> {
    /// The system.
    pub system: &'s S,
    /// What is to be small.
    pub cost: C,
    /// The time of a step, s.
    pub dt: f64,
    /// The speeds along which forces act.
    pub actuated: [usize; M],
    /// Their greatest magnitudes, N m, N.
    pub limits: SVector<f64, M>,
    /// A step.
    pub step: Step<S, N>,
    /// The same with its derivatives.
    pub linearized: Linearized<S, N>,
}

/// What a backward pass finds for a node: the change of forces, and how they answer to changes of the state.
struct Answer<const N2: usize, const M: usize> {
    feedforward: SVector<f64, M>,
    feedback: SMatrix<f64, M, N2>,
}

/// How a step changes with the state and with the forces.
type Changes<const N2: usize, const M: usize> = (SMatrix<f64, N2, N2>, SMatrix<f64, N2, M>);

impl<S: Differentiable<N>, C, const N: usize, const M: usize> Ilqr<'_, S, C, N, M> {
    fn tau(&self, forces: &SVector<f64, M>) -> [f64; N] {
        let mut tau = [0.0; N];
        for (place, force) in self.actuated.into_iter().zip(forces) {
            tau[place] = *force;
        }
        tau
    }

    fn cut(&self, forces: SVector<f64, M>) -> SVector<f64, M> {
        forces.zip_map(&self.limits, |force, limit| force.clamp(-limit, limit))
    }

    /// The motion from a state under these forces, as far as limits let them.
    pub fn driven(&self, start: (S::Q, S::U), forces: &[SVector<f64, M>]) -> Motion<S::Q, S::U, M> {
        self.rolled(start, forces.len(), |node, _, _| forces[node])
    }

    /// The motion of so many steps, where `forces(node, q, u)` are cut at their limits.
    fn rolled(
        &self,
        start: (S::Q, S::U),
        n_steps: usize,
        mut forces: impl FnMut(usize, &S::Q, &S::U) -> SVector<f64, M>,
    ) -> Motion<S::Q, S::U, M> {
        let mut motion = Motion {
            states: vec![start],
            forces: Vec::with_capacity(n_steps),
        };
        let (mut q, mut u) = start;
        for node in 0..n_steps {
            let forces = self.cut(forces(node, &q, &u));
            (self.step)(self.system, &self.tau(&forces), self.dt, &mut q, &mut u);
            motion.states.push((q, u));
            motion.forces.push(forces);
        }
        motion
    }

    /// Iterates until the cost falls by less than this part of it, or so many times.
    pub fn optimize<const N2: usize>(
        &self,
        motion: &mut Motion<S::Q, S::U, M>,
        (part, most): (f64, usize),
    ) where
        C: Cost<S, N2, M>,
    {
        let mut damping = 0.0;
        let mut cost = self.total(motion);
        for _ in 0..most {
            let before = cost;
            cost = self.improve(motion, cost, &mut damping);
            let is_stuck = damping > 1e8;
            if is_stuck || (damping == 0.0 && before - cost <= part * before) {
                break;
            }
        }
    }

    /// The cost of a motion.
    pub fn total<const N2: usize>(&self, motion: &Motion<S::Q, S::U, M>) -> f64
    where
        C: Cost<S, N2, M>,
    {
        let nodes = motion.states.iter().enumerate();
        let costs = nodes.map(|(node, (q, u))| self.cost.of((q, u), motion.forces.get(node)));
        costs.sum()
    }

    /// One iteration: a motion with a lower cost takes the place of this one; where there is none, damping grows.
    pub fn improve<const N2: usize>(
        &self,
        motion: &mut Motion<S::Q, S::U, M>,
        cost: f64,
        damping: &mut f64,
    ) -> f64
    where
        C: Cost<S, N2, M>,
    {
        let changes = self.changes(motion);
        if let Some(answers) = self.answers(motion, &changes, *damping) {
            let mut part = 1.0;
            for _ in 0..10 {
                let other = self.followed(motion, &answers, part);
                let own = self.total(&other);
                if own < cost {
                    *motion = other;
                    *damping = if *damping > 1e-6 {
                        *damping / 10.0
                    } else {
                        0.0
                    };
                    return own;
                }
                part *= 0.5;
            }
        }
        *damping = (*damping * 10.0).max(1e-6);
        cost
    }

    /// The derivatives of every step.
    fn changes<const N2: usize>(&self, motion: &Motion<S::Q, S::U, M>) -> Vec<Changes<N2, M>> {
        let mut of_step = StepDerivatives::filled([[0.0; N]; N]);
        let nodes = motion.states.iter().zip(&motion.forces);
        let of_node = |((q, u), forces): (&(S::Q, S::U), &SVector<f64, M>)| {
            let (mut q, mut u) = (*q, *u);
            let state = (&mut q, &mut u);
            (self.linearized)(self.system, &self.tau(forces), self.dt, state, &mut of_step);
            let a = view::step_by_state(&of_step);
            let b: SMatrix<f64, N2, N> = view::step_by_tau(&of_step);
            (a, SMatrix::from_fn(|i, j| b[(i, self.actuated[j])]))
        };
        nodes.map(of_node).collect()
    }

    /// Goes back from the end; `None` where the cost is not convex by some forces.
    fn answers<const N2: usize>(
        &self,
        motion: &Motion<S::Q, S::U, M>,
        changes: &[Changes<N2, M>],
        damping: f64,
    ) -> Option<Vec<Answer<N2, M>>>
    where
        C: Cost<S, N2, M>,
    {
        let (q, u) = motion.states.last()?;
        let Quadratic { mut x, mut xx, .. } = self.cost.near((q, u), None);
        let mut answers = Vec::with_capacity(changes.len());
        let nodes = motion.states.iter().zip(&motion.forces).zip(changes);
        for (((q, u), forces), (a, b)) in nodes.rev() {
            let near = self.cost.near((q, u), Some(forces));
            let (xx_a, xx_b) = (xx * a, xx * b);
            let of_f = near.f + b.transpose() * x;
            let of_x = near.x + a.transpose() * x;
            let ff = near.ff + b.transpose() * xx_b;
            let fx: SMatrix<f64, M, N2> = b.transpose() * xx_a;
            let damped = ff + SMatrix::identity() * damping;
            let own = minimum(
                &damped,
                &of_f,
                &(-self.limits - forces),
                &(self.limits - forces),
            )?;
            let feedback = -own.solve(fx);
            let feedforward = own.x;
            x = of_x
                + feedback.transpose() * (ff * feedforward + of_f)
                + fx.transpose() * feedforward;
            let half = near.xx
                + a.transpose() * xx_a
                + feedback.transpose() * (ff * feedback + fx)
                + fx.transpose() * feedback;
            xx = 0.5 * (half + half.transpose());
            answers.push(Answer {
                feedforward,
                feedback,
            });
        }
        answers.reverse();
        Some(answers)
    }

    /// The motion with a part of the new forces, and all of the answers.
    fn followed<const N2: usize>(
        &self,
        motion: &Motion<S::Q, S::U, M>,
        answers: &[Answer<N2, M>],
        part: f64,
    ) -> Motion<S::Q, S::U, M> {
        self.rolled(motion.states[0], answers.len(), |node, q, u| {
            let (q_before, u_before) = &motion.states[node];
            let away = q_minus(self.system, q_before, q);
            let away: SVector<f64, N2> = SVector::from_fn(|i, _| {
                if i < N {
                    away[i]
                } else {
                    u[i - N] - u_before[i - N]
                }
            });
            let Answer {
                feedforward,
                feedback,
            } = &answers[node];
            motion.forces[node] + part * feedforward + feedback * away
        })
    }
}
