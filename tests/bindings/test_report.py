# SPDX-License-Identifier: GPL-3.0-or-later
"""Reports state how far fabric must stretch, the verdict, and where a dart would help."""

import csv
import io
import json
import math
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from reports import report_of
from samples import SAMPLES, eases_of, flattened, flattened_as_made, wires_of
from surfaces import grid
from wirewarp import Cloth, Options, Wire, flatten, measure
from wirewarp.report import (
    COARSE,
    Issue,
    Kind,
    LengthText,
    Level,
    Report,
    as_seen,
    failure_report,
    from_dict,
    make_report,
    report_csv,
    to_dict,
    verdict,
    with_narrow,
)
from wirewarp.report.asked import asked_of_outline
from wirewarp.report.model import ANY_FABRIC, Threads, Ways
from wirewarp.report.rows import piece_rows
from wirewarp.report.strain import connected_regions, piece_strain
from wirewarp.report.verdict import kept_text
from wirewarp.report.wording import strain_text


def report_of_pieces(*stretches, name="Bump", limits=None):
    """Return a report of pieces that must stretch this far. None is for a failed piece.

    limits: maximum stretch of the fabric in both directions.
    """
    (sample,) = report_of("Half cylinder").pieces
    pieces = [
        replace(sample, index=index, name=f"Piece {index + 1}", ok=stretch is not None, stretch=stretch)
        for index, stretch in enumerate(stretches)
    ]
    if limits:
        gives, worn = Ways(across=limits, along=limits), Ways(across=0.0, along=0.0)
        for piece in pieces:
            share = piece.stretch or 0.0
            piece.threads = Threads(cloth="denim", across=share, along=0.0, shear=0.1, gives=gives, worn=worn)
    issues = [Issue("flipped", "It flips.", piece.index) for piece in pieces if not piece.ok]
    return Report(object=name, method="refined", pieces=pieces, issues=issues)


def kinds(*reports):
    return [line.kind for line in verdict(*reports).lines]


@pytest.mark.parametrize(
    ("stretches", "limits", "expected"),
    [
        ((), None, [Kind.NOT_FLATTENED]),
        ((0.0, 0.03), None, [Kind.READY_FOR_ANY]),
        ((0.0, 0.031), None, [Kind.NEEDS_STRETCH]),
        ((0.19,), None, [Kind.NEEDS_STRETCH]),
        ((1.5, 0.19), None, [Kind.NO_FABRIC, Kind.NEEDS_STRETCH]),
        ((math.inf,), None, [Kind.NO_FABRIC]),
        ((None, 0.0), None, [Kind.FAILED, Kind.READY_FOR_ANY]),
        ((0.19,), 0.2, [Kind.READY]),
        ((0.21, 0.1), 0.2, [Kind.BEYOND_FABRIC, Kind.READY]),
    ],
)
def test_pieces_are_ready_only_if_there_is_a_fabric_for_them(stretches, limits, expected):
    found = verdict(report_of_pieces(*stretches, limits=limits))
    assert [line.kind for line in found.lines] == expected
    assert found.is_ready == all(kind.level is Level.GOOD for kind in expected)
    assert {kind for kind in Kind if kind.level is Level.GOOD} == {Kind.READY, Kind.READY_FOR_ANY}
    assert {kind for kind in Kind if kind.level is Level.BAD} == {Kind.FAILED, Kind.NOT_FLATTENED}


def test_a_failed_model_makes_the_others_not_ready():
    good, failed = report_of_pieces(0.0, name="A"), failure_report(Issue("no_faces", "It has no faces."), "B")
    for reports in ((good, failed), (failed, good)):
        found = verdict(*reports)
        assert kinds(*reports) == [Kind.FAILED, Kind.READY_FOR_ANY]
        assert (found.lines[0].text, found.is_ready) == ("Do not cut: B failed", False)
    assert kinds(failed) == [Kind.NOT_FLATTENED]


