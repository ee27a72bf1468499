//! How functions for C call the steps of the runtime crate.

use proc_macro2::TokenStream;
use quote::quote;

use super::text::ident;
use crate::steps::{Condition, Step, Way};

/// The call of a step. What it reads is copied before it writes, where both may be at the same place.
pub(super) fn call(step: Step) -> TokenStream {
    let (module, way) = (ident(step.scheme.module()), ident(step.way.function()));
    let system = match step.condition {
        Condition::Free => quote!(&*p),
        Condition::Loaded => quote!(&kane::conditions::Loaded {
            system: &*p,
            loads: *loads
        }),
        Condition::Driven => quote!(&kane::conditions::Driven {
            system: &*p,
            u_dot: *u_dot
        }),
    };
    let call =
        |others: TokenStream| quote!(kane::discrete::#module::#way(#system, &*tau, *dt, #others););
    let begin = quote! {
        q_after.write(*q);
        u_after.write(*u);
    };
    match step.way {
        Way::Step => {
            let call = call(quote!(&mut *q_after, &mut *u_after));
            quote!(#begin #call)
        }
        Way::Linearized => linearized(&begin, &call(quote!(state, &mut derivatives))),
        Way::Forward => forward(&begin, &call(quote!(state, (&mut change, &*tau_direction)))),
        Way::ForwardWithParameters => {
            let changes = quote!((&mut change, &*tau_direction, &*parameters_direction));
            forward(&begin, &call(quote!(state, #changes)))
        }
        Way::Adjoint => adjoint(&call(quote!(
            (&*q, &*u),
            (&mut multiplier, &mut *tau_gradient)
        ))),
        Way::AdjointWithParameters => {
            let gradients = quote!((
                &mut multiplier,
                &mut *tau_gradient,
                &mut *parameters_gradient
            ));
            adjoint(&call(quote!((&*q, &*u), #gradients)))
        }
        Way::ByParameters => {
            let call = call(quote!((&*q, &*u), &mut by));
            quote! {
                let mut by = kane::discrete::StepByParameters::filled([[0.0; PARAMETERS_LEN]; NU]);
                #call
                q_by_parameters.write(by.q);
                u_by_parameters.write(by.u);
            }
        }
    }
}

/// The blocks of derivatives become rows of `a` and `b`. No row is found by its place: where the compiler keeps the check, C could panic.
fn linearized(begin: &TokenStream, call: &TokenStream) -> TokenStream {
    quote! {
        #begin
        let mut derivatives = kane::discrete::StepDerivatives::filled([[0.0; NU]; NU]);
        let state = (&mut *q_after, &mut *u_after);
        #call
        let rows = |left: &[[_; NU]; NU], right: &[[_; NU]; NU]| {
            let mut rows = [[[0.0; NU]; 2]; NU];
            for (row, both) in rows.iter_mut().zip(left.iter().zip(right)) {
                *row = [*both.0, *both.1];
            }
            rows
        };
        a.cast::<[[[[_; NU]; 2]; NU]; 2]>().write([
            rows(&derivatives.q_by_q, &derivatives.q_by_u),
            rows(&derivatives.u_by_q, &derivatives.u_by_u),
        ]);
        b.cast::<[[[_; NU]; NU]; 2]>().write([derivatives.q_by_tau, derivatives.u_by_tau]);
    }
}

fn forward(begin: &TokenStream, call: &TokenStream) -> TokenStream {
    quote! {
        #begin
        let mut change = kane::discrete::Change { q: *q_direction, u: *u_direction };
        let state = (&mut *q_after, &mut *u_after);
        #call
        q_direction_after.write(change.q);
        u_direction_after.write(change.u);
    }
}

fn adjoint(call: &TokenStream) -> TokenStream {
    quote! {
        let mut multiplier = kane::discrete::Change { q: *q_multiplier, u: *u_multiplier };
        #call
        q_gradient.write(multiplier.q);
        u_gradient.write(multiplier.u);
    }
}
