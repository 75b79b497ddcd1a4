"""peers.py OUT.json: what scipy takes for the work of speed.cpp, best of five rounds; nothing where there is no scipy."""
import json
import sys
import time

try:
    import numpy as np
    from scipy import signal
except ImportError:
    json.dump({}, open(sys.argv[1], "w"))
    sys.exit(0)


def best(run):
    times = []
    for _ in range(5):
        begin = time.perf_counter()
        run()
        times.append(time.perf_counter() - begin)
    return min(times)


x = 1e-3 * np.random.default_rng(20261122).standard_normal(1 << 22)
a = np.exp(-0.01)
weights = signal.windows.hann(661)
wide = signal.windows.hann(8889)
out = {
    "psd": ("scipy.signal.welch", lambda: signal.welch(x, 1, "hann", 4096, detrend="linear")),
    "hybrid": ("scipy.signal.lfilter", lambda: signal.lfilter([1, -a], [1 - a], x)),
    "chain": ("scipy.signal.oaconvolve, twice", lambda: [signal.oaconvolve(x, weights) for _ in range(2)]),
    "descriptor": ("scipy.signal.oaconvolve", lambda: signal.oaconvolve(x, wide)),
}
found = {key: {"what": what, "work": len(x), "seconds": best(run)} for key, (what, run) in out.items()}
for key in ("chain", "descriptor"):
    found[key + "-new"] = found[key]
json.dump(found, open(sys.argv[1], "w"), indent=1)