def test_the_verdict_names_the_stretch_the_pieces_and_the_fabric():
    (line,) = verdict(report_of_pieces(0.1, 0.19)).lines
    assert line.text == "Lengths are exact. Cut from fabric that stretches at least 19%."
    failed, others = verdict(report_of_pieces(None, 0.1, 0.19)).lines
    assert (failed.text, others.text) == (
        "Do not cut: 1 of 3 pieces failed",
        "Lengths of Piece 3 and Piece 2 are exact. Cut from fabric that stretches at least 19%.",
    )
    (beyond,) = verdict(report_of_pieces(0.21, limits=0.2)).lines
    assert beyond.text == (
        "Piece 1 must stretch 21% across, but this denim stretches only 20%. "
        "Add a dart or seam, or choose another fabric."
    )
    worst, second = verdict(report_of_pieces(0.21, 0.3, limits=0.2)).lines
    assert (worst.text, second.text) == (
        "Piece 2 must stretch 30% across, but this denim stretches only 20%",
        "Piece 1 must stretch 21% across, but this denim stretches only 20%. "
        "Add a dart or seam, or choose another fabric.",
    )
    (close,) = verdict(report_of_pieces(0.2004, limits=0.2)).lines
    assert close.text.startswith("Piece 1 must stretch 20.04% across, but this denim stretches only 20.00%. ")
    (collapsed,) = verdict(report_of_pieces(math.inf, limits=0.2)).lines
    assert collapsed.kind is Kind.BEYOND_FABRIC and "unlimited across" in collapsed.text
    (ready,) = verdict(report_of_pieces(0.0, 0.0)).lines
    assert ready.text == "Ready to cut from any fabric: 2 pieces, every length kept"


def test_lists_show_the_figures_that_the_verdict_compares_with_the_fabric():
    """Piece 1 must stretch more, within the limit across the grain. Piece 2 exceeds the lower limit along the grain."""
    report = report_of_pieces(0.15, 0.13, limits=0.2)
    for piece, along in zip(report.pieces, (0.01, 0.07), strict=True):
        piece.threads = replace(piece.threads, along=along, gives=Ways(across=0.2, along=0.05))
        piece.wires = []  # the sample's pieces have wires, but this report has none
    beyond, _ = verdict(report).lines
    assert beyond.text.startswith("Piece 2 must stretch 7.0% along, but this denim stretches only 5.0%.")
    rows = piece_rows(report)
    assert [(row.name, row.shown) for row in rows] == [("Piece 2", 0.07), ("Piece 1", 0.15)]
    table = csv.DictReader(io.StringIO(report_csv(report, LengthText("m", 1.0))))
    lines = [line for line in table if line["Kind"] == "Piece"]
    ways = [[float(line[f"Stretch {way} (%)"]) for way in ("across", "along")] for line in lines]
    assert ways == [pytest.approx([15, 1]), pytest.approx([13, 7])]


def test_many_pieces_are_counted_and_pieces_of_several_models_have_the_name_of_their_model():
    (line,) = verdict(report_of_pieces(*[1.5] * 6)).lines
    assert line.text.startswith("Piece 1, Piece 2, Piece 3, Piece 4 and 2 more: no fabric")
    (line, _) = verdict(report_of_pieces(1.5, name="A"), report_of_pieces(0.0, 0.1, name="B")).lines
    assert line.text.startswith("A, Piece 1: no fabric")


def test_a_closed_model_has_not_failed():
    report = report_of_pieces(None)
    closed = replace(report, issues=[Issue("closed_chart", "It is closed.", 0)])
    (line,) = verdict(closed).lines
    assert (line.kind, line.text) == (Kind.CLOSED, "This model is closed: choose where to cut it")
    assert line.kind.level is Level.CAUTION
    mixed = report_of_pieces(None, None)
    mixed.issues[0] = Issue("closed_chart", "It is closed.", 0)
    assert kinds(mixed) == [Kind.FAILED]


