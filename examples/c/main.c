/* The forward dynamics of a pole on a cart and the inverse dynamics of a Panda, over some states.
   A line a result, with digits enough to read every bit back. */

#include <stddef.h>
#include <stdio.h>

#include "cart_pole.h"
#include "panda.h"

static const int n_states = 5;

/* Without a pattern, between -2 and 2, and without rounding in either precision. */
static double entry(int state, int place)
{
    return ((7 * state + 5 * place) % 17 - 8) / 4.0;
}

static void print_f64(const char *name, size_t n, const double *values)
{
    printf("%s", name);
    for (size_t i = 0; i < n; i++) {
        printf(" %.17g", values[i]);
    }
    printf("\n");
}

static void print_f32(const char *name, size_t n, const float *values)
{
    printf("%s", name);
    for (size_t i = 0; i < n; i++) {
        printf(" %.17g", (double)values[i]);
    }
    printf("\n");
}

static void cart_pole_f64(int state)
{
    cart_pole_parameters_f64 parameters;
    cart_pole_nominal_f64(&parameters);
    parameters.pole_mass = 0.55; /* measured today */
    cart_pole_prepared_f64 p;
    cart_pole_prepare_f64(&parameters, &p);

    double q[CART_POLE_NQ], u[CART_POLE_NU], tau[CART_POLE_NU];
    for (int i = 0; i < CART_POLE_NU; i++) {
        q[i] = entry(state, i);
        u[i] = entry(state, i + 10);
        tau[i] = 0.0;
    }
    tau[CART_POLE_U_CART_S1_DOT] = 3.0; /* the motor moves the cart alone */

    double m[CART_POLE_NU * CART_POLE_NU], u_dot[CART_POLE_NU], f[CART_POLE_NU], bias[CART_POLE_NU];
    cart_pole_mass_matrix_f64(&p, q, m);
    cart_pole_forward_dynamics_f64(&p, q, u, tau, u_dot);
    print_f64("mass_matrix", CART_POLE_NU * CART_POLE_NU, m);
    print_f64("forward_dynamics", CART_POLE_NU, u_dot);

    kane_load_f64 loads[CART_POLE_NB] = {{{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}, {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}};
    loads[CART_POLE_BODY_POLE].force[0] = 2.0;
    loads[CART_POLE_BODY_POLE].moment[1] = -1.0;
    cart_pole_forcing_f64(&p, q, u, loads, f);
    print_f64("forcing", CART_POLE_NU, f);

    cart_pole_sines_cosines_f64 sin_cos;
    cart_pole_sin_cos_f64(&p, q, &sin_cos);
    cart_pole_bias_at_sin_cos_f64(&p, q, &sin_cos, u, bias);
    print_f64("bias_at_sin_cos", CART_POLE_NU, bias);
}

static void panda_f64(int state)
{
    panda_parameters_f64 parameters;
    panda_nominal_f64(&parameters);
    panda_prepared_f64 p;
    panda_prepare_f64(&parameters, &p);

    double q[PANDA_NQ], tau[PANDA_NU];
    for (int i = 0; i < PANDA_NQ; i++) {
        q[i] = entry(state, i);
    }
    panda_gravity_forces_f64(&p, q, tau);
    print_f64("gravity_forces", PANDA_NU, tau);
}

static void panda_f32(int state)
{
    panda_parameters_f32 parameters;
    panda_nominal_f32(&parameters);
    panda_prepared_f32 p;
    panda_prepare_f32(&parameters, &p);

    float q[PANDA_NQ], tau[PANDA_NU];
    for (int i = 0; i < PANDA_NQ; i++) {
        q[i] = (float)entry(state, i);
    }
    panda_gravity_forces_f32(&p, q, tau);
    print_f32("gravity_forces_f32", PANDA_NU, tau);
}

int main(void)
{
    for (int state = 0; state < n_states; state++) {
        cart_pole_f64(state);
        panda_f64(state);
        panda_f32(state);
    }
    return 0;
}
