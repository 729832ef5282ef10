"""Checks that every file that has to name colours names those of the view's theme.

    python3 tests/view/check_palette.py

wasm/ui/theme.cpp holds the palette, light and dark, by role. Style sheets, the icon, the page's frame and the program's
pictures cannot include it, so they repeat what they need of it.
"""

import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parent.parent.parent
problems = []

# The roles whose names differ from the theme's.
in_css = {"line": "panel_line", "second": "second_text", "on-accent": "on_accent", "amber-ground": "amber_ground"}
in_svg = {"line": "panel_line", "outline": "object_outline", "clockwise": "clockwise_line", "counterclockwise": "counter_line"}


def read(path):
    return (root / path).read_text(encoding="utf-8")


def theme(name):
    table = re.search(rf"constexpr Theme {name} = \{{(.*?)\n\}};", read("wasm/ui/theme.cpp"), re.DOTALL)[1]
    return {role: f"#{rgb}" for role, rgb in re.findall(r"\.(\w+) = \{0x([0-9A-F]{6})", table)}


def check(path, what, colour, wanted):
    if colour.upper() != wanted:
        problems.append(f"{path}: {what} is {colour}, and in wasm/ui/theme.cpp {wanted}")


def check_style(path, colours_of):
    """The custom properties of :root, outside of any media query and in that for dark screens."""
    text = read(path)
    dark = re.search(r"@media \(prefers-color-scheme: dark\) \{(.*?)\n\}", text, re.DOTALL)[1]
    for scheme, block in (("light", re.search(r":root \{(.*?)\}", text, re.DOTALL)[1]), ("dark", dark)):
        found = re.findall(r"--([a-z-]+): (#[0-9A-Fa-f]{6})", block)
        if not found:
            problems.append(f"{path} has no colours for {scheme} screens")
        for name, colour in found:
            check(path, f"--{name} ({scheme})", colour, colours_of[scheme][in_css.get(name, name)])


def check_everything():
    colours_of = {"light": theme("light"), "dark": theme("dark")}
    light = colours_of["light"]
    for path in ("web/page/page.css", "web/kit/dialogs.css", "native/report/report.css"):
        check_style(path, colours_of)
    path = "core/src/output/svg/svg_style.h"
    for name, colour in re.findall(r'(\w+)_colour = "(#\w+)"', read(path)):
        check(path, f"{name}_colour", colour, light[in_svg.get(name, name)])
    path = "web/page/index.html"
    for scheme, colour in re.findall(r'prefers-color-scheme: (\w+)\)" content="(#\w+)"', read(path)):
        check(path, f"theme-color ({scheme})", colour, colours_of[scheme]["ground"])
    path = "web/page/icon.svg"
    for colour in re.findall(r'"(#[0-9A-F]{6})"', read(path)):
        check(path, "the dark colour", colour, light["text"])


check_everything()
for problem in problems:
    print(problem)
print(f"{len(problems)} problems" if problems else "the colours are the same everywhere")
sys.exit(1 if problems else 0)
