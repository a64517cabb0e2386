# SPDX-FileCopyrightText: Copyright (c) the Direction Fields authors
# SPDX-License-Identifier: BSD-3-Clause
from os import PathLike
from typing import Any, Callable, Dict, Iterable, Literal, Mapping, Optional, Tuple, Union

from numpy import ndarray
from numpy.typing import ArrayLike

Polygons = Union[ArrayLike, Tuple[ArrayLike, ArrayLike]]
Progress = Optional[Callable[[float], object]]

class DirectionFieldWarning(UserWarning): ...
class MeshError(ValueError): ...
class FileError(OSError): ...

def options(function: str = "field") -> dict[str, tuple[Any, ...]]: ...

class _Result:
    summary: str
    warnings: list[str]
    def polydata(self) -> Any: ...
    def plot(self, **keywords: Any) -> Any: ...

class Field(_Result):
    directions: ndarray
    representation: ndarray
    energy_density: ndarray
    normals: ndarray
    x_axes: ndarray
    constraints: ndarray
    constraint_directions: ndarray
    original_points: ndarray
    indices: ndarray
    components: ndarray
    eigenvalue: ndarray
    mean_curvature: ndarray
    gaussian_curvature: ndarray
    major_values: ndarray
    minor_values: ndarray
    anisotropy: ndarray
    surface_tensors: ndarray
    isotropic_share: float
    degree: int
    converged: bool
    magnitudes: Optional[ndarray]
    polygons: Optional[ndarray]
    principal_directions: tuple[ndarray, ndarray]
    @property
    def points(self) -> ndarray: ...
    @property
    def triangles(self) -> ndarray: ...
    @property
    def singularities(self) -> ndarray: ...
    def edit(
        self,
        wanted: Mapping[int, int],
        *,
        vectors: Optional[ArrayLike] = None,
        weights: Optional[ArrayLike] = None,
        progress: Progress = None,
        add: bool = False,
        objective: Literal['smoothest', 'least_change'] = 'smoothest',
        balance: bool = False,
        refine: bool = False,
        keep_constraints: bool = True,
        alignment: Literal['none', 'curvature', 'vectors'] = 'none',
        alignment_strength: float = 0.5,
        number_of_threads: int = 0,
    ) -> Field: ...
    def at_triangles(self) -> ndarray: ...
    def derivatives(self) -> tuple[ndarray, ndarray]: ...
    def write(
        self,
        path: Union[str, PathLike[str]],
        *,
        at: Literal['points', 'triangles'] = 'triangles',
        feature_angle: float = 40.0,
        minimum_feature_length: float = 0.5,
    ) -> None: ...

class Lines(_Result):
    points: ndarray
    normals: ndarray
    directions: ndarray
    arc: ndarray
    magnitudes: ndarray
    nearest_points: ndarray
    branches: ndarray
    offsets: ndarray
    seeds: ndarray
    families: ndarray
    lengths: ndarray
    closed: ndarray
    ends: ndarray
    end_nodes: ndarray
    nodes: ndarray
    node_types: ndarray
    node_indices: ndarray
    node_triangles: ndarray
    spacing: float

class Stripes(_Result):
    points: ndarray
    normals: ndarray
    arc: ndarray
    offsets: ndarray
    lengths: ndarray
    closed: ndarray
    end_singularities: ndarray
    band_points: ndarray
    band_normals: ndarray
    band_offsets: ndarray
    band_corners: ndarray
    band_phases: ndarray
    band_triangles: ndarray
    stripe: ndarray
    singularities: ndarray
    singular_triangles: ndarray
    stripe_indices: ndarray
    field_indices: ndarray
    misfit: float
    spacing: float

class Mesh(_Result):
    points: ndarray
    faces: ndarray
    quality: ndarray
    aspect_ratios: ndarray
    warpages: ndarray
    passes: ndarray
    irregular: ndarray
    kinds: ndarray
    field_indices: ndarray
    source_triangles: ndarray
    source_weights: ndarray
    source_faces: ndarray
    chains: Dict[str, ndarray]
    regions: ndarray
    regions_lost: ndarray
    borders_kept: float
    corners_missed: int
    largest_area_error: float
    edge_length: float
    edges_as_wanted: float
    error_of_sizes: float
    boundary_unevenness: float
    boundary_points_kept: int
    maximum_distance: float

class Guidance(_Result):
    vectors: ndarray
    weights: ndarray
    strengths: Optional[ndarray]
    major_values: ndarray
    minor_values: ndarray
    anisotropy: ndarray
    samples: int
    far_samples: int
    isotropic_share: float
    asymmetric_part: float

class Comparison(_Result):
    angles: ndarray
    mean: float
    maximum: float
    singularities: list[tuple[int, int, int, int, float]]

