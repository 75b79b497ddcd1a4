#!/usr/bin/env python3
"""How much would the tests notice? One-line faults, one at a time, over lib/ and tools/.

    make mutate [FAULTS=100] [SEED=1]    or    tests/mutate/mutate.py --faults 100 --seed 1 [--only lib/contact] [--near]

Each fault is run by what is nearest: the test program of its room of lib/, the ctests of its tool but the thorough ones. Killed: a
test fails, ends by a signal, or takes four times its processor time. What survives is run by the rest that ctest runs and that
links it: the test programs of the rooms above, the chapters (their checks and golden data), the tools; not with --near.
A fault that does not compile is replaced. The score is one of a sample, and the kinds are drawn evenly, not as people
err.

Only what includes the faulty line is compiled, from a copy of it, and linked into a copy of the program: the tree is
not touched (but for bin/railbook while ctest runs the tools: it is put back). The tree must have been built.

Survivors go to build/mutants/survivors.txt, each with its line before and after. Some change nothing that a test could see; the score
counts them all the same.
"""

import argparse
import json
import os
import pathlib
import random
import re
import resource
import shlex
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]

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
    "swapped arguments": (r"(?<=\w\()(?<!min\()(?<!max\()(?<!hypot\()(?<!swap\()(\w[\w.]*), (\w[\w.]*)(?=[,)])", lambda m: f"{m.group(2)}, {m.group(1)}"),
    "dropped term": (r" [+-] [\w.]+(\([^()]*\))?(?=[;,)])", lambda m: ""),
    "dropped factor": (r" \* [\w.]+(?=[;,) ])", lambda m: ""),
    "function": (r"\b(?P<o>sin|cos)(?=\()", exchanged),
    "dropped abs": (r"std::abs(?=\()", lambda m: ""),
    "truth": (r"\b(?P<o>true|false)\b(?=[;,)}])", exchanged),
    "negation": (r"!(?=[a-z(])", lambda m: ""),
    "dropped statement": (r"^\s+[a-z][\w.\[\]>-]* (\+=|-=|\*=|=) [^;{}]*;$", lambda m: ""),
}
GENERAL = ("many", "a person", "forty", "hostile", "psd classify reads files")  # tests of tools of no one subject
SKIPPED = re.compile(r"^\s*(//|#|static_assert|template|using|namespace|\[\[|public:|private:)|InputError|fmt::|require_|for_each")


def masked(line):
    """The line with comments and the insides of strings blanked: places keep their columns."""
    line = re.sub(r'"(\\.|[^"\\])*"', lambda m: '"' + " " * (len(m.group(0)) - 2) + '"', line)
    return re.sub(r"//.*", lambda m: " " * len(m.group(0)), line)


def sites(only):
    """Every place where a fault of each kind fits: {kind: [(file, line, its text, start, end, new text)]}."""
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
                        found[kind].append((path, number, line, m.start(), m.end(), text))
    return {kind: places for kind, places in found.items() if places}


# A fault may signal processes that it has no business with, all of them in the worst case: it runs among its own.
AMONG_THEIR_OWN = ["unshare", *([] if os.geteuid() == 0 else ["--user", "--map-current-user"]), "--pid", "--fork",
                   "--kill-child", "--mount-proc", "sh", "-c", '"$@"; exit $?', "sh"]


def run(command, seconds=1e6, cwd=ROOT):
    """(status, processor seconds); a command past its limit of them (a program's own, or the sum) is ended."""
    def limited():
        if seconds < 1e6:
            resource.setrlimit(resource.RLIMIT_CPU, (int(seconds) + 1, int(seconds) + 2))
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    child = subprocess.Popen(command, cwd=cwd, stdout=subprocess.DEVNULL, stderr=subprocess.STDOUT, start_new_session=True,
                             preexec_fn=limited)
    try:
        status = child.wait(5 * seconds + 60)  # one that sleeps
    except subprocess.TimeoutExpired:
        subprocess.run(["kill", "-KILL", "--", f"-{child.pid}"], check=False)
        status = child.wait()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return status, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


