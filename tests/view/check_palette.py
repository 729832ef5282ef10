"""Checks that files that repeat colours use those of the view's theme, and that colours can be distinguished.

    python3 tests/view/check_palette.py

wasm/ui/theme.cpp contains the palette, light and dark, by role. Style sheets, the icon, the page's frame and the
program's pictures cannot include it, so they repeat the colours that they need. Contrast follows the Web Content
Accessibility Guidelines: at least 4.5 : 1 between text and its background, and 3 : 1 for a line or an icon. The
lines of the charts have separate colours, in web/charts/charts.css.
"""

import itertools
import math
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parent.parent.parent
problems = []

# Roles whose names differ from the theme's.
in_css = {"line": "panel_line", "second": "second_text", "on-accent": "on_accent", "amber-ground": "amber_ground",
          "object-outline": "object_outline", "hull-outline": "hull_outline"}
in_svg = {"line": "panel_line", "outline": "object_outline", "clockwise": "clockwise_line", "counterclockwise": "counter_line", "overload": "amber", "slide": "amber",
          "no_go": "amber", "unusable": "quiet", "body": "robot", "cargo": "chord"}


def read(path):
    return (root / path).read_text(encoding="utf-8")


def theme(name):
    table = re.search(rf"constexpr Theme {name} = \{{(.*?)\n\}};", read("wasm/ui/theme.cpp"), re.DOTALL)[1]
    return {role: f"#{rgb}" for role, rgb in re.findall(r"\.(\w+) = \{0x([0-9A-F]{6})", table)}


def check(path, what, colour, wanted):
    if colour.upper() != wanted:
        problems.append(f"{path}: {what} is {colour}, and in wasm/ui/theme.cpp {wanted}")


def blocks(path):
    """The custom properties of :root, outside any media query and in the query for dark screens."""
    text = read(path)
    return {"light": re.search(r":root \{(.*?)\}", text, re.DOTALL)[1],
            "dark": re.search(r"@media \(prefers-color-scheme: dark\) \{(.*?)\n\}", text, re.DOTALL)[1]}


def check_style(path, colours_of):
    for scheme, block in blocks(path).items():
        found = re.findall(r"--([a-z-]+): (#[0-9A-Fa-f]{6})", block)
        if not found:
            problems.append(f"{path} has no colours for {scheme} screens")
        for name, colour in found:
            check(path, f"--{name} ({scheme})", colour, colours_of[scheme][in_css.get(name, name)])


def opaque(colour):
    return [int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5)]


def over(colour, opacity, ground):
    """The visible colour of a transparent one on its background."""
    return [opacity * c + (1 - opacity) * g for c, g in zip(colour, ground)]


def luminance(colour):
    red, green, blue = (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in colour)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(a, b):
    low, high = sorted((luminance(a), luminance(b)))
    return (high + 0.05) / (low + 0.05)


# Roles and backgrounds.
texts = [("text", ("panel", "well", "ground")), ("second_text", ("panel", "ground")), ("amber", ("panel", "amber_ground")),
         ("on_accent", ("accent",)), ("robot_text", ("robot",)), ("hull_text", ("object", "base")), ("accent_on_object", ("object",)),
         ("amber_on_object", ("object",))]
lines = [("quiet", ("panel",)), ("accent", ("panel", "ground")), ("chord", ("object", "base", "ground")), ("candidate", ("object", "base")),
         ("hull_outline", ("object",)), ("clockwise_line", ("object", "ground", "panel")), ("counter_line", ("object", "ground", "panel")),
         ("accent_on_object", ("object", "base")), ("amber_on_object", ("object", "base")), ("robot", ("object", "base"))]


def check_contrast(scheme, colours):
    grounds = {role: opaque(colour) for role, colour in colours.items()}
    table = re.search(rf"constexpr Theme {scheme} = \{{(.*?)\n\}};", read("wasm/ui/theme.cpp"), re.DOTALL)[1]
    share = float(re.search(r"\.hull = \{0x[0-9A-F]{6}, ([\d.]+)f\}", table)[1])
    grounds["base"] = over(grounds["hull"], share, grounds["object"])  # the lifting base on the object
    for kind, roles, wanted in (("text", texts, 4.5), ("line", lines, 3)):
        for role, on in roles:
            for ground in on:
                found = contrast(grounds[role], grounds[ground])
                if found < wanted:
                    problems.append(f"wasm/ui/theme.cpp ({scheme}): {role} on {ground} has {found:.2f} : 1, and a {kind} needs {wanted} : 1")


def lightness_and_hue(colour):
    """CIE L*, a*, b* for D65."""
    red, green, blue = (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in colour)
    x = (0.4124 * red + 0.3576 * green + 0.1805 * blue) / 0.9505
    y = 0.2126 * red + 0.7152 * green + 0.0722 * blue
    z = (0.0193 * red + 0.1192 * green + 0.9505 * blue) / 1.089
    x, y, z = (t ** (1 / 3) if t > 0.008856 else 7.787 * t + 16 / 116 for t in (x, y, z))
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


# In CIELAB, plainly different to most people; signs and dashes of the lines distinguish them for all.
least_difference = 25


def check_charts(scheme, colours, block):
    """The lines of the charts: each method has its own colour, visible on a panel and on the page's background."""
    path = "web/charts/charts.css"
    lines_of = {name: opaque(colour) for name, colour in re.findall(r"--([a-z]+): (#[0-9A-Fa-f]{6})", block)}
    methods = re.findall(r"^  (\w+): \{ words:", read("web/charts/methods.js"), re.MULTILINE)
    if list(lines_of) != methods:
        problems.append(f"{path} ({scheme}) has colours for {', '.join(lines_of)}, and methods.js names {', '.join(methods)}")
    for name, colour in lines_of.items():
        for ground in ("panel", "ground"):
            found = contrast(colour, opaque(colours[ground]))
            if found < 3:
                problems.append(f"{path} ({scheme}): {name} on {ground} has {found:.2f} : 1, and a line needs 3 : 1")
    for (a, first), (b, second) in itertools.combinations(lines_of.items(), 2):
        found = math.dist(lightness_and_hue(first), lightness_and_hue(second))
        if found < least_difference:
            problems.append(f"{path} ({scheme}): {a} and {b} differ by {found:.0f}, and lines need {least_difference}")


def check_everything():
    colours_of = {"light": theme("light"), "dark": theme("dark")}
    light = colours_of["light"]
    for scheme, colours in colours_of.items():
        check_contrast(scheme, colours)
    for scheme, block in blocks("web/charts/charts.css").items():
        check_charts(scheme, colours_of[scheme], block)
    for path in ("web/page/page.css", "web/kit/dialogs.css", "native/experiment/page/report.css"):
        check_style(path, colours_of)
    path = "core/src/output/svg/svg_parts.h"
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
