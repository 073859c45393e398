# SPDX-License-Identifier: GPL-3.0-or-later
"""Flat pattern pieces whose outlines and wires keep exactly their lengths on the surface."""

from . import _binary as _binary
from ._errors import ErrorCode, FlattenError
from ._plan import plan_cuts
from ._wirewarp import (
    BoundaryReport,
    Cache,
    Cloth,
    DartProposal,
    Ease,
    FlattenResult,
    HelperWire,
    Job,
    Metrics,
    Options,
    Piece,
    PieceReport,
    SeamReport,
    Wire,
    WireReport,
    __version__,
    flatten,
    measure,
    propose_darts,
    propose_seams,
    start,
)

__all__ = [
    "BoundaryReport",
    "Cache",
    "Cloth",
    "DartProposal",
    "Ease",
    "ErrorCode",
    "FlattenError",
    "FlattenResult",
    "HelperWire",
    "Job",
    "Metrics",
    "Options",
    "Piece",
    "PieceReport",
    "SeamReport",
    "Wire",
    "WireReport",
    "__version__",
    "flatten",
    "measure",
    "plan_cuts",
    "propose_darts",
    "propose_seams",
    "start",
]
