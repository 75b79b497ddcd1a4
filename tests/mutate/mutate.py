#!/usr/bin/env python3
"""How much would the tests notice? One-line faults, one at a time, over lib/ and tools/.

    make mutate [FAULTS=100] [SEED=1]    or    tests/mutate/mutate.py --faults 100 --seed 1 [--only lib/contact]

Each fault is built and run by what is nearest: the test program of its room of lib/, the ctests of its tool. Killed: a
test fails, ends by a signal, or runs past ten times its time. A fault that does not compile is replaced. What the
chapters and the rooms above would see is not asked, so that the score is a lower bound; it is one of a sample, and the
kinds are drawn evenly, not as people err. Works in the checkout it stands in and puts every file back.

Survivors go to build/mutants/survivors.txt, each with its line before and after; tests/mutate/equivalent.txt holds
those argued to be equivalent (file, line's text, fault's text, reason), which count apart.
"""

import argparse
import pathlib
import random
import re
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
TIMED_OUT = -1000

# kind: pattern and what takes its place; one match of a line is changed.
SWAP = {"+": "-", "-": "+", "*": "/", "/": "*", "<": "<=", ">": ">=", "<=": "<", ">=": ">", "==": "!=", "!=": "==",
        "&&": "||", "||": "&&", "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*=", "min": "max", "max": "min",
        "sin": "cos", "cos": "sin", "floor": "ceil", "ceil": "floor", "true": "false", "false": "true"}


def exchanged(match):
    return match.group(0).replace(match.group("o"), SWAP[match.group("o")])


def other_constant(match):
    text = match.group(0)
    if re.fullmatch(r"\d+", text):
        return str(int(text) + 1)
    return f"({text} * 1.01)" if float(text) != 0 else "0.01"


KINDS = {
    "sign": (r" (?P<o>[+-]=?) ", exchanged),
    "leading minus": (r"(?<=[=,?:] )-(?=[\w(])|(?<=\()-(?=[a-z(])|(?<=return )-(?=[\w(])", lambda m: ""),
    "factor": (r" (?P<o>[*/]=?) ", exchanged),
    "comparison": (r" (?P<o><=?|>=?|==|!=) ", exchanged),
    "bound": (r"\b(?P<o>min|max|floor|ceil)(?=\()", exchanged),
    "and, or": (r" (?P<o>&&|\|\|) ", exchanged),
    "condition never": (r"(?<=\bif \()([^;{}]+)(?=\)( return| break| continue| throw| \{|$))",
                        lambda m: f"false && ({m.group(1)})"),
    "condition always": (r"(?<=\bif \()([^;{}=]+)(?=\)( return| break| continue| \{|$))",
                         lambda m: f"true || ({m.group(1)})"),
    "constant": (r"(?<![\w.\"<])\d+(\.\d+)?(e-?\d+)?(?![\w.\"'>])", other_constant),
    "swapped arguments": (r"(?<=\w\()(\w[\w.]*), (\w[\w.]*)(?=[,)])", lambda m: f"{m.group(2)}, {m.group(1)}"),
    "dropped term": (r" [+-] [\w.]+(\([^()]*\))?(?=[;,)])", lambda m: ""),
    "dropped factor": (r" \* [\w.]+(?=[;,) ])", lambda m: ""),
    "function": (r"\b(?P<o>sin|cos)(?=\()", exchanged),
    "dropped abs": (r"std::abs(?=\()", lambda m: ""),
    "truth": (r"\b(?P<o>true|false)\b(?=[;,)}])", exchanged),
    "negation": (r"!(?=[a-z(])", lambda m: ""),
    "dropped statement": (r"^\s+[a-z][\w.\[\]>-]* (\+=|-=|\*=|=) [^;{}]*;$", lambda m: ""),
}
SKIPPED = re.compile(r"^\s*(//|#|static_assert|template|using|namespace|\[\[|public:|private:)|InputError|fmt::|require_|for_each")


def masked(line):
    """The line with comments and the insides of strings blanked: places keep their columns."""
    line = re.sub(r'"(\\.|[^"\\])*"', lambda m: '"' + " " * (len(m.group(0)) - 2) + '"', line)
    return re.sub(r"//.*", lambda m: " " * len(m.group(0)), line)


def sites(only):
    """Every place where a fault of each kind fits: {kind: [(file, line, start, end, new text)]}."""
    found = {kind: [] for kind in KINDS}
    files = sorted(p for part in ("lib", "tools") for e in ("*.cpp", "*.hpp") for p in (ROOT / part).rglob(e))
    for path in files:
        name = path.relative_to(ROOT).as_posix()
        if not name.startswith(tuple(only)) or "/scene/context" in name or "no_raster" in name:
            continue
        in_prose = False
        for number, line in enumerate(path.read_text().split("\n")):
            in_prose = in_prose or "/*" in line
            if in_prose or SKIPPED.search(line):
                in_prose = in_prose and "*/" not in line
                continue
            code = masked(line)
            for kind, (pattern, new) in KINDS.items():
                for m in re.finditer(pattern, code):
                    text = new(m)
                    if text != line[m.start():m.end()]:
                        found[kind].append((path, number, m.start(), m.end(), text))
    return {kind: places for kind, places in found.items() if places}


