# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
"""What each option means, and the libraries' sentences in the words of Python."""

import re


def _lines(text):
    lines = (line.strip() for line in text.splitlines())
    return dict(line.split(": ", 1) for line in lines if line)


_COMMON = """
    feature_angle: Angle between the normals of two triangles above which their edge is sharp.
    minimum_feature_length: Shorter chains of sharp edges are noise; parts of the root of the area.
    number_of_threads: 0 for as many as there are, or OMP_NUM_THREADS; no byte depends on it.
    alignment_strength: 0 for the smoothest field, 1 for the guidance itself.
"""
DESCRIPTIONS = {name: _lines(_COMMON + text) for name, text in {
    "field": """
        degree: Directions at each point: 1 vector, 2 line, 4 cross, 6 hex field.
        energy_bias: 1 for the holomorphic energy, -1 for the antiholomorphic one, 0 Dirichlet's.
        tolerance: Relative residual up to which an eigenvalue problem counts as solved.
        maximum_iterations: Most solves or cycles of a component.
        alignment: What the field is drawn to.
        curvature_direction: Which principal direction a field of degree 2 follows.
        use_shift: Take shift in place of alignment_strength.
        shift: The eigenvalue less lambda_t of the aligned system, in 1 / length^2.
        constrain_boundary: Points on the boundary follow it.
        constrain_sharp_edges: Points on sharp edges follow these.
        constrain_curvature: Points of high curvature follow it; degrees 2 and 4.
        curvature_tolerance: Curvature is high above this; a sphere has 1.
        consistency_angle: Curvature constraints that differ more from their neighbours are dropped.
        drop_constraints_at_singularities: Drop curvature constraints that wind around a triangle.
        constrain_guidance: Points with a vector and a positive weight follow it.
        constraint_solver: What is least: the residual of the whole system, or the energy.
        solver: How matrices are inverted.
        merge_points: Which points at one place are one; automatic: those of seams.
        intrinsic_delaunay: Take the energy on the intrinsic Delaunay triangulation.
        unit_length: Go on to vectors of unit length, with straighter directions.
        singularity_cost: What one singularity costs a field of unit length.
        curvature_scale: Radius that curvature is averaged over, in edges; 0 finds it by the noise.
        number_of_starts: With unit_length, starts of which the best is kept; 0 chooses by size.
        preview: With unit_length, only scale the first field to unit length, in less time.
        tensors_at: What has a tensor each.
        tensor_direction: Which principal direction lines follow; crosses follow both.
        tensor_strength: 1 for the principal directions without noise, 0 for the smoothest field.
        tensor_scale: Radius that tensors are averaged over, in edges; 0 finds it by the noise.
    """,
    "edit": """
        add: Add the singularities to those there are; else they replace them.
        objective: Which field is taken: the smoothest, or the nearest to the one given.
        balance: Add the singularities that are missing to the right sum.
        refine: Split triangles that are too coarse for the singularities, in a new surface.
        keep_constraints: Constrained directions stay.
        alignment: What the field is drawn to, without a change of its singularities.
    """,
    "remesh": """
        element: Faces, along a field of degree 4 or 6.
        faces: About how many faces there are to be.
        edge_length: Wanted length of the edges, which then counts in place of faces; 0 for faces.
        sizing_is_length: Sizing has the lengths themselves, in place of faces and edge_length.
        size_source: Sizes, from the curvature, or for the function in sizing to be interpolated.
        maximum_error: Of faces, or of that function: as many faces as it needs; 0 for faces.
        gradation: The factor by which lengths beside each other may differ, 1.3 say; 0 for any.
        add_irregular_pairs: Irregular vertices are added in pairs where sizes that vary need them.
        pure_quads: No triangles between the quads.
        boundary_spacing: Points on the boundary: free, evenly spaced, or those of the surface.
        keep_thin_parts: Faces are smaller where limbs and tips would be lost.
        keep_features: Sharp edges become edges, tips of cones vertices; the boundary always edges.
        keep_soft_features: Rims of half of that angle that stand out and have room become edges.
        alignment: The field where none is given: along the shape, or the smoothest.
        singularity_cost: Less makes more irregular points, and edges of more even lengths.
        smoothing_iterations: Steps in which points move so that faces become regular.
        minimum_scaled_jacobian: What faces should have at least, for passes and warnings; 0 for any.
        maximum_aspect_ratio: What faces should have at most; 0 for any.
        maximum_warpage: What quads should have at most; 0 for any.
    """,
    "streamlines": """
        start: Where lines start: evenly spaced, at the singularities, or at points.
        spacing: Distance between neighbouring lines; 0 for the root of the area / 40.
        ratio: Lines end where others are nearer than this part of the spacing.
        maximum_length: Longer lines end; 0 for 20 times the root of the area.
        minimum_length: Shorter lines are left out; 0 for 0.9 times the spacing.
        stop_at_crossings: Lines from singularities end where they cross: the field's graph.
        direction: How lines from points run along a field of degree 1.
        maximum_number: Most lines.
        offset: Height of the lines above the surface, in parts of the spacing.
    """,
    "stripes": """
        direction: Along the directions or at right angles to them.
        spacing: Distance between neighbouring stripes; 0 for the root of the area / 40.
        line_offset: Distance of the lines from the phase 0, in parts of the spacing.
        bands: Cut the surface into bands.
        phases: Compute the phases at the corners of the bands, in cycles.
    """,
    "guide_by_curves": """
        degree: Degree of the field that is to be guided.
        radius: How far from the curves points are guided; 0: corners of the triangles on them.
        falloff: Standard deviation of the weight's Gaussian, in parts of radius; above 0.
        maximum_distance: Parts of curves farther from the surface do not count; 0: all count.
    """,
    "guide_by_tensors": """
        direction: Which principal direction lines follow; crosses follow both.
        scale: Radius that tensors are averaged over, in edges; 0 finds it by the noise.
    """,
    "read": """
        at: What the rows belong to; automatic: the triangles, if there are as many.
    """,
    "write": """
        at: What has a row each.
    """,
}.items()}

