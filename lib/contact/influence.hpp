// What a constant pressure on one cell does at a field point: the integral of dA/r over the cell,
// eq. (15).
#pragma once

namespace railbook::contact {

// g(X, Y) = X asinh(Y/|X|) + Y asinh(X/|Y|): the corner function whose four signed corner values
// make up the integral of dA/r over a rectangle [m]; odd in X and in Y, 0 when either is 0. The
// form with asinh keeps its digits for slender cells; the textbook form ln(Y + r) loses all of them
// when Y is negative and |X| << |Y|. Relative accuracy 2e-15. X^2 and Y^2 must not under- or
// overflow: 1e-150 to 1e150.
double corner_function(double x, double y);

// The integral of dA/r over the rectangle [x1, x2] x [y1, y2] [m], seen from the origin (which may
// lie inside, on an edge or outside): eq. (15) in closed form (Love 1929). Relative accuracy 3e-15
// D^2/A for a cell of area A whose farthest corner is at distance D, and 1e-15 at its own centre
// whatever its slenderness.
double rectangle_influence(double x1, double x2, double y1, double y2);

// The integral of dA/r over a disc of radius c >= 0 [m], seen from a point of its plane at r >= 0
// from its centre: 4 c E(r/c) inside, 4 r (E(c/r) - (1 - c^2/r^2) K(c/r)) outside (Johnson, Contact
// Mechanics, 1985). Relative accuracy 5e-15, at the edge and beside it too.
double disc_influence(double c, double r);

}  // namespace railbook::contact
