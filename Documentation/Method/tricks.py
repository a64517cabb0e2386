# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pictures of Tricks.md, for pictures.py."""

from svg import BLACK, GREEN, GREY, RED, Picture


def add_cells(image, x, y, words, fills, width=50, height=28, size=13):
    for k, (word, fill) in enumerate(zip(words, fills)):
        image.box(x + width * k, y, width, height, fill, GREY)
        image.text(x + width * (k + 0.5), y + 0.5 * height + 5, word, size)


def mask_window():
    """Three of six factors of a row: what the window of masks leaves of the rest."""
    image = Picture(760, 270)
    kept, dropped = "#dbe8f6", "#f1f2f4"
    image.text(20, 44, "factors of the row, and those of the next one", 13, anchor="start")
    add_cells(image, 380, 25, ["a_0", "a_1", "a_2", "a_3", "a_4", "a_5"], [kept] * 3 + [dropped] * 3)
    image.text(20, 109, "masks", 13, anchor="start")
    words = ["−1"] * 6 + ["0"] * 6
    add_cells(image, 80, 90, words, ["#cfe5d3"] * 6 + ["#f6d9d5"] * 6)
    image.box(80 + 3 * 50, 84, 300, 40, "none", RED, 2.4)
    image.text(80 + 6 * 50, 143, "the window begins at Padding − 3", 12, RED)
    image.text(20, 189, "bitwise and", 13, anchor="start")
    add_cells(image, 380, 170, ["a_0", "a_1", "a_2", "0", "0", "0"], [kept] * 3 + ["white"] * 3)
    for k in range(3):
        left, right = 382 + 100 * k, 478 + 100 * k
        image.line([(left, 204), (left, 212), (right, 212), (right, 204)], BLACK, 1.2)
        image.text(430 + 100 * k, 230, f"register {k + 1}", 12)
    image.text(20, 230, "two factors a register, no branch", 13, anchor="start")
    return image


def row_sum():
    """What RowSum does with the columns 7, 12, 7, 1031, 12, 7, of which 7 and 1031 share a slot."""
    image = Picture(760, 250)
    slots, row = {}, []
    for k, column in enumerate((7, 12, 7, 1031, 12, 7)):
        slot = column % 1024
        at = slots.get(slot, 0)
        is_new = not (at < len(row) and row[at] == column)
        if is_new:
            at = len(row)
            row.append(column)
        slots[slot] = at
        x = 10 + 125 * k
        image.text(x + 57, 28, f"column {column}", 13, weight="bold")
        image.text(x + 57, 48, "new" if is_new else "known", 12, GREEN if is_new else GREY)
        for s, y in ((7, 64), (12, 92)):
            image.text(x + 38, y + 18, f"slot {s}", 12)
            image.box(x + 66, y, 34, 26, "#dbe8f6" if s == slot else "#f6f8fa", GREY)
            image.text(x + 83, y + 18, f"{slots[s]}" if s in slots else "0", 13)
        for e in range(4):
            image.box(x + 6, 135 + 25 * e, 102, 25, "#dbe8f6" if e == at else "white", GREY, 1.0)
            if e < len(row):
                image.text(x + 57, 153 + 25 * e, f"{e}:  {row[e]}", 13)
    return image


def blocks():
    """A matrix in blocks of rows: what is swept in order, and what goes to the diagonal."""
    image = Picture(760, 300)
    size, block, cell = 12, 4, 20
    left, top = 40, 25
    for i in range(size):
        for j in range(size):
            inside = i // block == j // block
            fill = "#4e79a7" if i == j else "white"
            if abs(i - j) in (1, 3):
                fill = "#bcd2ee" if inside else "#f3c1bb"
            image.box(left + cell * j, top + cell * i, cell, cell, fill, "#d5d9de", 0.7)
    for k in range(0, size, block):
        image.box(left + cell * k, top + cell * k, cell * block, cell * block, "none", BLACK, 2.0)
    entries = (
        ("#4e79a7", "the diagonal"),
        ("#bcd2ee", "within a block: Gauss-Seidel, row by row"),
        ("#f3c1bb", "between blocks: values of before the sweep (Jacobi),"),
        ("none", "their moduli are added to the row's diagonal (l1)"),
    )
    for k, (fill, words) in enumerate(entries):
        if fill != "none":
            image.box(330, 60 + 34 * k, 18, 18, fill, GREY)
        image.text(360, 74 + 34 * k, words, 13, anchor="start")
    image.text(360, 225, "Each block is one thread's business, whichever", 13, anchor="start")
    image.text(360, 243, "thread that is: the bytes are always the same.", 13, anchor="start")
    return image
