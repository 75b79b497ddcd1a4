"""Writes a source file that maps doc("file.hpp name") to the comments of the public headers.

usage: docstrings.py LIB OUT SOURCE...
"""
import pathlib
import re
import sys


def comment_above(lines, at):
    while at > 0 and lines[at - 1].strip() and not lines[at - 1].startswith("//"):
        at -= 1  # other declarations that share the comment
    first = at
    while first > 0 and lines[first - 1].startswith("//"):
        first -= 1
    return [line[2:].strip() for line in lines[first:at]]


def members(lines, at):
    """`name: comment` of each member of the struct that begins at a line."""
    out = []
    for line in lines[at + 1 :]:
        if line.startswith("}"):
            break
        found = re.match(r"  (?:const )?[\w:<>]+ (\w[\w, =.{}]*);\s*//\s*(.+)", line)
        if found:
            names = re.sub(r"\s*=[^,]*|\{[^}]*\}", "", found[1])
            out.append(f"{names.strip()}: {found[2]}")
        elif out and re.match(r"\s+//", line):
            out[-1] += " " + line.strip()[2:].strip()
    return out


def documentation(lib, place):
    file, _, name = place.partition(" ")
    lines = (lib / file).read_text().splitlines()
    if not name:
        text = []
        for line in lines:
            if not line.startswith("//"):
                break
            text.append(line[2:].strip())
        return "\n".join(text)
    for at, line in enumerate(lines):
        if re.match(rf"(struct|class) {name}\b", line):
            return "\n".join([*comment_above(lines, at), "", *members(lines, at)]).strip()
        if re.match(rf"[^/#\s][^/]*\b{name}\(", line):
            return "\n".join(comment_above(lines, at))
    sys.exit(f"docstrings.py: no {name} in {file}")


def main():
    lib, out, sources = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3:]
    places = sorted({p for s in sources for p in re.findall(r'doc\("([^"]+)"\)', pathlib.Path(s).read_text())})
    rows = []
    for place in places:
        text = documentation(lib, place)
        if not text:
            sys.exit(f"docstrings.py: {place} has no comment")
        rows.append(f'    {{"{place}", R"=({text})="}},')
    pathlib.Path(out).write_text(
        '#include <map>\n#include <string_view>\n\n#include "python.hpp"\n\n'
        "const char* railbook::python::doc(std::string_view place) {\n"
        "  static const std::map<std::string_view, const char*> texts{\n" + "\n".join(rows) +
        "\n  };\n  return texts.at(place);\n}\n")


main()