# Names by which the libraries' sentences call what is something else in Python.
_OTHERS = {
    r"Directions Per Point( \(Degree\))?|Degree": "degree",
    r"Choose a point array of three components as Guidance Vectors: Point Vectors and "
    r"Constrain Guidance need": "Give vectors: alignment='vectors' and constrain_guidance=True need",
    r"Guidance Vectors, Weights or Strengths": "vectors, weights or strengths",
    r"Guidance Vectors": "vectors",
    r"Guidance Weights": "weights",
    r"Guidance Strengths": "strengths",
    r"align to Point Vectors": "set alignment='vectors'",
    r"Constraint Solver to Energy: Least Squares": "constraint_solver='energy': 'least_squares'",
    r"Solver to Automatic": "solver='automatic'",
    r"Switch on Unit Length": "Set unit_length=True",
    r"Number ?Of ?Faces": "faces",
    r"Maximum Number Of Lines": "maximum_number",
    r"SeparatingDistanceRatio": "ratio",
    r"MaximumStreamlineLength": "maximum_length",
    r"turn Alignment and Constrain Curvature off": "leave alignment and constrain_curvature out",
    r"turn Keep Constraints off": "set keep_constraints=False",
    r"Turn Refine Where Needed on": "Set refine=True",
    r"Balance Automatically": "balance",
    r"Tensor Scale": "The radius that tensors are averaged over",
    r"Choose another Tensor Array: this one changes nothing, since its tensors are":
        "Give other tensors: these change nothing, since they are",
    r"before Direction Field": "before field()",
    r"of Direction Field": "of field()",
    r"Field Aligned Remesh": "remesh()",
    r"The array Pass shows": "passes shows",
}
# Words of sentences, too.
_WORDS = {"direction", "scale", "bands", "element", "start", "at", "add", "refine", "phases", "faces"}


def _patterns():
    keywords = {keyword for named in DESCRIPTIONS.values() for keyword in named} - _WORDS
    for keyword in sorted(keywords, key=len, reverse=True):
        yield r"\b" + " ?".join(map(str.capitalize, keyword.split("_"))) + r"\b", keyword


_RULES = [(re.compile(r"\b(" + old + r")(?!\w)", re.IGNORECASE), new) for old, new in _OTHERS.items()]
_RULES += [(re.compile(old), new) for old, new in _patterns()]


def in_python(sentence):
    """The sentence with keywords in place of the names of options in C++ and ParaView."""
    for old, new in _RULES:
        sentence = old.sub(new, sentence)
    return sentence
