/*** # Creep: what it costs, and where it holds

A vehicle's wheels do more than creep along the track: they also slide sideways, and turn about the
normal of the contact. This page compares the ways to compute the forces of all three motions. The
motions enter without units: the creep along the track as the $X$ of the first page, the lateral
creepage multiplied by the same factor $G\,ab/\mu_cN$, and the spin $\varphi$ as the *dimensionless
spin* $\Phi=G\,(ab)^{3/2}\varphi/\mu_cN$. The answers are two forces, `fx` along and `fy` across, as
fractions of the friction limit $\mu_cN$, and the moment `mz` about the normal, over
$\mu_cN\sqrt{ab}$. These are the ways to compute them:

| name | what it is | for |
|---|---|---|
| full theory | Kalker's exact theory, the solver of the first page, with its estimate and extrapolation | everything |
| table of the full theory | its answers at nodes, interpolated linearly; without spin over $X$ at one a/b, with spin over a/b, both creepages and spin | the range of its nodes |
| shen-hedrick-elkins | a closed formula with Kalker's slopes (Shen, Hedrick and Elkins 1983) | small spin |
| polach | a closed formula with one stiffness and an added force by spin (Polach 1999) | no moment |
| fastsim | Kalker's simplified theory: a place yields to the traction at that place only (1982) | any spin, roughly |
| fastrip | each strip along rolling solved exactly, as a plane contact; the sum is approximate (Sichani, Enblom and Berg 2016) | no spin |
| vermeulen-johnson | a closed formula (1964) with a slope of its own | no spin |
| linear | Kalker's slopes alone, without a limit of friction | small creep |

All but the full theory and the tables have the names of the option `--theory` of `railbook creep`.

## Error against run time

{{include: cost.cpp}}

## Stability

What defeats the solver? A case *holds* when its error stays within the bound set for it. One case
*degrades*: it has two answers, and the solver cannot choose. Errors of forces are fractions of
$\mu_cN$; those of a creep, of a moment and of coefficients are relative.

{{include: stability.cpp}}
*/
