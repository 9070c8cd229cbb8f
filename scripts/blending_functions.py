#!/usr/bin/env python3
"""Draws the blending functions of docs/methods.md as docs/pictures/weights_*.svg.

    scripts/blending_functions.py [GRAFIKA]

GRAFIKA is the program to ask, without it target/debug/grafika. The functions are what it samples: a control point is
at height 1 and all others are at 0, so the height of the curve is the weight of that point. The formulas of
docs/methods.md stand below once more; where one and the program differ by more than 1e-12 the script ends with an error.
"""

import csv
import io
import json
import math
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = sys.argv[1] if len(sys.argv) > 1 else str(ROOT / "target/debug/grafika")
PICTURES = ROOT / "docs/pictures"
STEPS = 32
COLORS = ["#1f4e9c", "#c03020", "#2a8a3a", "#b07000", "#7a3a9a", "#008a8a", "#555555", "#a03a6a"]


def ask(words, text):
    """The rows of a table that the program writes for a document."""
    run = subprocess.run([PROGRAM, *words], input=text, capture_output=True, text=True, check=True)
    return list(csv.DictReader(io.StringIO(run.stdout)))


def heights(count, one):
    return [[float(i), 1.0 if i == one else 0.0] for i in range(count)]


def weight(method, count, one, *options, steps=STEPS):
    """The weight of point `one` of `count` as (span + u, weight)."""
    table = "x,y\n" + "".join(f"{x},{y}\n" for x, y in heights(count, one))
    words = ["sample", "-", "--from", "csv", "--method", method, "--per-span", str(steps), *options]
    return [(int(row["span"]) + float(row["u"]), float(row["y"])) for row in ask(words, table)]


def shaped(one, count=4, steps=STEPS, **document):
    """The weight of a point of a curve with shape parameters."""
    document |= {"format": "ALP", "points": heights(count, one)}
    words = ["sample", "-", "--from", "alp", "--per-span", str(steps)]
    return [(int(row["span"]) + float(row["u"]), float(row["y"])) for row in ask(words, json.dumps(document))]


def hermite(kind, steps=STEPS):
    """The weight of a place (0, 1) or a tangent (2, 3) of an arc."""
    unit = [1.0 if i == kind else 0.0 for i in range(4)]
    document = {
        "format": "IC2",
        "points": [[0.0, unit[0]], [1.0, unit[1]]],
        "tangents": [[1.0, unit[2]], [1.0, unit[3]]],
    }
    rows = ask(["sample", "-", "--from", "json", "--per-span", str(steps)], json.dumps(document))
    return [(float(row["u"]), float(row["y"])) for row in rows]


def knots(one, order, knots, places, weights=None):
    """The weight of a point over knots, at places."""
    count = len(knots) - order
    document = {"format": "CSM", "order": order, "points": heights(count, one), "knots": knots}
    if weights:
        document["weights"] = weights
    words = ["sample", "-", "--from", "csm", "--at", ",".join(map(str, places))]
    return [(at, float(row["y"])) for at, row in zip(places, ask(words, json.dumps(document)))]


def space(roots, end):
    """The functions of an extended Chebyshev space on [0, end]."""
    rows = ask(["basis", roots, "--interval", f"0,{end}", "--per-span", str(STEPS)], "")
    functions = {}
    for row in rows:
        functions.setdefault(int(row["i"]), []).append((float(row["u"]), float(row["d0"])))
    return [functions[i] for i in sorted(functions)]


# The formulas of docs/methods.md. `u` runs from 0 to 1 on a span, w = 1 - u.


def check(name, found, expected):
    worst = max(abs(y - expected(x)) for x, y in found)
    if worst > 1e-12:
        sys.exit(f"{name}: the formula and the program differ by {worst}")


def check_span(name, found, span, expected):
    """Compares on one span only."""
    check(name, [(x - span, y) for x, y in found if span < x < span + 1], expected)


def hermite_formulas(u):
    return [2 * u**3 - 3 * u**2 + 1, -2 * u**3 + 3 * u**2, u**3 - 2 * u**2 + u, u**3 - u**2]


def local_formulas(k0, u):
    return [
        k0 * (-(u**3) + 2 * u**2 - u),
        (2 - k0) * u**3 - (3 - k0) * u**2 + 1,
        (k0 - 2) * u**3 + (3 - 2 * k0) * u**2 + k0 * u,
        k0 * (u**3 - u**2),
    ]


def quadratic_formulas(u):
    w = 1 - u
    return [w**2 / 2, 1 - (w**2 + u**2) / 2, u**2 / 2]


def cubic_formulas(u):
    w = 1 - u
    return [w**3 / 6, (3 * u**3 - 6 * u**2 + 4) / 6, (-3 * u**3 + 3 * u**2 + 3 * u + 1) / 6, u**3 / 6]


