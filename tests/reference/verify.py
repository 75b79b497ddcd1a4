#!/usr/bin/env python3
"""Writes tools/verify/data/*.csv: the reference numbers of `railbook verify` (python3-mpmath).

Closed forms are evaluated here with 40 digits; printed tables are copied from where their source
says. Nothing of lib/ is used. With --check the files are compared with what would be written.
"""
import csv
import io
import pathlib
import sys

from mpmath import mp, mpf

mp.dps = 40
root = pathlib.Path(__file__).resolve().parents[2]
data = root / "tools/verify/data"
files = {}


def group(name, title, source, rows):
    """rows: (of, inputs, expected, allowed deviation), the last two in the unit of the value."""
    text = io.StringIO()
    text.write(f"# {title}\n# {source}\n")
    out = csv.writer(text, lineterminator="\n")
    out.writerow(["of", "at", "expected", "within"])
    for of, at, expected, within in rows:
        shown = expected if isinstance(expected, str) else mp.nstr(expected, 17)
        out.writerow([of, " ".join(str(x) for x in at), shown, mp.nstr(mpf(within), 3)])
    files[name] = text.getvalue()


# Hertz: B/A from m1 = (b/a)^2, by the integrals of the complementary parameter.
def hertz():
    rows = []
    for ratio in ["1", "0.8", "0.6", "0.5", "0.4", "0.3", "0.2", "0.15", "0.1", "0.07", "0.05", "0.03",
                  "0.02", "0.01", "0.005", "0.002", "0.001", "0.0003", "0.0001", "0.00001"]:
        k2 = mpf(ratio) ** 2  # b/a of the ellipse, squared
        m = 1 - k2
        big_k, big_e = mp.ellipk(m), mp.ellipe(m)
        if m == 0:
            d = b = mp.pi / 4
        else:
            d, b = (big_k - big_e) / m, (big_e - k2 * big_k) / m
        # p0/(...) : A = p0 b D/(E* a^2) * ..., with p = p0 sqrt(1 - x^2/a^2 - y^2/b^2) (Johnson, 1985, ch. 4):
        # A = (p0/E*) (b/a^2) D, B = (p0/E*) (1/b) Bc, delta = (p0/E*) b K.
        a, modulus = mpf("0.006"), mpf("1.15e11")
        axis_b, p0 = a * mp.sqrt(k2), mpf("1e9")
        A, B = p0 / modulus * axis_b / a**2 * d, p0 / modulus / axis_b * b
        delta, force = p0 / modulus * axis_b * big_k, 2 * mp.pi / 3 * a * axis_b * p0
        inputs = [mp.nstr(v, 17) for v in (A, B, modulus, force)]
        # The inputs are rounded to 17 digits: what that changes is far below the tolerance.
        for of, value in (("hertz-a", a), ("hertz-b", axis_b), ("hertz-approach", delta), ("hertz-pressure", p0)):
            rows.append((of, inputs, value, abs(value) * mpf("1e-12")))
    group("hertz", "Hertz's contact", "closed form with complete elliptic integrals; Johnson, Contact Mechanics, 1985, ch. 4", rows)


def cells():
    rows = []
    modulus = mpf("1.1e11")
    for radius in ("0.01", "0.3", "2"):
        for approach in ("1e-6", "2e-5"):
            R, d = mpf(radius), mpf(approach)
            inputs = [radius, "1.1e11", approach]
            rows.append(("sphere-force", inputs, f := 4 * modulus * mp.sqrt(R) * d ** mpf("1.5") / 3, f * mpf("2e-4")))
            rows.append(("sphere-pressure", inputs, p := 2 * modulus / mp.pi * mp.sqrt(d / R), p * mpf("2e-3")))
    group("cells", "Normal contact by cells", "spheres in closed form, Hertz 1882", rows)


