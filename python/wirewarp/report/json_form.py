# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes and reads a report as JSON. The keys are the names of fields in model.py.

- lengths and areas: in units of the model, and in meters and square meters under the name with "_m" or "_m2"
- derived values (DERIVED): written for scripts, but not read
- missing numbers: null
- infinite tolerance of a free wire: "inf", because JSON has no infinity
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import fields, is_dataclass
from functools import cache
from types import NoneType, UnionType
from typing import Any, TypeVar, Union, get_args, get_origin, get_type_hints

from .model import Lengths, Report, Threads

SCHEMA = "wirewarp-report-6"
LENGTHS = {"length_3d", "length_2d", "length_asked", "difference", "mismatch"}
AREAS = {"area_3d", "area_2d"}
DERIVED = {Lengths: ("difference", "percent"), Threads: ("over",), Report: ("ok", "method_name")}
AnyReport = TypeVar("AnyReport", bound=Report)


class ReportError(ValueError):
    """Raised for data that is not a report of this version. str() is a sentence."""


def to_dict(report: Report) -> dict[str, Any]:
    written: dict[str, Any] = _plain(report, report.meters)
    return {"schema": SCHEMA, **written}


def run_to_dict(version: str, units: dict[str, Any], reports: Sequence[Report]) -> dict[str, Any]:
    """Return the reports of one run as a dict. version: version of WireWarp. units: the units of the scene."""
    return {
        "schema": SCHEMA,
        "wirewarp": version,
        "units": units,
        "ok": all(report.ok for report in reports),
        "objects": [to_dict(report) for report in reports],
    }


def from_dict(data: object, kind: type[AnyReport]) -> AnyReport:
    """Return the report that to_dict() wrote.

    kind: Report, or a subclass with more fields. Raises ReportError if `data` is not such a report.
    """
    if not isinstance(data, dict) or data.get("schema") != SCHEMA:
        raise ReportError(f'The report does not have the schema "{SCHEMA}".')
    found: AnyReport = _read(kind, data, "report")
    return found


def _plain(value: Any, meters: float) -> Any:  # noqa: ANN401 (JSON)
    if is_dataclass(value):
        names = [each.name for each in fields(value)] + _derived(type(value))
        found = {name: _plain(getattr(value, name), meters) for name in names}
        for name in names:
            if name in LENGTHS:
                found[f"{name}_m"] = _times(found[name], meters)
            elif name in AREAS:
                found[f"{name}_m2"] = _times(found[name], meters**2)
        return found
    if isinstance(value, dict):
        return {key: _plain(each, meters) for key, each in value.items()}
    if isinstance(value, (list, tuple)):
        if value and isinstance(value[0], int):
            return list(value)
        return [_plain(each, meters) for each in value]
    return "inf" if isinstance(value, float) and math.isinf(value) else value


def _times(value: Any, factor: float) -> Any:  # noqa: ANN401 (JSON)
    if isinstance(value, list):
        return [_times(each, factor) for each in value]
    return None if value is None else value * factor


def _derived(kind: type) -> list[str]:
    return [name for owner, names in DERIVED.items() if issubclass(kind, owner) for name in names]


_types = cache(get_type_hints)


def _read(kind: Any, value: Any, place: str) -> Any:  # noqa: ANN401 (JSON)
    if kind is Any:
        return value
    if is_dataclass(kind):
        return _read_fields(kind, value, place)  # type: ignore[arg-type]
    origin, inner = get_origin(kind), get_args(kind)
    if origin in (Union, UnionType):
        return None if value is None and NoneType in inner else _read(inner[0], value, place)
    if origin is list and isinstance(value, list):
        return [_read(inner[0], each, place) for each in value]
    if origin is tuple and isinstance(value, list) and len(value) == len(inner):
        return tuple(_read(own, each, place) for own, each in zip(inner, value, strict=True))
    if origin is dict and isinstance(value, dict):
        return value
    if kind is float and value == "inf":
        return math.inf
    if kind is float and isinstance(value, int) and not isinstance(value, bool):
        return float(value)
    if origin is None and type(value) is kind:
        return value
    raise ReportError(f"The report has {value!r} at {place}.")


def _read_fields(kind: Callable[..., Any], value: Any, place: str) -> Any:  # noqa: ANN401 (JSON)
    types = _types(kind)
    if not isinstance(value, dict):
        raise ReportError(f"The report has {value!r} at {place}.")
    missing = [each.name for each in fields(kind) if each.name not in value]  # type: ignore[arg-type]
    if missing:
        raise ReportError(f'The report has no "{missing[0]}" at {place}.')
    return kind(**{name: _read(types[name], value[name], f"{place}.{name}") for name in types if name in value})