def beta_formulas(b, t, u):
    w = 1 - u
    delta = b**3 + 2 * b**2 + 2 * b + t + 1
    last = u**3
    third = b**2 * u**2 * (3 - u) + b * u * (3 - u**2) + t * u**2 * (3 - 2 * u) + 1 - u**3
    first = b**3 * w**3
    second = delta - first - third - last
    return [value / delta for value in (first, second, third, last)]


def c_bezier_formulas(alpha, x):
    def last(x):
        t = alpha * x
        return (t - math.sin(t)) / (alpha - math.sin(alpha))

    s, c = math.sin(alpha / 2), math.cos(alpha / 2)
    m = s**3 / (s - alpha / 2 * c)

    def third(x):
        return m * ((1 - math.cos(alpha * x)) / (1 - math.cos(alpha)) - last(x))

    return [last(1 - x), third(1 - x), third(x), last(x)]


def c_spline_formulas(alpha, x):
    def outer(x):
        t = alpha * x
        return (t - math.sin(t)) / (2 * alpha * (1 - math.cos(alpha)))

    b0, b3 = outer(1 - x), outer(x)
    return [b0, b3 - 2 * b0 + 1 - x, b0 - 2 * b3 + x, b3]


def han_formulas(before, behind, u):
    w = 1 - u
    s = cubic_formulas(u)
    g = before * w**3 * (1 + 3 * u) / 24
    h = behind * u**3 * (1 + 3 * w) / 24
    return [s[0] - g, s[1] + 2 * g - h, s[2] + 2 * h - g, s[3] - h]


def blended_formulas(value, u, g):
    s = [(1 - value) * x for x in cubic_formulas(u)]
    return [s[0], s[1] + value * (1 - g(u)), s[2] + value * g(u), s[3]]


def quintic(u):
    return 10 * u**3 - 15 * u**4 + 6 * u**5


def sine_step(u):
    return u - math.sin(2 * math.pi * u) / (2 * math.pi)


def han_quadratic_formulas(value, u):
    s, c = math.sin(math.pi * u / 2), math.cos(math.pi * u / 2)
    b0, b2 = (1 - s) * (1 - value * s) / 2, (1 - c) * (1 - value * c) / 2
    return [b0, 1 - b0 - b2, b2]


def trig_formulas(alpha, beta, u):
    """n1 = n2 = 2, phi = sin, psi = cos."""
    s, c = math.sin(math.pi * u / 2), math.cos(math.pi * u / 2)
    b0, b1 = (1 - s) ** alpha, alpha * s * (1 - s) ** (alpha - 1)
    b4, b3 = (1 - c) ** beta, beta * c * (1 - c) ** (beta - 1)
    return [b0, b1, 1 - b0 - b1 - b3 - b4, b3, b4]


def cyclic_formula(n, t):
    return 4**n / ((2 * n + 1) * math.comb(2 * n, n)) * math.cos(t / 2) ** (2 * n)


def circle_formulas(end, u):
    s = math.sin(end / 2) ** 2
    a, b = math.sin((end - u) / 2), math.sin(u / 2)
    return [a**2 / s, 2 * math.cos(end / 2) * a * b / s, b**2 / s]


def cox(one, order, knots, u):
    """The recursion of Cox and de Boor."""
    if order == 1:
        return 1.0 if knots[one] <= u < knots[one + 1] else 0.0
    total = 0.0
    left, right = knots[one + order - 1] - knots[one], knots[one + order] - knots[one + 1]
    if left > 0:
        total += (u - knots[one]) / left * cox(one, order - 1, knots, u)
    if right > 0:
        total += (knots[one + order] - u) / right * cox(one + 1, order - 1, knots, u)
    return total