class Tree:
    """What was built: how each object was compiled and each program linked, and what includes what."""

    def __init__(self, build):
        self.build = build
        self.out = build / "mutants"
        ninja = ["ninja", "-C", str(build), "-t"]
        text = subprocess.run([*ninja, "compdb"], check=True, capture_output=True, text=True).stdout
        self.compile, self.link = {}, {}
        for rule in json.loads(text):
            if rule["output"].endswith(".o"):
                self.compile[rule["output"]] = (pathlib.Path(rule["file"]), rule["command"])
            elif re.search(r"(/test_\w+|^bin/\w+)$", rule["output"]) and " -o " in rule["command"]:
                part = next(p for p in rule["command"].split(" && ") if f" -o {rule['output']} " in p)
                self.link[rule["output"]] = shlex.split(part)
        if any("/Unity/" in o for o in self.compile):
            sys.exit("several sources are compiled as one here: make PRESET=developer build, first")
        self.includes, name = {}, None
        for line in subprocess.run([*ninja, "deps"], check=True, capture_output=True, text=True).stdout.split("\n"):
            if line.startswith("    "):
                path = pathlib.Path(line.strip())
                self.includes[name].add(path if path.is_absolute() else (build / path).resolve())
            elif ": #deps" in line:
                name = line.split(":")[0]
                self.includes[name] = set()

    def rooms(self, program):
        return [w.group(1) for w in (re.match(r"lib/(\w+)/librailbook_", part) for part in self.link[program]) if w]

    def objects(self, program):
        folders = tuple(f"lib/{room}/CMakeFiles/railbook_{room}.dir/" for room in self.rooms(program))
        direct = {part for part in self.link[program] if part.endswith(".o")}
        return [o for o in self.compile if o in direct or o.startswith(folders)]

    def made(self, program, path, text, done):
        """The program with the text in place of the file's: "" when it does not include it, None when that does not
        compile. `done` keeps the objects."""
        overlay = self.out / "tree"
        faulty = []
        for output in self.objects(program):
            source, command = self.compile[output]
            if source != path and path not in self.includes.get(output, ()):
                continue
            new = str(self.out / (output.replace("/", "-")))
            faulty.append((output, new))
            if output in done:
                continue
            for file, content in ((path, text), (source, text if source == path else source.read_text())):
                copy = overlay / file.relative_to(ROOT)
                copy.parent.mkdir(parents=True, exist_ok=True)
                copy.write_text(content)
            if source != path:  # what was precompiled may hold the header
                command = re.sub(r"-Winvalid-pch -include \S+", "", command)
            words = shlex.split(command)
            words[words.index("-o") + 1] = new
            words[words.index("-c") + 1] = str(overlay / source.relative_to(ROOT))
            words[1:1] = ["-w", "-I", str(overlay / "lib"), "-I", str(overlay / "tools"), "-iquote", str(source.parent)]
            status = run(words, cwd=self.build)[0]
            if status != 0:
                return None
            done.add(output)
        if not faulty:
            return ""
        words = list(self.link[program])
        new = str(self.out / program.split("/")[-1])
        words[words.index("-o") + 1] = new
        for old, made in faulty:  # an object of an archive that comes first is taken in its place
            if old in words:
                words[words.index(old)] = made
            else:
                words.insert(words.index("-o"), made)
        return new if run(words, cwd=self.build)[0] == 0 else None


def nearest(path):
    """(program, pattern of ctest's names) that a fault in the file is run by."""
    parts = path.relative_to(ROOT).parts
    if parts[0] == "lib":
        return f"lib/{parts[1]}/test_{parts[1]}", None
    return "bin/railbook", f"^tool: {parts[1] if len(parts) > 2 else 'psd'}"


def farther(tree, path):
    """The rest of ctest that a fault in the file could fail, the quick ones first."""
    parts = path.relative_to(ROOT).parts
    if parts[0] == "tools":
        return [("bin/railbook", "^(tool|readme|outside)")]
    room = parts[1]
    users = [p for p in tree.link if room in tree.rooms(p) or room in p]
    steps = [(p, None) for p in users if "/test_" in p and p != nearest(path)[0]]
    steps += [(p, None) for p in users if (ROOT / "chapters").joinpath(chapter_folder(p)).is_dir()]
    if "bin/railbook" in users:
        subjects = {f.relative_to(ROOT).parts[1] for f in (ROOT / "tools").glob("*/*.cpp") if uses(f, room)}
        steps.append(("bin/railbook", f"^tool: ({'|'.join([*sorted(subjects), *GENERAL])})" if subjects else "^tool:"))
    return steps


def uses(file, room):
    return f'#include "{room}/' in file.read_text()


def chapter_folder(program):
    found = list((ROOT / "chapters").glob(f"*-{program.split('/')[-1].replace('_', '-')}"))
    return found[0].name if found else "none"


