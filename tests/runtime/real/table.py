"""Prints the rows of table.rs: x, then its sine and its cosine as sums of two doubles. Needs mpmath."""

from mpmath import cos, mp, mpf, pi, sin

mp.prec = 400


def two(value):
    head = float(value)
    return head, float(value - mpf(head))


# The doubles below 1e4 that come nearest to a multiple of pi/2, then others where something turns.
near = sorted(range(1, 6367), key=lambda n: abs(mpf(float(n * pi / 2)) - n * pi / 2))[:24]
points = [float(n * pi / 2) for n in sorted(near)]
points += [-355.0, 1.0, 0.5, 100.0, 9999.0, 0.7853981633974483, 0.785398163397448]
points += [2.356194490192345, 5e-324, 1e-300, 1e-9, 2.0**-27, -1.5707963267948966, 8192.0, 16383.5]
for x in points:
    print("    [" + ", ".join(map(repr, (x, *two(sin(mpf(x))), *two(cos(mpf(x)))))) + "],")
