"""Errors, arrays and threads of the module, and the page docs/python.md."""
import contextlib
import io
import pathlib
import re
import threading
import timeit

import numpy as np
import pytest

import railbook
from railbook import contact, filters, rolling, spectra, track, vehicle, wheelset

PAGE = pathlib.Path(__file__).parents[2] / "docs" / "python.md"
EXAMPLES = re.findall(r"```python\n(.*?)```\n\n```answer\n(.*?)```", PAGE.read_text(), re.S)


def test_the_page_has_its_examples():
    assert len(EXAMPLES) == 6
    assert all(len(code.splitlines()) <= 20 for code, _ in EXAMPLES)


@pytest.mark.parametrize("code,printed", EXAMPLES)
def test_example_of_the_page(code, printed):
    out = io.StringIO()
    with contextlib.redirect_stdout(out):
        exec(code, {})
    assert out.getvalue() == printed


def test_bad_input_is_a_value_error_that_names_it():
    with pytest.raises(ValueError, match="relative curvature A is -1"):
        contact.hertz_from_force(contact.RelativeCurvature(-1, 1), 1e11, 1)
    with pytest.raises(ValueError, match="body-mass is -1 kg"):
        vehicle.CarParameters(body_mass=-1)
    with pytest.raises(ValueError, match="either load or approach"):
        contact.solve(contact.Body(radius_y=1), contact.Body(radius_x=1), 1e11)
    with pytest.raises(ValueError, match="not of one length"):
        case = rolling.RollingCase(a=1e-3, b=1e-3, load=1, shear_modulus=8e10, poisson=0.3, friction=0.3)
        rolling.Ellipse(case, "fastsim").forces(np.zeros(2), np.zeros(2), np.zeros(3))
    with pytest.raises(AttributeError):
        vehicle.CarParameters(bodymass=1)


def test_no_answer_is_a_numerical_error():
    with pytest.raises(railbook.NumericalError, match="no critical speed"):
        vehicle.limit_cycles(vehicle.Car(vehicle.CarParameters(), wheelset.paper_pair("new")), 1, 10)


def test_results_are_handed_out_without_a_copy():
    solved = contact.solve(contact.Body(radius_y=0.46), contact.Body(radius_x=0.3), 1e11, load=1e5, cells=32)
    assert not solved.p.flags.owndata and not solved.p.flags.writeable
    assert np.shares_memory(solved.p, solved.p)
    assert abs((solved.p * solved.dx * solved.dy).sum() / 1e5 - 1) < 0.01


def test_a_result_outlives_what_it_came_from():
    p = contact.solve(contact.Body(radius_y=0.46), contact.Body(radius_x=0.3), 1e11, load=1e5, cells=32).p
    assert p.max() > 0


def test_threads_run_at_the_same_time_and_agree():
    z = np.random.default_rng(1).normal(size=400_000)
    densities = [None, None]

    def work(k):
        densities[k] = spectra.welch(z, 0.25).density.copy()

    threads = [threading.Thread(target=work, args=(k,)) for k in (0, 1)]
    for t in threads:
        t.start()
    for t in threads:
        t.join()
    assert np.array_equal(*densities)


def test_white_noise_has_its_density():
    z = np.random.default_rng(2).normal(scale=1e-3, size=400_000)
    s = spectra.welch(z, 0.25, segment=1024)
    assert abs(s.density[10:500].mean() / (2 * 1e-6 * 0.25) - 1) < 0.02


def test_arrays_of_another_type_are_read_too():
    z = np.arange(4000) % 7
    assert np.array_equal(filters.chord(z, 0.25, 10.0), filters.chord(z.astype(float), 0.25, 10.0))
    assert np.array_equal(filters.chord(z[::2].astype(float), 0.5, 10.0),
                          filters.chord(np.ascontiguousarray(z[::2]).astype(float), 0.5, 10.0))


def test_every_function_has_the_text_of_its_header():
    for part in (contact, rolling, track, vehicle, wheelset, spectra, filters):
        for name, thing in vars(part).items():
            if callable(thing) and name not in ("Estimate", "ForceExtremum", "mirrored"):
                assert len((thing.__doc__ or "").strip()) > 40, f"{part.__name__}.{name}"


def test_a_call_costs_little():
    h = contact.hertz_from_force(contact.RelativeCurvature(1, 1), 1e11, 1e5)
    least = min(timeit.repeat(lambda: h.p_max, number=10_000, repeat=5)) / 10_000
    print(f"{least * 1e6:.2f} us a call")  # printed, not asserted: machines are shared


def test_a_force_table_bounds_what_its_interpolation_loses():
    table = rolling.ForceTable("fastsim", cells=8)
    coarse = rolling.ForceTableAxes()
    coarse.longitudinal, coarse.lateral, coarse.spin = 5, 5, 9
    few = rolling.ForceTable("fastsim", axes=coarse, cells=8)
    place = (1.1, 0.4, 0.3, 0.5)
    force, moment = few.bound(*place)
    assert 0 < table.bound(*place)[0] < force < 1 and 0 < moment < 1
    difference = np.subtract(few.at(*place), table.at(*place))
    assert np.hypot(*difference[:2]) < force
    assert few.bound(1.1, 99, 0, 0) == [np.inf, np.inf]
