# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the pictures of this folder's pages and of Tricks.md:

    python3 Documentation/Method/pictures.py [DIRECTORY]

writes them to a directory, Documentation/Method/Pictures unless another one is given. What they show of
meshes and fields is computed by method.py.
"""

import cmath
import math
import pathlib
import sys

import method
import prescribed_pictures
import remeshing_pictures
import streamline_pictures
import tricks
from meshes import bumpy, disk, icosphere, patch
from method import Connection, cross
from svg import BLACK, BLUE, GREEN, GREY, ORANGE, PALE, RED, Chart, Picture

PI = math.pi
PICTURES = {}


def picture(draw):
    PICTURES["".join(part.capitalize() for part in draw.__name__.split("_"))] = draw
    return draw


def polar(center, radius, angle):
    return (center[0] + radius * math.cos(angle), center[1] - radius * math.sin(angle))


def add_cross(image, center, u, n, size, color=BLUE, width=1.6):
    """The n directions of u as lines from the point, for a plane that is seen from its front."""
    for k in range(n):
        angle = (cmath.phase(u) + 2 * PI * k) / n
        image.line([center, polar(center, size, angle)], color, width)


# --- Energy.md -----------------------------------------------------------------------------------------


@picture
def hat_sections():
    image = Picture(760, 300)
    corners = [(40.0, 250.0), (330.0, 250.0), (150.0, 50.0)]
    omega = 1.6

    def draw(offset, sections):
        shifted = [(x + offset, y) for x, y in corners]
        image.area(shifted, "#f6f8fa", GREY, 1.5)
        count = 7
        for i in range(count + 1):
            for j in range(count + 1 - i):
                b = [(count - i - j) / count, i / count, j / count]
                at = tuple(sum(b[c] * shifted[c][d] for c in range(3)) for d in range(2))
                for color, length, angle in sections(b):
                    image.arrow(at, polar(at, length, angle), color, 1.6, 6.0)
        for (x, y), name, dx, dy in zip(shifted, "ijk", (-16, 16, 0), (12, 12, -10)):
            image.text(x + dx, y + dy, name, 16)

    draw(0.0, lambda b: [(BLUE, 30 * b[0], 0.6)])
    draw(
        390.0, lambda b: [(BLUE, 24, 0.6), (ORANGE, 24, 0.6 + omega * b[2])]
    )
    image.text(185, 290, "ψ_i = b_i e_i", 15, BLUE)
    image.text(500, 290, "e_i", 15, BLUE)
    image.text(527, 290, "and", 14)
    image.text(554, 290, "e_j", 15, ORANGE)
    image.text(650, 290, "differ by Ω b_k", 14)
    return image


@picture
def integral_functions():
    image = Picture(760, 305)
    names = (("24 E_4", 24, 0), ("F_1", 1, 1), ("F_2", 1, 2))
    ranges = ((-0.7, 1.1), (-0.25, 0.25), (-0.45, 0.45))
    ticks = ((-0.5, 0, 0.5, 1), (-0.2, 0, 0.2), (-0.25, 0, 0.25))
    for k, ((name, factor, which), ys, marks) in enumerate(zip(names, ranges, ticks)):
        chart = Chart(image, 45 + 250 * k, 35, 195, 180, (-12, 12), ys)
        labels = [[(x, f"{x}".replace("-", "−")) for x in at] for at in ((-10, -5, 0, 5, 10), marks)]
        chart.ticks(*labels, 11)
        values = [
            (x / 10, factor * method.section_integrals(x / 10)[which]) for x in range(-120, 121, 2)
        ]
        chart.curve([(-12, 0), (12, 0)], PALE, 1)
        chart.curve([(x, f.real) for x, f in values], BLUE)
        chart.curve([(x, f.imag) for x, f in values], ORANGE, dash="5 4")
        image.text(142 + 250 * k, 24, name, 15)
        image.text(142 + 250 * k, 258, "Ω", 14)
    image.line([(275, 285), (305, 285)], BLUE, 2.0)
    image.text(312, 290, "real part", 13, anchor="start")
    image.line([(400, 285), (430, 285)], ORANGE, 2.0, dash="5 4")
    image.text(437, 290, "imaginary part", 13, anchor="start")
    return image


# --- Connection.md -----------------------------------------------------------------------------------


def add_fan(image, center, angles, radius, closed, names):
    """Triangles around a point whose corners there have these angles."""
    direction, ends = 0.0, [0.0]
    for angle in angles:
        direction += angle
        ends.append(direction)
    for k, angle in enumerate(angles):
        image.area(
            [center, polar(center, radius, ends[k]), polar(center, radius, ends[k + 1])], PALE, GREY, 1.3
        )
    for k in range(len(angles) + (0 if closed else 1)):
        color, width = (BLUE, 2.2) if k == 0 else (BLACK, 1.4)
        image.line([center, polar(center, radius, ends[k])], color, width)
        if names:
            image.text(*shift(polar(center, radius + 17, ends[k]), 0, 5), f"θ_{k}" if k else "0", 13)
    return ends


def shift(point, dx, dy):
    return (point[0] + dx, point[1] + dy)


@picture
def tangent_cone():
    image = Picture(760, 300)
    angles = [1.1, 0.8, 1.3, 0.9, 0.7]
    total = sum(angles)
    y = 145
    add_fan(image, (120, y), angles, 85, False, False)
    image.arc((120, y), 40, total, 2 * PI, RED, 1.6)
    image.text(167, y + 30, "K", 15, RED)
    image.text(120, 268, "corners laid flat: Σ α = 2π − K", 13)
    ends = add_fan(image, (385, y), [a * 2 * PI / total for a in angles], 85, True, True)
    image.arc((385, y), 34, 0, ends[1], RED, 1.6, True)
    image.text(*shift(polar((385, y), 52, 0.5 * ends[1]), 4, 5), "s α", 13, RED)
    image.text(385, 268, "interior vertex: s = 2π / Σ α", 13)
    flat = [0.9, 1.2, 0.8]
    add_fan(image, (640, y + 40), flat, 85, False, True)
    image.text(640, 268, "boundary vertex: s = 1", 13)
    return image


@picture
def transport():
    image = Picture(760, 300)
    i, j = (170, 130), (590, 130)
    theta_i, theta_j, psi, radius = 0.9, 2.2, 0.75, 110
    reference = {"i": -theta_i, "j": PI - theta_j}
    image.line([i, j], BLACK, 2.0)
    for center, name in ((i, "i"), (j, "j")):
        image.circle(center, radius, "none", GREY, 1.2)
        image.line([center, polar(center, radius, reference[name])], BLUE, 2.2)
        image.arrow(center, polar(center, 100, psi), RED, 2.6, 10)
        image.circle(center, 4, BLACK)
    image.arc(i, 44, reference["i"], 0, BLACK, 1.4, True)
    image.text(*shift(polar(i, 155, -0.3), 0, 5), "θ_i(ij)", 14)
    image.line([polar(i, 46, -0.3), polar(i, 128, -0.3)], GREY, 0.8)
    image.arc(i, 66, reference["i"], psi, RED, 1.4, True)
    image.text(*shift(polar(i, 80, 0.3), 4, 4), "φ", 15, RED)
    image.arc(j, 44, reference["j"], PI, BLACK, 1.4, True)
    image.text(*shift(polar(j, 64, 2.2), -6, 0), "θ_j(ji)", 14)
    image.arc(j, 78, reference["j"], psi, RED, 1.4, True)
    image.text(*shift(polar(j, 78, 0.4), 8, 8), "φ + ρ_{ij}", 15, RED)
    image.text(i[0] - 17, i[1] + 6, "i", 17)
    image.text(j[0] + 4, j[1] + 24, "j", 17)
    image.text(*shift(polar(i, radius, reference["i"]), 6, 16), "reference edge of i", 12, BLUE, "start")
    image.text(*shift(polar(j, radius, reference["j"]), 2, -8), "reference edge of j", 12, BLUE)
    image.text(380, 285, "ρ_{ij} = θ_j(ji) + π − θ_i(ij)", 15)
    return image


@picture
def double_cover():
    image = Picture(760, 300)
    count, width, left, height, phi = 6, 90, 90, 75, -0.6
    strips = {}
    for top, name, sign in ((35, "front", 1), (190, "back, seen from behind", -1)):
        low, high = (top + height, top) if sign > 0 else (top, top + height)
        ends = [(left + 0.5 * width * k, low if k % 2 == 0 else high) for k in range(count + 2)]
        strips[sign] = [tuple(0.5 * (p[d] + q[d]) for d in range(2)) for p, q in (ends[:2], ends[-2:])]
        for k in range(count):
            corners = ends[k : k + 3]
            image.area(corners, "#dbe8f6" if sign > 0 else "#fbe9d7", GREY, 1.3)
            x = sum(p[0] for p in corners) / 3
            y = sum(p[1] for p in corners) / 3
            image.text(x + 2, y + 5, f"{k + 1}" if sign > 0 else f"{k + 1}'", 12)
        for k in range(1, count + 1, 2):
            image.line([ends[k], shift(ends[k], 42, 0)], BLUE, 2.4)
            image.arrow(ends[k], polar(ends[k], 36, sign * phi), RED, 2.2, 8)
            image.circle(ends[k], 3, BLACK)
        image.text(*shift(ends[1], 32, -9 if sign > 0 else 20), "φ" if sign > 0 else "−φ", 14, RED)
        image.text(left + 385, top + height / 2 + 5, name, 14, anchor="start")
    front, back = strips[1], strips[-1]
    right, far = front[1][0] + 42, front[0][0] - 42
    for start, end, first, last in ((front[1], back[0], 122, 178), (back[1], front[0], 178, 122)):
        way = [start, (right, start[1]), (right, first), (far, last), (far, end[1]), end]
        image.line(way, GREEN, 1.8, dash="6 4")
    image.text(left + 385, 155, "glued crosswise: the right end of", 13, GREEN, "start")
    image.text(left + 385, 173, "each side to the other's left end", 13, GREEN, "start")
    return image


# --- Singularities.md ---------------------------------------------------------------------------------


def in_the_plane(mesh, connection, n, u):
    """Representation vectors whose angles count from the x axis, of a flat mesh."""
    turned = []
    for v in range(len(mesh.points)):
        h = mesh.fan(v)[0]
        a, b = mesh.points[v], mesh.points[mesh.head(h)]
        angle = math.atan2(b[1] - a[1], b[0] - a[0]) - connection.edge_angle[h]
        turned.append(u[v] * cmath.exp(1j * n * angle))
    return turned


@picture
def indices_of_triangles():
    image = Picture(760, 400)
    n = 4
    mesh = disk(3)
    connection = Connection(mesh)
    for panel, sign in enumerate((1, -1)):
        given = {}
        for v, p in enumerate(mesh.points):
            if mesh.is_boundary(v):
                h = mesh.fan(v)[0]
                a, b = p, mesh.points[mesh.head(h)]
                own = math.atan2(b[1] - a[1], b[0] - a[0]) - connection.edge_angle[h]
                around = math.atan2(p[1] - 0.12, p[0] - 0.2)
                given[v] = cmath.exp(1j * (sign * around + 0.4 - n * own))
        u = method.constrained(mesh, connection, n, given)
        index = method.singularity_indices(mesh, connection, n, u)
        omega = method.edge_rotations(mesh, connection, n, u)
        drawn = in_the_plane(mesh, connection, n, u)
        center, scale = (190 + 380 * panel, 178), 58

        def place(p):
            return (center[0] + scale * p[0], center[1] - scale * p[1])

        for t, triangle in enumerate(mesh.triangles):
            fill = {0: "none", 1: "#f3c1bb", -1: "#bcd2ee"}[index[t]]
            image.area([place(mesh.points[v]) for v in triangle], fill, "#c9ced6", 1.0)
            if index[t] != 0:
                angles = [math.degrees(omega[3 * t + c]) for c in range(3)]
        for v, p in enumerate(mesh.points):
            add_cross(image, place(p), drawn[v], n, 17)
        words = " + ".join(f"{a:.0f}°".replace("-", "−") for a in angles)
        words = words.replace("+ −", "− ")
        total = "360°" if sign > 0 else "−360°"
        image.text(center[0], 368, f"ω_{{ij}} + ω_{{jk}} + ω_{{ki}} = {words} = {total}", 13)
        words, color = ("index +1", RED) if sign > 0 else ("index −1", BLUE)
        image.text(center[0], 392, words, 14, color, weight="bold")
    return image


@picture
def cross_field():
    """The smoothest cross field of a closed surface from the front and from behind."""
    image = Picture(760, 400)
    n = 4
    mesh = bumpy(icosphere(2), 0.6)
    connection = Connection(mesh)
    _, u = method.smallest_eigenpair(*method.operators(mesh, connection, n), 120)
    index = method.singularity_indices(mesh, connection, n, u)
    tangent = method.frames(mesh, connection)
    for panel, side in enumerate((1, -1)):
        center, scale = (190 + 380 * panel, 178), 128

        def place(p):
            return (center[0] + side * scale * p[0], center[1] - scale * p[1])

        for t, triangle in enumerate(mesh.triangles):
            a, b, c = (mesh.points[v] for v in triangle)
            normal = cross([q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)])
            if side * normal[2] > 0:
                fill = "white" if index[t] == 0 else "#f3c1bb" if index[t] > 0 else "#bcd2ee"
                image.area([place(p) for p in (a, b, c)], fill, "#c9ced6", 0.8)
        for v, p in enumerate(mesh.points):
            normal, x, y = tangent[v]
            if side * normal[2] < 0.12:
                continue
            for k in range(n):
                angle = (cmath.phase(u[v]) + 2 * PI * k) / n
                d = [math.cos(angle) * e + math.sin(angle) * f for e, f in zip(x, y)]
                image.line([place(p), place([e + 0.075 * f for e, f in zip(p, d)])], BLUE, 1.4)
        image.text(center[0], 365, "from the front" if side > 0 else "from behind", 13)
    words = f"{index.count(1)} triangles of index 1 and {index.count(-1)} of index −1"
    image.text(380, 390, f"{words}: the sum is {sum(index)} = n χ, n = 4, χ = 2", 14)
    return image


# --- Alignment.md -------------------------------------------------------------------------------------


@picture
def strength():
    image = Picture(760, 330)
    n = 4
    mesh = bumpy(icosphere(1))
    energy, mass = method.operators(mesh, Connection(mesh), n)
    pairs = method.smallest_pairs(energy, mass, 6, 1000)
    values = [value for value, _ in pairs]
    area = 2 * sum(mass[v][v].real for v in range(len(mesh.points)))
    sigma = max(values[0], 2 * PI * n / area)
    chart = Chart(image, 60, 30, 290, 240, (0, 1), (-4.2, 2.4))
    chart.ticks(
        [(x, f"{x:g}") for x in (0, 0.25, 0.5, 0.75, 1)],
        [(-4, "−4"), (-2, "−2"), (0, "0"), (1, "1"), (2, "2")],
    )
    for value in values:
        chart.curve([(0, value / values[0]), (1, value / values[0])], "#c9ced6", 1.2)
    taus = [k / 100 for k in range(0, 100)]
    curve = [(tau, 1 - sigma / values[0] * tau / (1 - tau)) for tau in taus]
    chart.curve([p for p in curve if p[1] > -4.2], BLUE, 2.4)
    x, y = chart.at(0.5, 1 - sigma / values[0])
    image.circle((x, y), 4, BLUE, BLUE)
    image.text(x + 10, y - 8, "τ = ½", 13, BLUE, "start")
    image.text(205, 305, "τ", 14)
    image.text(205, 20, "λ_t / λ_1 (blue) and λ_k / λ_1 (grey)", 13)

    chart = Chart(image, 440, 30, 290, 240, (0, 1), (0, 1.05))
    chart.ticks([(x, f"{x:g}") for x in (0, 0.25, 0.5, 0.75, 1)], [(0, "0"), (0.5, "½"), (1, "1")])
    q = [cmath.exp(1j * (5.0 * p[0] - 4.0 * p[1] * p[2])) for p in mesh.points]
    mass_q = method.times(mass, q)
    size_q = method.dot(q, mass_q).real
    smooth, aligned = [], []
    for tau in [0.002] + [k / 40 for k in range(1, 40)] + [0.99]:
        gap = sigma * tau / (1 - tau)
        u = method.Factor(energy, mass, 1.0, gap - values[0]).solve([gap * x for x in mass_q])
        size = method.dot(u, method.times(mass, u)).real
        aligned.append((tau, abs(method.dot(u, mass_q)) / math.sqrt(size * size_q)))
        smooth.append((tau, values[0] * size / method.dot(u, method.times(energy, u)).real))
    chart.curve(aligned, RED)
    chart.curve(smooth, GREEN)
    image.text(585, 305, "τ", 14)
    image.text(480, 20, "|⟨q, u⟩| / ‖q‖ ‖u‖", 13, RED)
    image.text(645, 20, "λ_1 ‖u‖^2 / u^*A u", 13, GREEN)
    return image


@picture
def constraint_priorities():
    """A sheet with a boundary, a sharp fold and a bend: what constrains which vertex."""
    image = Picture(760, 350)
    columns, rows = 15, 6
    profile, at, angle = [], (0.0, 0.0), 0.0
    turns = {4: 52, 8: -13, 9: -13, 10: -13, 11: -13}
    for k in range(columns):
        profile.append(at)
        angle += math.radians(turns.get(k, 0))
        at = (at[0] + math.cos(angle), at[1] - math.sin(angle))
    kinds = {}
    for k in range(columns):
        for r in range(rows):
            if k in (0, columns - 1) or r in (0, rows - 1):
                kinds[k, r] = "boundary"
            elif turns.get(k, 0) > 30:
                kinds[k, r] = "sharp"
            elif turns.get(k, 0) != 0:
                kinds[k, r] = "curvature"
    kinds[2, 2] = kinds[4, 3] = kinds[6, 0] = "given"
    colors = {"given": RED, "boundary": BLUE, "sharp": ORANGE, "curvature": GREEN}

    def place(k, r):
        x, z = profile[k]
        return (30 + 45 * x + 22 * r, 118 + 16 * (rows - 1 - r) - 27 * z)

    for k in range(columns - 1):
        for r in range(rows - 1):
            corners = [place(k, r), place(k + 1, r), place(k + 1, r + 1), place(k, r + 1)]
            image.area(corners, "#f6f8fa", "#c9ced6", 1.0)
    for (k, r), kind in kinds.items():
        image.circle(place(k, r), 4.5, colors[kind], colors[kind])
    entries = (
        ("given", "given: the user's vector, wherever its weight is positive"),
        ("boundary", "boundary: both edges; likewise edges of more than two triangles"),
        ("sharp", "sharp edge: the dihedral angle exceeds 40°; the edge"),
        ("curvature", "curvature: |H| l or |K| l^2 exceeds 2; a principal direction"),
    )
    for k, (kind, words) in enumerate(entries):
        image.circle((300, 22 + 23 * k), 5, colors[kind], colors[kind])
        image.text(316, 27 + 23 * k, words, 13, anchor="start")
    return image


# --- Solvers.md ---------------------------------------------------------------------------------------


@picture
def cycle():
    """The order in which Cycle::Apply visits the levels, for five of them."""
    image = Picture(760, 300)
    levels, visits = 5, []

    def apply(level):
        if level + 1 == levels:
            visits.append((level, "solve"))
            return
        visits.append((level, "down"))
        apply(level + 1)
        if level + 1 >= 2 and level + 2 < levels:
            visits.append((level + 1, "again"))
            apply(level + 1)
        visits.append((level, "up"))

    apply(0)
    step = 640 / (len(visits) - 1)
    points = [(80 + step * k, 40 + 50 * level) for k, (level, _) in enumerate(visits)]
    for level in range(levels):
        image.line([(50, 40 + 50 * level), (740, 40 + 50 * level)], PALE, 1.0)
        image.text(34, 45 + 50 * level, f"{level}", 14)
    image.line(points, GREY, 1.6)
    colors = {"down": BLUE, "up": GREEN, "again": ORANGE, "solve": RED}
    for point, (_, kind) in zip(points, visits):
        image.circle(point, 6, colors[kind], "white", 1.0)
    legend = (
        ("down", "sweep down"),
        ("solve", "Cholesky factor"),
        ("again", "residual, for once more"),
        ("up", "sweep up"),
    )
    for k, (kind, words) in enumerate(legend):
        image.circle((70 + 175 * k, 280), 6, colors[kind], "white")
        image.text(82 + 175 * k, 285, words, 13, anchor="start")
    return image


@picture
def aggregation():
    image = Picture(760, 330)
    mesh = patch(14, 9)
    energy, mass = method.operators(mesh, Connection(mesh), 4)
    group, count, strength = method.aggregates(energy, mass)
    palette = ("#4e79a7", "#f28e2b", "#59a14f", "#e15759", "#b07aa1", "#9c755f", "#edc948", "#76b7b2")

    def place(p):
        return (30 + 29 * p[0], 300 - 36 * p[1])

    for h in range(len(mesh.corners)):
        twin = mesh.twin[h]
        if twin is None or h < twin:
            a, b = mesh.tail(h), mesh.head(h)
            ends = [place(mesh.points[a]), place(mesh.points[b])]
            image.line(ends, "#9aa3ad" if b in strength[a] else "#e3e6ea", 1.1)
            if group[a] == group[b]:
                image.line(ends, palette[group[a] * 3 % len(palette)], 4.0)
    for v, p in enumerate(mesh.points):
        color = palette[group[v] * 3 % len(palette)]
        image.circle(place(p), 5, color, "white", 1.0)
    image.text(380, 322, f"{len(group)} vertices, {count} aggregates", 13)
    return image


for drawing in (
    tricks.mask_window,
    tricks.row_sum,
    tricks.blocks,
    remeshing_pictures.charts,
    remeshing_pictures.integer_grid_map,
    remeshing_pictures.extraction_steps,
    prescribed_pictures.moved_singularities,
    streamline_pictures.separatrices,
    streamline_pictures.exit_of_triangle,
):
    picture(drawing)


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent / "Pictures")
    folder.mkdir(parents=True, exist_ok=True)
    for name, draw in PICTURES.items():
        (folder / f"{name}.svg").write_bytes(str(draw()).encode("utf-8"))


if __name__ == "__main__":
    main()