def run(command, limit):
    """(status, seconds); a program past its limit is ended with its children."""
    begun = time.monotonic()
    child = subprocess.Popen(command, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.STDOUT, start_new_session=True)
    try:
        status = child.wait(limit)
    except subprocess.TimeoutExpired:
        subprocess.run(["kill", "-KILL", "--", f"-{child.pid}"], check=False)
        child.wait()
        status = TIMED_OUT
    return status, time.monotonic() - begun


def nearest(path, build):
    """(targets, command) that a fault in the file is built and run by; None when nothing is near."""
    parts = path.relative_to(ROOT).parts
    if parts[0] == "lib":
        room = parts[1]
        program = build / "lib" / room / f"test_{room}"
        return ([f"test_{room}"], [str(program), "--abort"]) if program.exists() else None
    subject = parts[1] if len(parts) > 2 else "psd"
    return ["railbook"], ["ctest", "--test-dir", str(build), "--stop-on-failure", "-R", f"^tool: {subject}"]


def main():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    a.add_argument("--faults", type=int, default=100)
    a.add_argument("--seed", type=int, default=1)
    a.add_argument("--build", default="build")
    a.add_argument("--only", action="append", default=[], help="a folder or file, e.g. lib/contact")
    a.add_argument("--list", action="store_true", help="count the places of each kind, and stop")
    wish = a.parse_args()
    build = ROOT / wish.build
    places = sites(wish.only or [""])
    if wish.list:
        for kind, found in places.items():
            print(f"{len(found):6} {kind}")
        return 0
    random.seed(wish.seed)
    for found in places.values():
        random.shuffle(found)
    known = ROOT / "tests/mutate/equivalent.txt"
    equivalent = known.read_text() if known.exists() else ""
    out = build / "mutants"
    out.mkdir(exist_ok=True)
    survivors, healthy = [], {}
    killed = argued = still = untested = 0
    order = list(places)
    turn = 0
    while killed + argued + len(survivors) < wish.faults and any(places.values()):
        kind = order[turn % len(order)]
        turn += 1
        if not places[kind]:
            continue
        path, number, start, end, text = places[kind].pop()
        near = nearest(path, build)
        if near is None:
            untested += 1
            print(f"no tests  {path.relative_to(ROOT)}:{number + 1}", flush=True)
            continue
        targets, command = near
        make = ["cmake", "--build", str(build), "--target", *targets, "-j", "1"]
        whole = path.read_text()
        if command[0] not in healthy or command[0] == "ctest":  # it must pass without a fault
            key = " ".join(command)
            if key not in healthy:
                if run(make, 1800)[0] != 0:
                    sys.exit(f"{targets[0]} does not build")
                status, seconds = run(command, 900)
                if status != 0:
                    sys.exit(f"{key}: fails without a fault")
                healthy[key] = healthy[command[0]] = seconds
        seconds = healthy[" ".join(command)]
        lines = whole.split("\n")
        before = lines[number]
        lines[number] = before[:start] + text + before[end:]
        at = f"{path.relative_to(ROOT)}:{number + 1} ({kind})\n  - {before.strip()}\n  + {lines[number].strip()}"
        try:
            path.write_text("\n".join(lines))
            if run(make, 1800)[0] != 0:
                still += 1
                continue
            status, took = run(command, 10 * seconds + 20)
        finally:
            path.write_text(whole)
        if status != 0:
            killed += 1
            verdict = "killed" if status != TIMED_OUT else "killed (time)"
        elif f"  - {before.strip()}\n  + {lines[number].strip()}\n" in equivalent:
            argued += 1
            verdict = "equivalent"
        else:
            survivors.append(at)
            verdict = "SURVIVED"
        print(f"{verdict:10}{at}  [{took:.0f} s]", flush=True)
        (out / "survivors.txt").write_text("\n".join(survivors) + "\n")
    # What was built last had a fault in it.
    run(["cmake", "--build", str(build), "--target", "railbook"], 1800)
    counted = killed + len(survivors)
    print(f"{killed} of {counted} faults killed ({100 * killed / max(counted, 1):.0f} %), seed {wish.seed}; "
          f"{argued} argued equivalent, {still} did not compile, {untested} in folders without tests")
    print(f"survivors: {out.relative_to(ROOT)}/survivors.txt")
    return 0 if not survivors else 1


if __name__ == "__main__":
    sys.exit(main())
