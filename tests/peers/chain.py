"""chain.py SENSORS.csv: the 13 parameters of `railbook filters process` with numpy and scipy, for a car at one speed.

Prints the standard deviation of each. No gaps, no checks of the sensors, no warnings, no quality of a row.
"""
import sys

import numpy as np
from scipy import ndimage, signal

names = open(sys.argv[1]).readline().strip().split(",")
table = dict(zip(names, np.loadtxt(sys.argv[1], delimiter=",", skiprows=1, unpack=True)))
foot, g, inch = 0.3048, 9.80665, 0.0254
base, transducers, trucks, gage_zero = 59.5 * inch, 79 * inch, 60 * foot, 54.5 * inch
height_inclinometer, height_beam = 1.2, 0.3
corner = 2 * np.pi  # rad/s, of all analog filters
T = np.mean(table["elapsed_s"][1:])
v, a = foot / T, np.exp(-corner * T)


def mm(name):
    return 1e-3 * table[name]


def inverse_first(y):
    return y + np.diff(y, prepend=y[0]) / np.expm1(corner * T)


def inverse_second(y):
    """The mean acceleration over the two intervals around each sample."""
    mean = np.convolve(y, np.array([1, -2 * a, a * a]) / (1 - a) ** 2)[: len(y)]
    return np.append(mean[1:], mean[-1])


def poles(x):
    """Through one and through both poles of the analog filter, from rest at the first value."""
    once = signal.lfilter([1 - a], [1, -a], x, zi=[a * x[0]])[0]
    return once, signal.lfilter([1 - a], [1, -a], once, zi=[a * once[0]])[0]


def short_chords(z):
    return z - ndimage.correlate1d(z, [0.5, 0, 0.5])


def long_chord(short):
    curve = np.cumsum(np.cumsum(-2 * short))
    mean = curve
    for _ in range(4):
        mean = ndimage.uniform_filter1d(mean, 151)
    curve = curve - mean
    return curve - 0.5 * (np.roll(curve, 31) + np.roll(curve, -31)), curve


yaw, roll = (inverse_first(np.radians(table[n + "_rate_deg_per_s"])) for n in ("yaw", "roll"))
yaw1, yaw2 = poles(yaw)
roll1, roll2 = poles(roll)
felt = table["inclinometer_m_per_s2"] - v * yaw2 - 0.5 * trucks * corner * (yaw1 - yaw2)
felt = felt + height_inclinometer * corner * (roll1 - roll2)
slow = np.arcsin(np.clip(felt / g, -0.5, 0.5)) + (roll1 + roll2) / corner
keep = np.exp(-2 * np.pi * 1.25 / 4 * T)  # of the two poles that join the inclinometer and the gyro
body = slow
for _ in range(2):
    body = signal.lfilter([1], [1, -keep], keep * T * roll + (1 - keep) * body, zi=[keep * slow[0]])[0]
level = np.sin(body) - (mm("height_left_mm") - mm("height_right_mm")) / transducers
out = {"gage": mm("gage_left_mm") + mm("gage_right_mm") + gage_zero}
sway = (0.5 * (mm("sway_front_a_mm") + mm("sway_front_b_mm")) - mm("sway_rear_mm")) / trucks
turn = T * yaw - np.diff(sway, prepend=sway[0])
window = np.append(np.append(0.5, np.ones(50)), 0.5) / (51 * foot)
out["curvature"] = np.roll(signal.oaconvolve(turn, window, "same"), -30)
out["curvature_rate"] = (np.roll(out["curvature"], -25) - np.roll(out["curvature"], 25)) / (50 * foot)
out["crosslevel"] = base * level
out["warp"] = np.roll(out["crosslevel"], -31) - np.roll(out["crosslevel"], 31)
leaning = inverse_second(table["inclinometer_m_per_s2"]) * np.sin(body) + g * (np.cos(body) - 1)
up = [-0.5 * T * T * (inverse_second(table[f"vertical_{s}_m_per_s2"]) + leaning) - short_chords(mm(f"height_{s}_mm"))
      for s in ("left", "right")]
inward = 0.5 * (1 - base / transducers) * (up[0] - up[1])
gravity = g * ndimage.correlate1d(level, [1 / 6, 2 / 3, 1 / 6])
path = -0.5 * T * T * (inverse_second(table["lateral_m_per_s2"]) - gravity) + height_beam * short_chords(level)
for chord, curve, short in (("profile_left", "surface_left", up[0] - inward), ("profile_right", "surface_right", up[1] + inward),
                            ("alignment_left", "line_left", path + short_chords(mm("gage_left_mm"))),
                            ("alignment_right", "line_right", path - short_chords(mm("gage_right_mm")))):
    out[chord], out[curve] = long_chord(short)
inner = slice(2000, -2000)  # the ends, where windows are not complete
for name, values in out.items():
    print(name, np.std(values[inner]))