def check_all():
    for kind in range(4):
        check("Hermite", hermite(kind), lambda u: hermite_formulas(u)[kind])
    windows = [
        ("local", ["--k0", "0.3"], 4, 4, lambda u: local_formulas(0.3, u)),
        ("coons", ["--k0=-1.5"], 4, 4, lambda u: local_formulas(-1.5, u)),
        ("bspline2", [], 3, 3, quadratic_formulas),
        ("bspline3", [], 5, 4, cubic_formulas),
        ("beta", ["--bias", "2", "--tension", "3"], 4, 4, lambda u: beta_formulas(2, 3, u)),
        ("beta", ["--bias", "0.5", "--tension=-1"], 4, 4, lambda u: beta_formulas(0.5, -1, u)),
    ]
    for method, options, span, size, formulas in windows:
        for j in range(size):
            check_span(method, weight(method, 9, 3 + j, *options), span, lambda u: formulas(u)[j])
    for j in range(5):
        expected = lambda u: math.comb(4, j) * u**j * (1 - u) ** (4 - j)
        check("Bézier", weight("bezier", 5, j), expected)
    for j in range(4):
        check("C-Bézier", shaped(j, family="c-bezier", alpha=2.5), lambda u: c_bezier_formulas(2.5, u)[j])
        check("C-B-spline", shaped(j, family="c-bspline", alpha=2.5), lambda u: c_spline_formulas(2.5, u)[j])
        lambdas = [0, -2, 3, 0]
        check("Han", shaped(j, family="han", **{"lambda": lambdas}), lambda u: han_formulas(-2, 3, u)[j])
        for family, g in [("alpha", quintic), ("gb", quintic), ("spb", sine_step)]:
            found = shaped(j, family=family, **{"lambda": 0.4})
            check(family, found, lambda u: blended_formulas(0.4, u, g)[j])
    for j in range(3):
        found = shaped(j, 3, family="han-quadratic", **{"lambda": 0.5})
        check("Han's quadratic", found, lambda u: han_quadratic_formulas(0.5, u)[j])
    for j in range(5):
        found = shaped(j, 5, family="trig-bezier", n1=2, n2=2, alpha=3, beta=2.5, phi="trig")
        check("trigonometric", found, lambda u: trig_formulas(3, 2.5, u)[j])
    for j in range(5):
        turn = 2 * math.pi / 5
        check("cyclic", shaped(j, 5, family="cyclic"), lambda x: cyclic_formula(2, turn * (x - j)))
    for j, found in enumerate(space("0,i", "pi/2")):
        check("T2", found, lambda u: circle_formulas(math.pi / 2, u)[j])
    for j in range(7):
        found = knots(j, 4, UNEVEN, PLACES)
        check("knots", found, lambda u: cox(j, 4, UNEVEN, u))


# Cubic, clamped, with a double knot in 4.
UNEVEN = [0, 0, 0, 0, 1, 4, 4, 6, 6, 6, 6]
PLACES = [round(0.05 * i, 2) for i in range(120)]

# Pictures.

WIDTH, HEIGHT, MARGIN = 340, 236, 30
FOOT = 48


class Panel:
    """Curves over an interval, with a heading."""

    def __init__(self, title, curves, across, up=(0.0, 1.0), marks=None):
        self.title, self.curves, self.across, self.up = title, curves, across, up
        self.marks = marks if marks is not None else range(math.ceil(across[0]), math.floor(across[1]) + 1)

    def draw(self, left):
        (x0, x1), (y0, y1) = self.across, self.up
        place = lambda x, y: (
            left + MARGIN + (x - x0) / (x1 - x0) * (WIDTH - 2 * MARGIN),
            HEIGHT - FOOT - (y - y0) / (y1 - y0) * (HEIGHT - FOOT - MARGIN),
        )
        path = lambda points: "M" + "L".join("{:.2f} {:.2f} ".format(*place(x, y)) for x, y in points).strip()
        lines = [f'<text x="{left + MARGIN}" y="18" font-weight="bold">{self.title}</text>']
        for mark in self.marks:
            lines.append(f'<path d="{path([(mark, y0), (mark, y1)])}" stroke="#dddddd"/>')
            x, y = place(mark, y0)
            lines.append(f'<text x="{x:.2f}" y="{y + 14:.2f}" text-anchor="middle">{mark:g}</text>')
        for level in (y0, 0.0, 1.0):
            if y0 <= level <= y1:
                lines.append(f'<path d="{path([(x0, level), (x1, level)])}" stroke="#888888"/>')
        for level in (0.0, 1.0):
            x, y = place(x0, level)
            lines.append(f'<text x="{x - 6:.2f}" y="{y + 4:.2f}" text-anchor="end">{level:g}</text>')
        names = list(dict.fromkeys(name for name, _ in self.curves))
        for number, (name, points) in enumerate(self.curves):
            color = COLORS[(names.index(name) if name else number) % len(COLORS)]
            lines.append(f'<path d="{path(points)}" stroke="{color}" stroke-width="1.6"/>')
        for number, name in enumerate(name for name in names if name):
            x = left + MARGIN + number * (WIDTH - MARGIN) / max(len(names), 4)
            lines.append(f'<text x="{x:.2f}" y="{HEIGHT - 12}" fill="{COLORS[number % len(COLORS)]}">{name}</text>')
        return lines


def write(name, panels):
    width = WIDTH * len(panels)
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {HEIGHT}" width="{width}" height="{HEIGHT}"'
        ' font-family="sans-serif" font-size="11" fill="none">',
        f'<rect width="{width}" height="{HEIGHT}" fill="#ffffff"/>',
    ]
    for number, panel in enumerate(panels):
        lines += panel.draw(WIDTH * number)
    text = "\n".join(lines).replace("<text ", '<text stroke="none" ')
    text = text.replace('font-weight="bold"', 'font-weight="bold" fill="#222222"')
    text = text.replace('text-anchor="middle"', 'text-anchor="middle" fill="#666666"')
    text = text.replace('text-anchor="end">', 'text-anchor="end" fill="#666666">')
    (PICTURES / f"weights_{name}.svg").write_text(text + "\n</svg>\n", encoding="utf-8")


