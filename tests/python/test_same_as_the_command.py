"""What the module answers is what the command answers, bit for bit."""
import math
import os

import numpy as np

from railbook import contact, profiles, rolling, track, vehicle, wheel_contact, wheelset

INCH = 0.0254
FOOT = 12 * INCH  # as the library counts it


def test_contact(answer):
    says = answer("contact", "solve", "--body-1-radius-along", "460mm", "--body-2-radius-across", "300mm", "--load", "100kN")
    modulus = contact.effective_modulus()
    solved = contact.solve(contact.Body(radius_y=0.46), contact.Body(radius_x=0.3), modulus, load=100e3, cells=127)
    assert modulus / 1e6 == says["effective_modulus_MPa"]
    assert solved.p_max / 1e6 == says["p_max_MPa"]
    assert solved.iterations == says["iterations"]


def test_creep_forces(answer):
    for theory in ("full", "fastsim"):
        says = answer("creep", "curve", "--a", "6mm", "--b", "5mm", "--load", "100kN", "--mu", "0.3", "--theory", theory, "--to", "0.002", "--points", "2")
        case = rolling.RollingCase(a=6e-3, b=5e-3, load=100e3, shear_modulus=contact.default_steel.shear_modulus,
                                   poisson=0.28, friction=0.3, creepage=rolling.Creepage(0.002))
        assert rolling.creep_forces(case, theory).fx == says["largest_force_N"]


def test_critical_speeds(answer):
    says = answer("hunting", "speed")
    speeds = vehicle.critical_speeds(vehicle.Car(vehicle.CarParameters(), wheelset.paper_pair("new")))
    assert [s.speed for s in speeds] == [says["hopf_1_m_per_s"], says["hopf_2_m_per_s"]]


def test_conicity_of_measured_profiles(answer):
    folder = os.path.join(os.environ["EXAMPLES"], "hunting")
    wheel, rail = (os.path.join(folder, f"worn-{body}.csv") for body in ("wheel", "rail"))
    says = answer("hunting", "geometry", "--wheel", wheel, "--rail", rail)

    def curve(file, body):
        points = np.loadtxt(file, delimiter=",", skiprows=2) * 1e-3
        return profiles.curve(profiles.check(points, body).points)

    gauge = 56.5 * INCH
    pair = wheelset.WheelsetOnTrack(wheelset.placed_wheel(curve(wheel, "wheel"), 0.5 * 1.36 + 0.07),
                                    wheelset.placed_rail(curve(rail, "rail"), gauge, 0.625 * INCH, math.atan(0.025)),
                                    16.5 * INCH)
    table = pair.tabulate(29.76 * INCH, end=0.75 * INCH, step=0.0025 * INCH, average=0)
    assert wheelset.conicity(table, 3e-3).kinematic == says["conicity_at_3_mm"]


def test_wheel_on_rail(answer):
    says = answer("wheelrail", "contact", "--speed", "20m/s", "--load", "50kN", "--shift", "3mm", "--method", "strips")
    pair = wheel_contact.s1002_on_60e1(1 / 40)
    found = wheel_contact.solve_wheelset(pair, wheel_contact.Pose(y=3e-3), load=50e3, speed=20, method="strips")
    assert found.angular_velocity == says["angular_velocity_rad_per_s"]
    assert found.right.force[2] == says["right_z_N"]
    assert found.right.patches[0].p_max / 1e6 == says["right_1_p_max_MPa"]
    assert found.right.patches[0].forces.fy == says["right_1_fy_N"]


def test_joint(answer):
    says = answer("track", "joint", "--speed", "60mph", "--dip", "0.5in")
    passage = track.joint_passage(track.ImpactModel(), track.RectifiedSine(0.5 * INCH, 39 * FOOT), says["speed_m_per_s"])
    assert passage.peaks.first.force / 1e3 == says["p1_kN"]
    assert passage.peaks.mean.force / 1e3 == says["p2_kN"]