def beam():
    rows = []
    for stiffness, modulus in (("6.4e6", "1.4e7"), ("4e6", "3e7")):
        ei, k, p = mpf(stiffness), mpf(modulus), mpf("1e5")
        beta = (k / (4 * ei)) ** mpf("0.25")
        for x in ("0", "0.2", "0.5", "0.9", "1.4", "2", "2.7", "3.5", "4.4", "5.5", "7", "9"):
            xi = beta * mpf(x)
            e, s, c = mp.exp(-xi), mp.sin(xi), mp.cos(xi)
            largest = (p * beta / (2 * k), p * beta**2 / k, p / (4 * beta), p / 2)
            shapes = (e * (c + s), e * s, e * (c - s), e * c)
            for of, scale, shape in zip(("beam-deflection", "beam-slope", "beam-moment", "beam-shear"), largest, shapes):
                if x == "0" and of == "beam-shear":
                    continue  # a jump
                rows.append((of, [stiffness, modulus, "1e5", x], scale * shape, scale * mpf("1e-13")))
        rows.append(("beam-stiffness", [stiffness, modulus], v := 2 * k / beta, v * mpf("1e-14")))
        rows.append(("critical-speed", [stiffness, modulus, "65"], v := (4 * ei * k / mpf(65) ** 2) ** mpf("0.25"), v * mpf("1e-14")))
    for theta in ("0.1", "0.3", "0.5", "0.7", "0.9", "0.99"):
        rows.append(("amplification", [theta], v := 1 / mp.sqrt(1 - mpf(theta) ** 2), v * mpf("1e-12")))
    group("beam", "Beam on an elastic foundation", "closed forms; Hetenyi, Beams on Elastic Foundation, 1946", rows)


def filters():
    rows = []
    for chord in ("9.4488", "18.8976"):
        for wave in ("2.5", "4", "7", "11.8872", "20", "50", "200"):
            phi = 1 / mpf(wave)
            rows.append(("chord-gain", [chord, mp.nstr(phi, 17)], 1 - mp.cos(mp.pi * mpf(chord) * phi), mpf("1e-14")))
    for samples in (2, 5, 24, 151):
        for theta in ("0.01", "0.1", "0.7", "2"):
            t = mpf(theta) / 2
            rows.append(("mean-gain", [samples, theta], mp.sin(samples * t) / (samples * mp.sin(t)), mpf("1e-14")))
    for name, short, long in (("D0", 1, 5), ("D1", 3, 25), ("D2", 25, 70), ("D3", 70, 150)):
        low, high = 1 / mpf(long), 1 / mpf(short)
        for passes in (1, 2):
            edge = 1 / mp.sqrt(2) if passes == 1 else mpf(1) / 2
            rows.append(("band-gain", [name, passes, mp.nstr(low, 17)], edge, mpf("1e-13")))
            rows.append(("band-gain", [name, passes, mp.nstr(high, 17)], edge, mpf("1e-13")))
            # Poles of Butterworth's low-pass of order 4, moved to the band (Oppenheim and Schafer).
            for factor in ("0.6", "0.9", "1", "1.3", "1.8"):
                phi = mpf(factor) * mp.sqrt(low * high)
                s = 1j * (phi**2 - low * high) / (phi * (high - low))
                poles = [mp.expjpi(mpf(2 * n + 5) / 8) for n in range(4)]
                gain = abs(1 / mp.fprod(s - pole for pole in poles))
                rows.append(("band-gain", [name, passes, mp.nstr(phi, 17)], gain**passes, mpf("1e-13")))
    group("filters", "Filters of track geometry", "closed forms: chord, mean, Butterworth's poles", rows)


def vehicle():
    rows = []
    for frequency, damping in (("0.5", "0.2"), ("1", "0.1"), ("2", "0.5")):
        for f in ("0.1", "0.4", "0.5", "0.9", "1.5", "3", "10"):
            r, z = mpf(f) / mpf(frequency), mpf(damping)
            value = r**2 / abs(mp.mpc(1 - r**2, 2 * z * r))
            rows.append(("stroke-gain", [frequency, damping, f], value, value * mpf("1e-14")))
    for z in ("0.05", "0.1", "0.2", "0.3", "0.5"):
        rows.append(("stroke-peak", [z], v := 1 / (2 * mpf(z) * mp.sqrt(1 - mpf(z) ** 2)), v * mpf("1e-14")))
    group("vehicle", "A body on its suspension", "closed form of the oscillator on a moving base; Den Hartog, Mechanical Vibrations", rows)


def mathematics():
    rows = []
    for x in ("0.01", "0.5", "1", "2", "3.5", "7", "12", "30", "100"):
        rows.append(("sine-integral", [x], v := mp.si(mpf(x)), abs(v) * mpf("2e-15")))
    for alpha in ("0.5", "1", "2", "3", "4", "6"):
        rows.append(("normal-exceedance", [alpha], v := mp.erfc(mpf(alpha) / mp.sqrt(2)), v * mpf("1e-14")))
    for log_m1 in ("-0.01", "-0.5", "-2", "-10", "-40", "-100", "-300"):
        m1 = mp.exp(mpf(log_m1))
        with mp.workdps(200):
            big_k, big_e = mp.ellipk(1 - mp.exp(mpf(log_m1))), mp.ellipe(1 - mp.exp(mpf(log_m1)))
            d = (big_k - big_e) / (1 - m1)
        rows.append(("elliptic-k", [log_m1], +big_k, big_k * mpf("4e-15")))
        rows.append(("elliptic-d", [log_m1], +d, d * mpf("1e-14")))
    group("mathematics", "Special functions", "mpmath, 40 digits", rows)


