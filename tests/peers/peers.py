"""peers.py RAILBOOK FROM_CHARS OUT.csv: the processor time of commands beside that of other programs that do less or the same.

The records are made here, always the same. Each ratio is of two programs that run one after the other, user and system time, start
included; the median of several, and the lowest and highest. What is not installed is left out.
"""
import os
import platform
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile
from datetime import date

import numpy as np

railbook, from_chars, out = sys.argv[1:]
here = os.path.dirname(os.path.abspath(__file__))
one_thread = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")
rounds = int(os.environ.get("RUNS", "7"))


def seconds(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, stdout=subprocess.DEVNULL, check=True, env=one_thread)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def write_record(name, kilometres, header, row, comma=False, columns=1):
    """Four rows a metre: heights that remember those before over some metres, and noise in further columns."""
    random = np.random.default_rng(20261127)
    height = 0.0
    rows, metres_at_once = int(4000 * kilometres), 25000
    with open(name, "w") as file:
        file.write(header)
        for first in range(0, rows, metres_at_once):
            count = min(metres_at_once, rows - first)
            noise = random.standard_normal((count, columns))
            lines = []
            for i, values in enumerate(noise.tolist()):
                height = values[0] = 0.95 * height + 0.6 * values[0]
                lines.append(row.format(0.25 * (first + i), *values))
            text = "".join(lines)
            file.write(text.replace(".", ",") if comma else text)


def ratios(work, peer, ours, theirs, runs):
    if shutil.which(theirs[0]) is None:
        return None
    pairs = [(seconds(ours), seconds(theirs)) for _ in range(runs)]
    of = [a / b for a, b in pairs]
    line = [work, peer, runs] + [f"{x:.2f}" for x in (statistics.median(of), min(of), max(of))]
    line += [f"{statistics.median(column):.3g}" for column in zip(*pairs)]
    print(*line, sep=", ", flush=True)
    return line


def works(folder):
    classify = [railbook, "psd", "classify"]
    two = "position [m]{0}profile [mm]\n"
    for what, header, row, comma in (("points", two.format(","), "{:.2f},{:.4f}\n", False),
                                     ("decimal commas", two.format(";"), "{:.2f};{:.4f}\n", True),
                                     ("quoted cells", '"position [m]","profile [mm]"\n', '"{:.2f}","{:.4f}"\n', False)):
        name = f"{folder}/record.csv"
        write_record(name, 1000, header, row, comma)
        yield ratios(f"psd classify, 1000 km, {what}", "md5sum", classify + [name], ["md5sum", name], rounds)
    name = f"{folder}/wide.csv"
    header = ",".join(["position [m]", "profile [mm]"] + [f"other{i} [mm]" for i in range(37)]) + "\n"
    write_record(name, 60, header, "{:.2f}" + 38 * ",{:.4f}" + "\n", columns=38)
    yield ratios("psd classify, 60 km, 39 columns", "std::from_chars", classify + [name], [from_chars, name], rounds)
    try:
        import scipy  # noqa: F401
    except ImportError:
        return
    one, name = f"{folder}/one.csv", f"{folder}/sensors.csv"
    subprocess.run([railbook, "filters", "simulate", "--length", "62km", "--out", one], stdout=subprocess.DEVNULL, check=True)
    with open(one) as file:  # without the distance: each row is a foot further
        header, first, *rows = [line.split(",", 1)[1] for line in file]
    for copies in (1, 4, 16):
        with open(name, "w") as file:
            file.write(header + first)
            for _ in range(copies):
                file.writelines(rows)
        yield ratios(f"filters process, {62 * copies} km", "numpy and scipy", [railbook, "filters", "process", name],
                     [sys.executable, f"{here}/chain.py", name], rounds if copies < 16 else min(rounds, 3))


def processor():
    with open("/proc/cpuinfo") as file:
        names = [line.split(":")[1].strip() for line in file if line.startswith("model name")]
    return names[0] if names else platform.machine()


load = os.getloadavg()[0]
with tempfile.TemporaryDirectory() as folder:
    lines = [line for line in works(folder) if line]
with open(out, "w") as file:
    file.write("# Processor time of a command over that of a peer, one after the other; made by `make peers`.\n")
    file.write(f"# {processor()}, {os.cpu_count()} processors, {date.today()}, load at the start {load:.1f}\n")
    file.write("work,peer,runs,median,lowest,highest,our_seconds,peer_seconds\n")
    for line in lines:
        file.write(",".join(f'"{cell}"' if "," in str(cell) else str(cell) for cell in line) + "\n")
