# SPDX-License-Identifier: GPL-3.0-or-later
from collections.abc import Iterable, Mapping
from enum import StrEnum
from typing import Any

class ErrorCode(StrEnum):
    invalid_shape = "invalid_shape"
    invalid_type = "invalid_type"
    invalid_option = "invalid_option"
    empty_mesh = "empty_mesh"
    vertex_out_of_range = "vertex_out_of_range"
    non_finite_coordinates = "non_finite_coordinates"
    loose_faces = "loose_faces"
    seam_not_an_edge = "seam_not_an_edge"
    wire_not_an_edge = "wire_not_an_edge"
    wire_too_short = "wire_too_short"
    edge_in_two_wires = "edge_in_two_wires"
    invalid_tolerance = "invalid_tolerance"
    invalid_ease = "invalid_ease"
    ease_without_side = "ease_without_side"
    side_in_two_eases = "side_in_two_eases"
    repeated_vertex_in_face = "repeated_vertex_in_face"
    repeated_face = "repeated_face"
    zero_area_face = "zero_area_face"
    non_manifold_edge = "non_manifold_edge"
    non_manifold_vertex = "non_manifold_vertex"
    inconsistent_orientation = "inconsistent_orientation"
    closed_chart = "closed_chart"
    handles = "handles"
    boundary_too_short = "boundary_too_short"
    infeasible_lengths = "infeasible_lengths"
    not_solvable = "not_solvable"
    cancelled = "cancelled"
    uv_discontinuous = "uv_discontinuous"
    no_layout = "no_layout"
    lengths_not_kept = "lengths_not_kept"
    flipped_faces = "flipped_faces"
    overlapping_faces = "overlapping_faces"
    no_proposal = "no_proposal"
    @property
    def meaning(self) -> str: ...
    @property
    def remedy(self) -> str: ...
    @property
    def arguments(self) -> str: ...

class FlattenError(ValueError):
    code: ErrorCode
    message: str
    vertices: tuple[int, ...]
    edges: tuple[tuple[int, int], ...]
    faces: tuple[int, ...]
    has_layout: bool
    proposed_seams: tuple[tuple[int, int], ...]
    proposed_tolerances: tuple[tuple[int, float], ...]
    arguments: dict[str, Any]
    def __init__(
        self,
        code: ErrorCode | str,
        message: str,
        vertices: Iterable[int] = ...,
        edges: Iterable[tuple[int, int]] = ...,
        faces: Iterable[int] = ...,
        has_layout: bool = ...,
        proposed_seams: Iterable[tuple[int, int]] = ...,
        proposed_tolerances: Iterable[tuple[int, float]] = ...,
        arguments: Mapping[str, Any] = ...,
    ) -> None: ...
    def to_dict(self) -> dict[str, Any]: ...