class Tests:
    """Runs a program's tests on a copy of it, and knows what they take without a fault."""

    def __init__(self, tree):
        self.tree, self.healthy = tree, {}

    def command(self, program, pattern, made):
        out = self.tree.out / "run"
        if pattern:
            return [["ctest", "--test-dir", str(self.tree.build), "--stop-on-failure", "-j", "2", "-LE", "thorough", "-R", pattern]]
        if "/test_" in program:
            return [[made, "--abort"]]
        chapter = chapter_folder(program)
        figures, now = ROOT / "figures", self.tree.build / "environment.txt"
        return [[made, "reproduce", "--no-timings", "--no-figures", "--out", str(out)],
                [str(self.tree.build / "bin/figure_diff"), "data", str(out), str(figures / chapter),
                 str(figures / "environment.txt"), str(now)]]

    def pass_with(self, program, pattern, made):
        """Whether all pass; ended after four times what they take without a fault."""
        key = (program, pattern)
        if key not in self.healthy:
            status, seconds = self.run(self.command(program, pattern, str(self.tree.build / program)), 600)
            if status != 0:
                sys.exit(f"{program} {pattern or ''}: fails without a fault")
            self.healthy[key] = seconds
        if not pattern:
            return self.run(self.command(program, pattern, made), 4 * self.healthy[key] + 2)[0] == 0
        kept, place = self.tree.out / "kept", self.tree.build / program
        shutil.move(place, kept)
        try:
            shutil.copy(made, place)
            return self.run(self.command(program, pattern, made), 4 * self.healthy[key] + 2)[0] == 0
        finally:
            shutil.move(kept, place)

    @staticmethod
    def run(commands, limit):
        total = 0
        for command in commands:
            status, seconds = run([*AMONG_THEIR_OWN, *command], limit)
            total += seconds
            if status != 0:
                return status, total
        return 0, total


def main():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    a.add_argument("--faults", type=int, default=100)
    a.add_argument("--seed", type=int, default=1)
    a.add_argument("--build", default="build")
    a.add_argument("--only", action="append", default=[], help="a folder or file, e.g. lib/contact")
    a.add_argument("--near", action="store_true", help="run faults by what is nearest only")
    a.add_argument("--list", action="store_true", help="count the places of each kind, and stop")
    options = a.parse_args()
    places = sites(options.only or [""])
    if options.list:
        for kind, found in places.items():
            print(f"{len(found):6} {kind}")
        return 0
    random.seed(options.seed)
    for found in places.values():
        random.shuffle(found)
    if run([*AMONG_THEIR_OWN, "true"])[0] != 0:
        sys.exit("faults run in a process namespace of their own, and unshare cannot make one here")
    tree = Tree(ROOT / options.build)
    tests = Tests(tree)
    # In a process namespace of its own a test has the number, and names its temporary files, as that of another tree does.
    (tree.out / "tmp").mkdir(parents=True, exist_ok=True)
    os.environ["TMPDIR"] = str(tree.out / "tmp")
    survivors = []
    near = far = still = untested = 0
    order = list(places)
    turn = 0
    while near + far + argued + len(survivors) < options.faults and any(places.values()):
        kind = order[turn % len(order)]
        turn += 1
        if not places[kind]:
            continue
        path, number, before, start, end, text = places[kind].pop()
        program, pattern = nearest(path)
        if program not in tree.link:
            untested += 1
            print(f"no tests  {path.relative_to(ROOT)}:{number + 1}", flush=True)
            continue
        lines = path.read_text().split("\n")
        if number >= len(lines) or lines[number] != before:  # edited since
            continue
        lines[number] = before[:start] + text + before[end:]
        change = f"  - {before.strip()}\n  + {lines[number].strip()}".rstrip()
        shutil.rmtree(tree.out / "tree", ignore_errors=True)
        done, begun = set(), time.monotonic()
        faulty = "\n".join(lines)
        made = tree.made(program, path, faulty, done)
        if made is None:
            still += 1
            continue
        if made and not tests.pass_with(program, pattern, made):
            near += 1
            verdict = "killed"
        else:
            verdict = "SURVIVED"
            for program, pattern in [] if options.near else farther(tree, path):
                made = tree.made(program, path, faulty, done)
                if made and not tests.pass_with(program, pattern, made):
                    far += 1
                    verdict = f"killed by {program.split('/')[-1]} {pattern or ''}"
                    break
        at = f"{path.relative_to(ROOT)}:{number + 1} ({kind})\n{change}"
        if verdict == "SURVIVED":
            survivors.append(at)
        print(f"{verdict:10}{at}  [{time.monotonic() - begun:.0f} s]", flush=True)
        (tree.out / "survivors.txt").write_text("\n".join(survivors) + "\n")
    counted = near + far + len(survivors)
    print(f"{near + far} of {counted} faults killed ({100 * (near + far) / max(counted, 1):.0f} %)"
          f"{f', {near} of them by what is nearest' if not options.near else ''}, seed {options.seed}; "
          f"{still} did not compile, {untested} in folders without tests")
    print(f"survivors: {(tree.out / 'survivors.txt').relative_to(ROOT)}")
    return 0 if not survivors else 1


if __name__ == "__main__":
    sys.exit(main())