def field(
    points: ArrayLike,
    triangles: Polygons,
    *,
    vectors: Optional[ArrayLike] = None,
    weights: Optional[ArrayLike] = None,
    strengths: Optional[ArrayLike] = None,
    tensors: Optional[ArrayLike] = None,
    progress: Progress = None,
    degree: int = 4,
    energy_bias: float = 0.0,
    tolerance: float = 1e-06,
    maximum_iterations: int = 200,
    number_of_threads: int = 0,
    alignment: Literal['none', 'curvature', 'vectors', 'tensor'] = 'none',
    curvature_direction: Literal['maximum', 'minimum', 'least_bent', 'most_bent'] = 'maximum',
    alignment_strength: float = 0.5,
    use_shift: bool = False,
    shift: float = 0.0,
    constrain_boundary: bool = False,
    constrain_sharp_edges: bool = False,
    feature_angle: float = 40.0,
    constrain_curvature: bool = False,
    curvature_tolerance: float = 2.0,
    consistency_angle: float = 30.0,
    drop_constraints_at_singularities: bool = False,
    constrain_guidance: bool = False,
    constraint_solver: Literal['least_squares', 'energy'] = 'energy',
    solver: Literal['automatic', 'multigrid', 'direct'] = 'automatic',
    merge_points: Literal['off', 'on', 'automatic'] = 'automatic',
    intrinsic_delaunay: bool = False,
    minimum_feature_length: float = 0.5,
    unit_length: bool = False,
    singularity_cost: float = 0.0,
    curvature_scale: float = 0.0,
    number_of_starts: int = 0,
    preview: bool = False,
    tensors_at: Literal['points', 'triangles'] = 'points',
    tensor_direction: Literal['major', 'minor', 'larger_magnitude'] = 'major',
    tensor_strength: float = 1.0,
    tensor_scale: float = 0.0,
) -> Field: ...

def curvature(
    points: ArrayLike,
    triangles: Polygons,
    *,
    scale: float = 0.0,
) -> Field: ...

def from_directions(
    points: ArrayLike,
    triangles: Polygons,
    directions: ArrayLike,
    magnitudes: Optional[ArrayLike] = None,
) -> Field: ...

def read(
    points: ArrayLike,
    triangles: Polygons,
    path: Union[str, PathLike[str]],
    *,
    at: Literal['automatic', 'triangles', 'points'] = 'automatic',
) -> Field: ...

def streamlines(
    field: Field,
    points: Optional[ArrayLike] = None,
    *,
    progress: Progress = None,
    start: Literal['evenly', 'singularities', 'points'] = 'evenly',
    spacing: float = 0.0,
    ratio: float = 0.5,
    maximum_length: float = 0.0,
    minimum_length: float = 0.0,
    stop_at_crossings: bool = False,
    direction: Literal['both', 'forward', 'backward'] = 'both',
    maximum_number: int = 100000,
    offset: float = 0.03,
    number_of_threads: int = 0,
) -> Lines: ...

def graph(
    field: Field,
    *,
    progress: Progress = None,
    **options: Any,
) -> Lines: ...

def stripes(
    field: Field,
    *,
    spacings: Optional[ArrayLike] = None,
    progress: Progress = None,
    direction: Literal['along', 'across'] = 'along',
    spacing: float = 0.0,
    line_offset: float = 0.0,
    bands: bool = True,
    phases: bool = False,
    number_of_threads: int = 0,
) -> Stripes: ...

def remesh(
    points: Union[ArrayLike, Field],
    triangles: Optional[Polygons] = None,
    *,
    sizing: Optional[ArrayLike] = None,
    regions: Optional[ArrayLike] = None,
    curves: Iterable[ArrayLike] = (),
    given_points: Optional[ArrayLike] = None,
    progress: Progress = None,
    element: Literal['quads', 'triangles'] = 'quads',
    faces: int = 5000,
    edge_length: float = 0.0,
    sizing_is_length: bool = False,
    size_source: Literal['sizing', 'curvature', 'second_derivatives'] = 'sizing',
    maximum_error: float = 0.0,
    gradation: float = 0.0,
    add_irregular_pairs: bool = True,
    pure_quads: bool = False,
    boundary_spacing: Literal['free', 'even', 'keep'] = 'free',
    keep_thin_parts: bool = True,
    keep_features: bool = True,
    feature_angle: float = 40.0,
    minimum_feature_length: float = 0.5,
    keep_soft_features: bool = True,
    alignment: Literal['shape', 'smooth'] = 'shape',
    alignment_strength: float = 0.25,
    singularity_cost: float = 1.5,
    smoothing_iterations: int = 12,
    minimum_scaled_jacobian: float = 0.0,
    maximum_aspect_ratio: float = 0.0,
    maximum_warpage: float = 0.0,
    number_of_threads: int = 0,
) -> Mesh: ...

def guide_by_curves(
    points: ArrayLike,
    triangles: Polygons,
    curves: Iterable[ArrayLike],
    *,
    strengths: Optional[ArrayLike] = None,
    progress: Progress = None,
    degree: int = 4,
    radius: float = 0.0,
    falloff: float = 0.5,
    maximum_distance: float = 0.0,
    number_of_threads: int = 0,
) -> Guidance: ...

def guide_by_tensors(
    points: ArrayLike,
    triangles: Polygons,
    tensors: ArrayLike,
    *,
    at: Literal["points", "triangles"] = "points",
    progress: Progress = None,
    direction: Literal['major', 'minor', 'larger_magnitude'] = 'major',
    scale: float = 0.0,
    number_of_threads: int = 0,
) -> Guidance: ...

def compare(
    field: Field,
    other: Field,
    *,
    progress: Progress = None,
) -> Comparison: ...