def test_a_piece_that_only_a_seam_flattens_has_not_failed():
    report = report_of_pieces(None, None)
    report.pieces = [replace(piece, has_layout=False) for piece in report.pieces]
    tube, outline = Issue("boundary_too_short", "It is a tube.", 0), Issue("infeasible_lengths", "No shape.", 1)

    def found(*issues):
        return verdict(replace(report, issues=list(issues))).lines

    (line,) = found(tube, replace(outline, proposed_seams=[(0, 1)]))
    assert (line.kind, line.text) == (Kind.NEEDS_SEAM, "Piece 1 and Piece 2 need seams: choose where to cut them")
    assert line.kind.level is Level.CAUTION
    closed, line = found(tube, Issue("closed_chart", "It is closed.", 1))
    assert (closed.text, line.text) == (
        "Piece 2 is closed: choose where to cut it",
        "Piece 1 needs a seam: choose where to cut it",
    )
    assert [line.kind for line in found(tube, outline)] == [Kind.FAILED]  # no seam is proposed, so a wire may be wrong
    assert [line.kind for line in found(tube, Issue("flipped_faces", "It flips.", 1))] == [Kind.FAILED]
    report.pieces[0].has_layout = True  # a failed piece with a layout could be mistaken for a good piece
    report.pieces = report.pieces[:1]
    assert [line.kind for line in found(tube)] == [Kind.FAILED]


def test_ignored_modifiers_make_no_piece_ready():
    found = as_seen(verdict(report_of_pieces(0.0)), ["modifiers", "shape keys", "modifiers"])
    (line,) = found.lines
    assert (line.kind, found.is_ready) == (Kind.NOT_AS_SEEN, False)
    assert line.text == "Modifiers and shape keys were ignored, so sizes differ from what you see"
    assert as_seen(verdict(report_of_pieces(0.0)), []).is_ready


def test_pieces_without_room_for_their_allowances_are_not_ready():
    found = with_narrow(verdict(report_of_pieces(0.0, 0.1)), {"Top": ["Piece 1", "Piece 2"]})
    assert [line.kind for line in found.lines] == [Kind.NEEDS_STRETCH, Kind.TOO_NARROW]
    sentence = "no room for two allowances in one place, and may be too narrow to sew."
    assert found.lines[1].text == f"Piece 1 and Piece 2 have {sentence}"
    (line,) = with_narrow(verdict(report_of_pieces(0.0)), {"Top": ["Piece 1"]}).lines
    assert line.text == f"Piece 1 has {sentence}"
    (line,) = with_narrow(verdict(report_of_pieces(0.0)), {"Top": ["Piece 1"], "Cap": ["Cap"], "Belt": []}).lines
    assert line.text == f"Top, Piece 1; Cap have {sentence}"
    assert with_narrow(verdict(report_of_pieces(0.0)), {"Top": []}).is_ready


def test_success_mentions_exact_lengths_only_if_they_are_fixed():
    (line,) = verdict(report_of("Wetsuit upper body")).lines
    assert line.text.startswith("Lengths are exact or within their tolerance. Cut from fabric")
    report = report_of("Carnival mask")
    wire = replace(report_of("Wetsuit upper body").wires[0], tolerance=math.inf)
    assert kept_text([report]) == "every length kept"
    assert kept_text([replace(report, wires=[wire])]) == "every length kept or within its tolerance"
    assert kept_text([replace(report, wires=[wire], method="wirewarping")]) == "every length kept"


def test_the_stretch_of_a_piece_is_sufficient_for_99_percent_of_its_area():
    shape, result, report = SAMPLES["Fitted top"], flattened("Fitted top"), report_of("Fitted top")
    corners = np.asarray(shape.vertices)[shape.triangles()]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1) / 2
    for piece, own in zip(report.pieces, result.pieces, strict=True):
        ratios, sizes = own.metrics.face_aspect_ratio, areas[own.source_face]
        shares = np.array([sizes[ratios <= ratio].sum() for ratio in ratios]) / sizes.sum()
        assert piece.stretch == pytest.approx(ratios[shares >= 0.99].min() - 1, rel=1e-9)
    assert kinds(report) == [Kind.NEEDS_STRETCH]


def test_pieces_that_unfold_are_ready_for_any_fabric():
    for name in ("Half cylinder", "Lampshade"):
        report = report_of(name)
        assert kinds(report) == [Kind.READY_FOR_ANY]
        assert max(piece.needed for piece in report.pieces) == pytest.approx(0, abs=1e-6)
        assert report.hints == []


