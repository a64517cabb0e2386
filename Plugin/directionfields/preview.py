# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fields that are previews while a hand draws: a stroke is answered at once, and the whole field is
computed when the hand rests."""

from directionfields.pipeline import sources

# The number of faces from which the whole field takes longer than a hand waits for.
LARGE = 20000

# Whether somebody calls finish() later: a script does not, and gets whole fields.
_is_allowed = False


def previewed(change, *arguments):
    """Calls a function that changes strokes; the fields along them are previews until finish()."""
    global _is_allowed
    _is_allowed = True
    try:
        return change(*arguments)
    finally:
        _is_allowed = False


def begin(fields):
    """Makes previews of fields that are about to be computed again, where these take long."""
    for field in fields if _is_allowed else ():
        surface = field.Input
        if field.UnitLength and surface.GetDataInformation(
                surface.Port).GetNumberOfCells() >= LARGE:
            put(field, 1)


def finish():
    """Has all previews computed whole, when a view is rendered next."""
    for field in sources():
        if is_preview(field):
            put(field, 0)


def is_preview(source):
    return (source.GetXMLName() == "DirectionField" and
            source.SMProxy.GetProperty("Preview").GetElement(0) == 1)


def put(field, value):
    # An internal property, which neither states nor traces have, is no attribute.
    field.SMProxy.GetProperty("Preview").SetElement(0, value)
    field.SMProxy.UpdateVTKObjects()
