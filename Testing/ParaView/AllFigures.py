# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""Gives all filters that are made from now on their figures in the field data (Diagnostics)."""
import json

from paraview.modules.vtkRemotingServerManager import vtkSMSettings

FILTERS = ("DirectionField", "DirectionFieldGlyphs", "DirectionFieldStreamlines", "StripePattern",
           "EditSingularities", "CompareDirectionFields", "FieldAlignedRemesh")


def switch_on():
    vtkSMSettings.GetInstance().AddCollectionFromString(
        json.dumps({"filters": {name: {"Diagnostics": 1} for name in FILTERS}}), 1.0)
