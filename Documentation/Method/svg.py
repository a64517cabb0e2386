# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""A few lines of SVG: what pictures.py draws with. The same numbers give the same bytes."""

import math
import re

BLUE, RED, GREEN, ORANGE, GREY, PALE, BLACK = (
    "#1f5fa8",
    "#c0392b",
    "#2e8540",
    "#d9822b",
    "#8a8f98",
    "#e8ebef",
    "#222222",
)


def number(x):
    text = f"{x:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


class Picture:
    """Coordinates are pixels, y downwards."""

    def __init__(self, width, height):
        self.size = (width, height)
        self.parts = []

    def line(self, points, color=BLACK, width=1.5, fill="none", closed=False, dash=None, opacity=None):
        path = "M" + "L".join(f"{number(x)} {number(y)}" for x, y in points) + ("Z" if closed else "")
        style = f' stroke-dasharray="{dash}"' if dash else ""
        style += f' fill-opacity="{number(opacity)}"' if opacity is not None else ""
        self.parts.append(
            f'<path d="{path}" fill="{fill}" stroke="{color}" stroke-width="{number(width)}" '
            f'stroke-linejoin="round" stroke-linecap="round"{style}/>'
        )

    def area(self, points, fill, color="none", width=1.0, opacity=None):
        self.line(points, color, width, fill, True, None, opacity)

    def circle(self, center, radius, fill="none", color=BLACK, width=1.5):
        self.parts.append(
            f'<circle cx="{number(center[0])}" cy="{number(center[1])}" r="{number(radius)}" '
            f'fill="{fill}" stroke="{color}" stroke-width="{number(width)}"/>'
        )

    def box(self, x, y, width, height, fill="none", color=BLACK, line=1.2):
        self.area([(x, y), (x + width, y), (x + width, y + height), (x, y + height)], fill, color, line)

    def arrow(self, start, end, color=BLACK, width=1.5, head=7.0):
        dx, dy = end[0] - start[0], end[1] - start[1]
        length = math.hypot(dx, dy)
        if length < 1e-9:
            return
        dx, dy = dx / length, dy / length
        head = min(head, 0.6 * length)
        neck = (end[0] - 0.8 * head * dx, end[1] - 0.8 * head * dy)
        self.line([start, neck], color, width)
        left = (end[0] - head * dx - 0.45 * head * dy, end[1] - head * dy + 0.45 * head * dx)
        right = (end[0] - head * dx + 0.45 * head * dy, end[1] - head * dy - 0.45 * head * dx)
        self.area([end, left, right], color)

    def arc(self, center, radius, begin, end, color=BLACK, width=1.3, arrow=False):
        """Angles counter-clockwise as seen, in radians."""
        steps = max(3, int(abs(end - begin) * 12) + 1)
        points = []
        for k in range(steps + 1):
            angle = begin + (end - begin) * k / steps
            points.append((center[0] + radius * math.cos(angle), center[1] - radius * math.sin(angle)))
        self.line(points, color, width)
        if arrow:
            self.arrow(points[-2], points[-1], color, width, 6.0)

    def text(self, x, y, words, size=14, color=BLACK, anchor="middle", weight="normal"):
        """_{...} and ^{...} lower and raise; without braces one character."""
        pieces, shift = [], 0.0
        for mark, group, single, plain in re.findall(r"([_^])(?:\{([^}]*)\}|(.))|([^_^]+)", words):
            part, wanted, scale = plain, 0.0, 1.0
            if mark:
                part, scale = group or single, 0.72
                wanted = (0.25 if mark == "_" else -0.4) * size
            part = part.replace("&", "&amp;").replace("<", "&lt;")
            move = f' dy="{number(wanted - shift)}"' if wanted != shift else ""
            smaller = f' font-size="{number(scale * size)}"' if mark else ""
            pieces.append(f"<tspan{move}{smaller}>{part}</tspan>")
            shift = wanted
        self.parts.append(
            f'<text x="{number(x)}" y="{number(y)}" font-size="{number(size)}" fill="{color}" '
            f'text-anchor="{anchor}" font-weight="{weight}" xml:space="preserve">{"".join(pieces)}</text>'
        )

    def __str__(self):
        width, height = (number(x) for x in self.size)
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" '
            f'viewBox="0 0 {width} {height}" font-family="DejaVu Sans, Verdana, Arial, sans-serif">\n'
            f'<rect width="{width}" height="{height}" fill="white"/>\n' + "\n".join(self.parts) + "\n</svg>\n"
        )


class Chart:
    """Axes within a picture; maps values to pixels."""

    def __init__(self, picture, left, top, width, height, xs, ys):
        self.picture, self.xs, self.ys = picture, xs, ys
        self.left, self.top, self.width, self.height = left, top, width, height
        picture.box(left, top, width, height, "none", GREY)

    def at(self, x, y):
        return (
            self.left + self.width * (x - self.xs[0]) / (self.xs[1] - self.xs[0]),
            self.top + self.height * (1 - (y - self.ys[0]) / (self.ys[1] - self.ys[0])),
        )

    def ticks(self, xs, ys, size=12):
        for value, label in xs:
            x, y = self.at(value, self.ys[0])
            self.picture.line([(x, y), (x, y + 4)], GREY)
            self.picture.text(x, y + 8 + size, label, size)
        for value, label in ys:
            x, y = self.at(self.xs[0], value)
            self.picture.line([(x, y), (x - 4, y)], GREY)
            self.picture.text(x - 7, y + 0.35 * size, label, size, anchor="end")

    def curve(self, points, color, width=2.0, dash=None):
        self.picture.line([self.at(x, y) for x, y in points], color, width, dash=dash)
