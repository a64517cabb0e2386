# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Properties of fields that go well together, for the kinds of surfaces that there are."""

from paraview import servermanager
from paraview import simple

from directionfields.compute import field_for
from directionfields.picture import complain, draw, view_of_button
from directionfields.restore import Messages, Pipeline

# What all of them decide. Degree comes first, since it decides which alignments there are.
_COMMON = {"Degree": 4, "UnitLength": 1, "EnergyBias": 0.0, "SingularityCost": 1.0,
           "Alignment": "None", "ConstrainBoundary": 0, "ConstrainSharpEdges": 0,
           "ConstrainCurvature": 0}
PRESETS = {
    # Noise has no sharp edges that count, hence only the larger part of the shape leads.
    "Scan": {"Alignment": "Principal Curvature", "AlignmentStrength": 0.25, "ConstrainBoundary": 1},
    "CAD part": {"SingularityCost": 0.0, "ConstrainBoundary": 1, "ConstrainSharpEdges": 1,
                 "ConstrainCurvature": 1},
    "Sheet": {"ConstrainBoundary": 1},
    # Along what is bent least, as fibres lie.
    "Fibres": {"Degree": 2, "Alignment": "Principal Curvature", "AlignmentStrength": 0.5,
               "CurvatureDirection": "Least Bent"},
}
# What the field says of properties that change nothing on its surface, and what is set instead.
_IDLE = (("Turn Constrain Boundary off", "ConstrainBoundary", 0),
         ("Constrain Sharp Edges changes nothing", "ConstrainSharpEdges", 0),
         ("Constrain Curvature changes nothing", "ConstrainCurvature", 0),
         ("Choose another Alignment", "Alignment", "None"))


def apply_preset(name):
    """Gives the field of the active source the properties of a preset, and shows it: what the menu
    "Direction field preset" does.

    name  "Scan", "CAD part", "Sheet" or "Fibres", the keys of presets.PRESETS

    What would change nothing, as the boundary of a closed surface, is left off. Constraints
    along strokes stay, but an alignment to vectors or tensors does not, and Energy Bias is 0; a mesh
    without a field gets one. Returns the Direction Field, or None where there
    is none; then one sentence in ParaView's messages says why, and everything is as it was."""
    try:
        if name not in PRESETS:
            raise ValueError(f"There is no preset {name}, but {', '.join(PRESETS)}.")
        source = simple.GetActiveSource()
        with Pipeline():
            field = computed_of(field_for(source, UnitLength=1))
            before = {key: field.GetPropertyValue(key) for key in {**_COMMON, **PRESETS[name]}}
            try:
                choose(field, name)
                draw(simple.OutputPort(field, 0), view_of_button(), {}, True)
            except Exception:
                for key, value in before.items():
                    setattr(field, key, value)
                raise
            return field
    except Exception as problem:  # A menu has nobody to catch what it raises.
        complain("Direction field preset", problem)
        return None


def computed_of(field):
    """The Direction Field that a field is, or was edited from."""
    while field is not None and field.GetXMLName() != "DirectionField":
        field = field.Input if field.GetXMLName() == "EditSingularities" else None
    if field is None:
        raise ValueError("This field is not computed here: select its mesh's Direction Field, or "
                         "a mesh without a field.")
    return field


def choose(field, name):
    with Messages() as messages:
        for key, value in {**_COMMON, **PRESETS[name]}.items():
            setattr(field, key, value)
        field.UpdatePipeline()
        said = warnings_of(field)
        # On the way to what fits this surface.
        messages.warnings.clear()
        for words, key, value in _IDLE:
            if any(words in text for text in said):
                setattr(field, key, value)
        field.UpdatePipeline()


def warnings_of(field):
    data = servermanager.Fetch(field)
    blocks = [data]
    if data.IsA("vtkCompositeDataSet"):
        # Groups may be within groups.
        blocks, leaves = [], data.NewIterator()
        leaves.InitTraversal()
        while not leaves.IsDoneWithTraversal():
            blocks.append(leaves.GetCurrentDataObject())
            leaves.GoToNextItem()
    texts = []
    for block in blocks:
        array = block.GetFieldData().GetAbstractArray("Warnings")
        texts += [array.GetValue(k) for k in range(array.GetNumberOfValues())] if array else []
    return texts