def carter():
    rows = []
    for x in ("0.05", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1.2"):
        u = min(mpf(1), mpf(x))
        rows.append(("carter-force", [x], u * (2 - u), mpf("5e-4")))
        rows.append(("carter-stick", [x], 1 - u, mpf("0.011")))
    for q in ("0.2", "0.4", "0.6", "0.8"):
        left = (1 - mpf(q)) ** (mpf(2) / 3)
        # Cells are counted, 47 across 2.2 a: half a cell all round the circle that sticks.
        rows.append(("cattaneo-stick", [q], left, mp.sqrt(left) * mpf("2.2") / 47))
        rows.append(("cattaneo-shift", [q], 1 - left, mpf("0.006")))
    for t in ("0.1", "0.3", "0.7", "1", "1.5", "2", "2.5", "2.9", "3.5"):
        u = min(mpf(1), mpf(t) / 3)
        rows.append(("vermeulen-johnson", [t], 1 - (1 - u) ** 3, mpf("1e-13")))
    group("rolling", "Rolling and sliding with friction",
          "closed forms: Carter 1926, Cattaneo 1938 and Mindlin 1949, Vermeulen and Johnson 1964", rows)


# C11, C22, C23, C33, each at Poisson's ratio 0, 1/4, 1/2: Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, 1990.
KALKER = """
0.1 2.51 3.31 4.85 2.51 2.52 2.53 .334 .473 .731 6.42 8.28 11.7
0.2 2.59 3.37 4.81 2.59 2.63 2.66 .483 .603 .809 3.46 4.27 5.66
0.3 2.68 3.44 4.80 2.68 2.75 2.81 .607 .715 .889 2.49 2.96 3.72
0.4 2.78 3.53 4.82 2.78 2.88 2.98 .720 .823 .977 2.02 2.32 2.77
0.5 2.88 3.62 4.83 2.88 3.01 3.14 .827 .929 1.07 1.74 1.93 2.22
0.6 2.98 3.72 4.91 2.98 3.14 3.31 .930 1.03 1.18 1.56 1.68 1.86
0.7 3.09 3.81 4.97 3.09 3.28 3.48 1.03 1.14 1.29 1.43 1.50 1.60
0.8 3.19 3.91 5.05 3.19 3.41 3.65 1.13 1.25 1.40 1.34 1.37 1.42
0.9 3.29 4.01 5.12 3.29 3.54 3.82 1.23 1.36 1.51 1.27 1.27 1.27
1.0 3.40 4.12 5.20 3.40 3.67 3.98 1.33 1.47 1.63 1.21 1.19 1.16
1/0.9 3.51 4.22 5.30 3.51 3.81 4.16 1.44 1.59 1.77 1.16 1.11 1.06
1/0.8 3.65 4.36 5.42 3.65 3.99 4.39 1.58 1.75 1.94 1.10 1.04 .954
1/0.7 3.82 4.54 5.58 3.82 4.21 4.67 1.76 1.95 2.18 1.05 .965 .852
1/0.6 4.06 4.78 5.80 4.06 4.50 5.04 2.01 2.23 2.50 1.01 .892 .751
1/0.5 4.37 5.10 6.11 4.37 4.90 5.56 2.35 2.62 2.96 .958 .819 .650
1/0.4 4.84 5.57 6.57 4.84 5.48 6.31 2.88 3.24 3.70 .912 .747 .549
1/0.3 5.57 6.34 7.34 5.57 6.40 7.51 3.79 4.32 5.01 .868 .674 .446
1/0.2 6.96 7.78 8.82 6.96 8.14 9.79 5.72 6.63 7.89 .828 .601 .341
1/0.1 10.7 11.7 12.9 10.7 12.8 16.0 12.2 14.6 18.0 .795 .526 .228
"""


def kalker():
    rows = []
    for line in KALKER.split("\n"):
        if not line:
            continue
        name, *cells_ = line.split()
        ratio = mp.nstr(1 / mpf(name[2:]), 17) if name.startswith("1/") else name
        for n, of in enumerate(("c11", "c22", "c23", "c33")):
            for poisson, printed in zip(("0", "0.25", "0.5"), cells_[3 * n:3 * n + 3]):
                # The table's own accuracy: 0.6 %, 1.3 % at its ends, C11 0.8 % at 0.5 and 0.5; and its rounding.
                share = mpf("0.013") if name in ("0.1", "1/0.1") else mpf("0.009")
                digit = mpf(10) ** -len(printed.split(".")[1]) / 2
                rows.append((of, [ratio, poisson], printed, share * mpf(printed) + digit))
    group("kalker", "Kalker's creepage coefficients, computed", "his printed table: Three-Dimensional Elastic Bodies in Rolling Contact, 1990, Table E3", rows)


def table(path):
    lines = [line for line in (root / path).read_text().splitlines() if not line.startswith("#")]
    return list(csv.DictReader(lines))


def benchmark():
    rows = []
    for row in table("chapters/08-wheel-on-rail/data/case-a.csv"):
        if row["key"] == "right-5":
            continue  # two areas bear load, which CONTACT's example makes one
        at = [row["side"], row["y_mm"], row["roll_urad"], row["angular_velocity_rad_per_s"]]
        normal = mpf(row["normal"])
        for of, printed, within in (("normal", row["normal"], normal * mpf("1e-3")),
                                    ("p-max", row["p-max"], mpf(row["p-max"]) * mpf("0.02")),
                                    ("approach", row["approach"], mpf(row["approach"]) * mpf("0.01")),
                                    ("fx", row["fx"], normal * mpf("0.003")), ("fy", row["fy"], normal * mpf("0.003"))):
            rows.append((f"wheel-{of}", at, printed, within))
    group("benchmark", "S1002 on UIC60: the Manchester benchmark, case A2.2",
          "CONTACT's results, of its open-source example (E. Vollebregt and J. J. Kalker)", rows)


def curve():
    rows = [("full-force", [row["key"]], row["f"], mpf("5.5e-4")) for row in table("chapters/03-creep/data/contact-curve.csv")]
    group("curve", "Full theory of rolling, an ellipse of 1.568",
          "an independent program, tests/reference/rolling_curve.cpp, to 5e-4 and printed to 1e-4", rows)


def papers():
    rows = []
    for row in table("chapters/05-psd/data/table-2.csv"):
        if row["note"] == "misprint":
            continue
        rows.append(("rail-chord", [row["chord_ft"], row["rail_ft"]], row["printed"], "0.00501"))
    group("papers", "Numbers that the papers print", "Corbin and Kaufman 1975, Table 2: offsets of a chord on a rectified sine, without two misprints", rows)


def conicity():
    rows = [("conicity", [k + 1], printed, mpf(printed) * mpf("0.05"))
            for k, printed in enumerate(("0.125", "0.155", "0.188", "0.216", "0.254", "0.303"))]
    group("conicity", "Equivalent conicity of EN 15302's wheel A on rail A", "the standard's result; it allows 0.05", rows)
    # The cases E2 to E4: the middle of the band that the standard allows, and half of its width; its ends are rounded to 0.001.
    wheels = {"E2": "b", "E3": "h", "E4": "i"}
    rows = []
    for row in table("tests/reference/en-15302/bands.csv"):
        if row["case"] in wheels and row["amplitude_mm"] in ("1.000", "2.000", "3.000", "4.000", "5.000", "6.000"):
            high, low = mpf(row["highest"]), mpf(row["lowest"])
            rows.append(("conicity-" + wheels[row["case"]], [row["amplitude_mm"][0]], (high + low) / 2, (high - low) / 2 + mpf("0.0005")))
    group("conicity-b-h-i", "Equivalent conicity of EN 15302's wheels B, H and I", "the middle of the standard's band, half its width", rows)


for make in (hertz, cells, beam, filters, vehicle, mathematics, carter, kalker, curve, benchmark, conicity, papers):
    make()
bad = 0
for name, text in files.items():
    path = data / f"{name}.csv"
    if "--check" in sys.argv:
        if not path.exists() or path.read_text() != text:
            print(f"{path.name} is not what this program writes")
            bad = 1
    else:
        path.write_text(text)
print(sum(t.count("\n") - 3 for t in files.values()), "numbers in", len(files), "groups")
sys.exit(bad)
