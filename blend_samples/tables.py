# SPDX-License-Identifier: GPL-3.0-or-later
"""Formats the JSON report of a flattening as tables in millimeters. Needs only Python."""

from __future__ import annotations


def object_tables(report: dict) -> str:
    """Return tables of an object of the report: lines of all pieces, seams and wires, with model and flat lengths."""
    blocks = [_piece_table(piece) for piece in report["pieces"]]
    if report["seams"]:
        blocks.append(_seam_table(report["seams"]))
    if report["wires"]:
        blocks.append(_table("whole wires", [_row(wire["name"], wire) for wire in report["wires"]]))
    blocks += [issue["sentence"] for issue in report["issues"]]
    return "\n\n".join(blocks)


def _piece_table(piece: dict) -> str:
    title = (
        f"piece {piece['index'] + 1}: {_area(piece['area_3d_m2'])} on the model, {_area(piece['area_2d_m2'])} flat, "
        + _distortion(piece)
    )
    outline = [
        _row("open edge" if line["seam"] is None else f"seam {line['seam'] + 1}", line) for line in piece["outline"]
    ]
    return _table(title, [_row(wire["name"], wire) for wire in piece["wires"]] + outline)


def _distortion(piece: dict) -> str:
    if not piece["has_layout"]:
        return "no layout"
    return (
        f"energy {piece['arap_energy']:.5f}, aspect ratio up to {piece['aspect_ratio_max']:.3f}, "
        f"{piece['flipped_faces']} faces flipped, {piece['overlapping_faces']} overlapping"
    )


def _seam_table(seams: list[dict]) -> str:
    rows = []
    for seam in seams:
        numbers = list(dict.fromkeys(str(piece + 1) for piece in seam["pieces"]))
        place = f"in piece {numbers[0]}" if len(numbers) == 1 else f"pieces {', '.join(numbers)}"
        rows.append([*_row(f"seam {seam['index'] + 1}, {place}", seam), _millimeters(seam["mismatch_m"], 4)])
    return _table("seams, both sides", rows, "mismatch")


def _row(name: str, line: dict) -> list[str]:
    """Return the name, the length on the model, the flat lengths of all sides, and the largest difference."""
    flat = " | ".join(_millimeters(length, 3) for length in line["length_2d_m"])
    differences = [abs(length) for length in line["difference_m"] if length is not None]
    worst = _millimeters(max(differences, default=None), 4)
    return [name, f"{1000 * line['length_3d_m']:.3f}", flat, worst]


def _table(title: str, rows: list[list[str]], *more: str) -> str:
    rows = [["mm", "model", "flat", "difference", *more], *rows]
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))]
    lines = [f"  {title}"]
    for row in rows:
        cells = [cell.rjust(width) for cell, width in zip(row, widths, strict=True)]
        lines.append("    " + "  ".join([row[0].ljust(widths[0]), *cells[1:]]))
    return "\n".join(lines)


def _millimeters(meters: float | None, decimals: int) -> str:
    return "none" if meters is None else f"{1000 * meters:.{decimals}f}"


def _area(square_meters: float | None) -> str:
    return "no area" if square_meters is None else f"{1e4 * square_meters:.1f} cm²"