def test_gathers_are_not_strain():
    """The waist of the skirt is twice as long as its band, so gathers compress the waist to half its length."""
    shape, result = SAMPLES["Gathered skirt"], flattened_as_made("Gathered skirt")
    mesh, wires = (shape.vertices, shape.triangles()), wires_of(shape)
    gathered = make_report(result, *mesh, wires=wires, eases=eases_of(shape))
    unintended = make_report(result, *mesh, wires=wires)  # the same shape, as if its gathers were not intended
    assert max(piece.needed for piece in gathered.pieces) < 0.1
    assert max(piece.needed for piece in unintended.pieces) > 0.9
    assert unintended.hints and not gathered.hints


def test_intended_stretch_gives_no_hint():
    """The pieces of a cylinder have no strain of their own, so they must stretch exactly by the intended 20%."""
    shape = SAMPLES["Half cylinder"]
    vertices, faces = shape.vertices, shape.triangles()
    cloth = Cloth(stretch=(0.2, 0.2))
    result = flatten(vertices, faces, options=Options(cloth=cloth))
    report = make_report(result, vertices, faces, cloth=cloth)
    assert report.pieces[0].stretch == pytest.approx(0.2, abs=1e-6)
    (line,) = verdict(report).lines
    assert line.kind is Kind.READY
    assert line.text.startswith("Ready to cut from fabric that stretches at least 20%: 1 piece")
    known = make_report(result, vertices, faces, cloth=cloth, limits=(0.1, 0.1), fabric="denim")
    assert kinds(known) == [Kind.BEYOND_FABRIC]


def test_a_piece_that_is_ready_for_any_fabric_is_ready_for_each():
    for name in Cloth.presets():
        about = Cloth.about(name)
        assert set(about) == {"label", "description", "source"} and all(about.values())
    assert min(min(Cloth.preset(name).limits) for name in Cloth.presets()) == ANY_FABRIC


@pytest.mark.parametrize(("fabric", "kind"), [("denim", Kind.BEYOND_FABRIC), ("swim", Kind.READY)])
def test_a_chosen_fabric_decides(fabric, kind):
    report = report_of("Fitted top", cloth=Cloth.preset(fabric), fabric=fabric)
    assert verdict(report).kind is kind
    codes = {hint.code for hint in report.hints} - {COARSE}
    assert codes == ({"beyond_cloth"} if kind is Kind.BEYOND_FABRIC else set())


TRIANGLE = np.array([[0.0, 0, 0], [1, 0, 0], [0, 0, 1]]), np.array([[0, 1, 2]])


def triangle_metrics(flat):
    """Return the metrics of a flat triangle whose model is TRIANGLE."""
    (piece,) = measure(*TRIANGLE, np.array([flat], float)).pieces
    return piece.metrics


@pytest.mark.parametrize(
    ("flat", "stretch", "ease"),
    [
        ([[0, 0], [1, 0], [0, 1]], 0, 0),
        ([[5, 5], [5, 6], [4, 5]], 0, 0),  # moved and rotated
        ([[0, 0], [0.8, 0], [0, 1]], 0.25, 0),  # 0.8 of fabric must stretch to 1
        ([[0, 0], [1.25, 0], [0, 1]], 0, 0.2),  # 1.25 of fabric must be compressed to 1
        ([[0, 0], [0.8, 0], [0, 1.25]], 0.25, 0.2),
        # A shear by k has the singular values s and 1/s with s - 1/s = k. For k = 1.5, s is 2.
        ([[0, 0], [1, 0], [1.5, 1]], 1.0, 0.5),
        ([[0, 0], [1, 0], [2, 0]], math.inf, 0),
    ],
)
def test_stretch_and_compression_are_the_principal_strains_of_flat_fabric(flat, stretch, ease):
    strain = piece_strain(triangle_metrics(flat))
    assert strain.stretch == pytest.approx([stretch], abs=1e-12)
    assert strain.ease == pytest.approx([ease], abs=1e-12)


def test_threads_of_a_collapsed_piece_are_stretched_without_limit():
    result = measure(*TRIANGLE, np.array([[[0.0, 0], [1, 0], [2, 0]]]))
    report = make_report(result, *TRIANGLE, cloth=Cloth.preset("denim"))
    (threads,) = [piece.threads for piece in report.pieces]
    assert (threads.across, threads.along, threads.shear) == (math.inf, math.inf, math.pi / 2) and threads.over
    written = json.dumps(to_dict(report), allow_nan=False)
    assert from_dict(json.loads(written), Report).pieces[0].threads == threads