def middle(points, shift, low, high):
    """A weight over the numbers of the points."""
    return [(x + shift, y) for x, y in points if low <= x + shift <= high]


def main():
    check_all()
    write("hermite", [
        Panel("Hermite: places and tangents", [
            (name, hermite(kind)) for kind, name in enumerate(["start", "end", "tangent", "tangent"])
        ], (0, 1), (-0.2, 1.0)),
        Panel("local spline, weight of point 4", [
            (f"k0 = {k0}", middle(weight("local", 9, 4, f"--k0={k0}"), 0, 1, 7)) for k0 in ("0", "0.5", "1", "-0.5")
        ], (1, 7), (-0.3, 1.2)),
    ])
    write("spline", [
        Panel("spline, weight of point 5", [("", weight("spline", 11, 5))], (0, 10), (-0.3, 1.0)),
        Panel("spline, weights of points 0 and 1", [
            (f"point {j}", weight("spline", 11, j)) for j in (0, 1)
        ], (0, 10), (-0.3, 1.0)),
    ])
    write("bezier", [
        Panel("Bézier, five points", [(f"point {j}", weight("bezier", 5, j)) for j in range(5)], (0, 1)),
        Panel("Bézier, twelve points", [("", weight("bezier", 12, j)) for j in range(12)], (0, 1)),
    ])
    write("bspline", [
        Panel("B-splines, weight of point 4", [
            ("degree 2", middle(weight("bspline2", 9, 4), 0.5, 1, 7)),
            ("degree 3", middle(weight("bspline3", 9, 4), -1, 1, 7)),
        ], (1, 7)),
        Panel("degree 3, open: the first points", [
            (f"point {j}", middle(weight("bspline3", 9, j), -1, -1, 4)) for j in range(4)
        ], (-1, 4)),
    ])
    write("beta", [
        Panel("beta-spline, weight of point 4: tension", [
            (f"tension {t}", middle(weight("beta", 9, 4, f"--tension={t}"), 0, 1, 7)) for t in (0, 5, 50, -3)
        ], (1, 7), (-0.4, 1.2)),
        Panel("beta-spline, weight of point 4: bias", [
            (f"bias {b}", middle(weight("beta", 9, 4, f"--bias={b}"), 0, 1, 7)) for b in (1, 3, 0.3)
        ], (1, 7)),
    ])
    write("ec", [
        Panel("1, cos u, sin u on [0, pi/2]", [
            (f"point {j}", f) for j, f in enumerate(space("0,i", "pi/2"))
        ], (0, math.pi / 2)),
        Panel("1, cos, sin, cos 2u, sin 2u on [0, 3]", [
            (f"point {j}", f) for j, f in enumerate(space("0,i,2i", "3"))
        ], (0, 3)),
    ])
    write("knots", [
        Panel("cubic over 0 0 0 0 1 4 4 6 6 6 6", [
            (f"point {j}", knots(j, 4, UNEVEN, PLACES)) for j in range(7)
        ], (0, 6), marks=[0, 1, 4, 6]),
        Panel("the same, weight 5 on point 3", [
            (f"point {j}", knots(j, 4, UNEVEN, PLACES, [1, 1, 1, 5, 1, 1, 1])) for j in range(7)
        ], (0, 6), marks=[0, 1, 4, 6]),
    ])
    write("shape", [
        Panel("C-Bézier, alpha = pi, and the cubic", [
            (name, shaped(j, family="c-bezier", alpha=alpha))
            for name, alpha in [("alpha = pi", math.pi), ("alpha = 0.01", 0.01)] for j in (0, 1)
        ], (0, 1)),
        Panel("Han, weight of point 4", [
            (f"lambda = {value}", middle(shaped(4, 9, family="han", **{"lambda": value}), 1, 1, 7))
            for value in (0, 4, -8)
        ], (1, 7), (-0.2, 1.0)),
        Panel("alpha-B-spline, weight of point 4", [
            (f"lambda = {value}", middle(shaped(4, 9, family="alpha", **{"lambda": value}), 1, 1, 7))
            for value in (0, 0.5, 1)
        ], (1, 7)),
    ])
    write("cyclic", [
        Panel("cyclic, five points", [
            (f"point {j}", shaped(j, 5, family="cyclic")) for j in range(5)
        ], (0, 5)),
        Panel("trigonometric, alpha = 3, beta = 2.5", [
            (f"point {j}", shaped(j, 5, family="trig-bezier", n1=2, n2=2, alpha=3, beta=2.5, phi="trig"))
            for j in range(5)
        ], (0, 1)),
    ])


if __name__ == "__main__":
    main()