def test_strain_in_words():
    assert strain_text(0.12, 0.09) == "stretched and compressed"
    assert strain_text(0.12, 0.01) == strain_text(math.inf, 0.1) == "stretched"
    assert strain_text(0.0, 0.34) == "compressed"


def test_regions_are_connected_by_edges():
    size = 6
    vertices, faces = grid(size, size, lambda u, v: (u, v, 0))
    piece = SimpleNamespace(faces=faces, vertices=vertices)
    cells = np.zeros((size, size), dtype=bool)
    cells[0, :] = cells[:, 0] = True  # cells that form an L
    cells[4, 4] = cells[5, 5] = True  # two cells that touch only at a corner
    members = np.repeat(cells.ravel(), 2)
    regions = connected_regions(piece, members)
    assert sorted(len(region) for region in regions) == [2, 2, 22]
    assert sorted(np.concatenate(regions)) == np.flatnonzero(members).tolist()
    assert connected_regions(piece, np.zeros(len(faces), dtype=bool)) == []


def test_a_winding_region_is_one_region():
    count = 300
    order = np.random.default_rng(1).permutation(count)  # neighbors have distant numbers
    strip = np.array([[k, k + 1, k + 2] for k in range(count)])
    piece = SimpleNamespace(faces=strip[order], vertices=np.zeros((count + 2, 2)))
    (region,) = connected_regions(piece, np.ones(count, dtype=bool))
    assert len(region) == count


def test_the_list_of_strained_places_begins_with_the_worst_piece():
    """Each of the worst pieces is in the list, even if it is small."""
    report = report_of("Toy")
    places = [hint.piece for hint in report.hints if hint.code == "strained"]
    worst_first = sorted(report.pieces, key=lambda piece: -piece.needed)
    assert list(dict.fromkeys(places)) == [piece.index for piece in worst_first[:4]]
    for piece in worst_first[:4]:
        worst = piece.stretch_faces if piece.stretch_max >= piece.ease_max else piece.ease_faces
        first = next(hint for hint in report.hints if hint.piece == piece.index)
        assert first.short.startswith(("stretched", "compressed")) and "most" in first.short
        assert first.sentence.endswith(" here. Add a dart or seam.")
        assert set(worst) & set(first.faces)


def test_unused_tolerances_are_noted():
    report = report_of("Wetsuit collar")
    assert report.notes == []
    shape = SAMPLES["Half cylinder"]
    wires = [Wire([0, 1], math.inf)]
    result = flatten(shape.vertices, shape.triangles(), wires=wires, options=Options(method="wirewarping"))
    (note,) = make_report(result, shape.vertices, shape.triangles(), wires=wires).notes
    assert not note.is_warning and "tolerances were not used" in note.text


def test_changes_of_length_follow_from_eases():
    """The outline has edges of 2, 1 and 1. A wire lengthens the first edge by 10%, an ease the first two by 5%."""
    chain = np.array([0, 1, 2, 3])
    broken = SimpleNamespace(vertices=chain, length_3d=4.0, length_2d=5.0, max_edge_error=0.1)
    exact = SimpleNamespace(vertices=np.array([3, 0]), length_3d=1.0, length_2d=0.8, max_edge_error=0.0)
    wire = SimpleNamespace(vertices=np.array([1, 0]), variation=0.1)
    piece = SimpleNamespace(boundaries=[broken, exact], wires=[wire])
    vertices = np.array([[0, 0, 0], [2, 0, 0], [3, 0, 0], [3, 1, 0]], dtype=float)
    asked = asked_of_outline(piece, vertices, {(0, 1): 0.05, (1, 2): 0.05})
    assert asked == pytest.approx([2 * 1.1 * 1.05 + 1 * 1.05 + 1, 0.8])
    asked = asked_of_outline(piece, vertices, {(1, 0): 0.05, (2, 1): 0.05})  # an ease of the other side of the edges
    assert asked == pytest.approx([2 * 1.1 + 1 + 1, 0.8])
