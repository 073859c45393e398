# SPDX-License-Identifier: GPL-3.0-or-later
"""Files of all formats have every outline in actual size, and a failure or a stop leaves the old file."""

import io
import re
import sys
import xml.etree.ElementTree as ElementTree
from dataclasses import replace
from inspect import signature

import dxfgrabber
import ezdxf
import numpy as np
import pypdfium2
import pytest
import shapely
import wirewarp
from drawing import LABEL, SVG, points_of
from patterns import SCALE, cut_points, extent, flattened, rectangle, sample, turn
from PIL import Image
from wirewarp.pattern import FORMATS, STAGES, Pattern, Text


def same_up_to_moves(found: list[np.ndarray], wanted: list[np.ndarray], within: float) -> None:
    """Check that the outlines have the wanted shapes and sizes, wherever they are in the file."""
    assert len(found) == len(wanted)
    shapes = sorted((normalized(points) for points in found), key=lambda points: (len(points), points.sum()))
    others = sorted((normalized(points) for points in wanted), key=lambda points: (len(points), points.sum()))
    for one, other in zip(shapes, others, strict=True):
        assert one == pytest.approx(other, abs=within)


def normalized(points: np.ndarray) -> np.ndarray:
    points = points[:-1] if np.array_equal(points[0], points[-1]) else points
    return points - points.min(axis=0)


def test_svg_has_every_outline_in_millimeters(tmp_path):
    pattern = sample("Carnival mask", allowance=2.0)
    pattern.write(tmp_path / "mask.svg")
    root = ElementTree.parse(tmp_path / "mask.svg").getroot()
    assert root.get("width").endswith("mm")
    paths = [path for path in root.iter(f"{SVG}path") if path.get("data-role") in ("cut", "inner_cut")]
    assert all(path.get("d").endswith("Z") for path in paths)
    same_up_to_moves([points_of(path) * (1, -1) for path in paths], cut_points(pattern), 2e-4)


def test_presets_for_cutters(tmp_path):
    pattern = Pattern.from_result(rectangle(234, 76.2), allowance=10.0)
    pattern.write(tmp_path / "laser.svg", preset="laser")
    text = (tmp_path / "laser.svg").read_text()
    assert "dasharray" not in text and "<text" not in text and set(re.findall(r'width="([\d.]+)"', text)) == {"0.1"}
    pattern.write(tmp_path / "cricut.svg", preset="cricut")
    root = ElementTree.parse(tmp_path / "cricut.svg").getroot()
    (cut,) = [path for path in root.iter(f"{SVG}path") if path.get("data-role") == "cut"]
    assert sorted(np.ptp(points_of(cut), axis=0)) == pytest.approx([96.2 / 25.4 * 96, 254 / 25.4 * 96], abs=1e-3)
    with pytest.raises(wirewarp.FlattenError, match="preset is 'plasma'"):
        pattern.write(tmp_path / "x.svg", preset="plasma")


@pytest.mark.parametrize("ending", [suffix[1:] for suffix in FORMATS])
def test_names_in_any_script(tmp_path, no_fonts, ending):
    """Some of the texts contain half of a surrogate pair. Files have a replacement for it, or leave it out."""
    names = ["Ärmel", "袖", "كم", "Рукав", 'a"b\\c(d', "\x00\ud800\ufffe<&>"]
    texts = {"title": "型紙 №1\ud83d", "material": "\ude00", "date": "\ud83d"}
    path = tmp_path / f"ball.{ending}"
    written = Pattern.from_result(flattened("Ball of six gores"), piece_names=names, **texts).write(path)
    assert path.stat().st_size > 1000
    if ending in ("pdf", "dxf"):
        assert any("袖" in warning for warning in written.warnings)
    if ending == "pdf":
        assert pypdfium2.PdfDocument(path).get_metadata_value("Title") == "型紙 №1?"
    if ending == "svg":
        root = ElementTree.parse(path).getroot()
        labels = [group.get(LABEL) for group in root]
        assert labels[1:7] == [*names[:5], 3 * "\ufffd" + "<&>"]


def test_without_texts_there_are_no_leader_lines(tmp_path):
    pattern = Pattern.from_result(rectangle(20, 2), allowance=0, piece_names=["Cuff"])
    plain = pattern.with_only(["sew", "grain"])
    assert pattern.pieces[0].of_role("card leader") and not plain.pieces[0].of_role("card leader")
    for name, options in (("x.plt", {}), ("x.dxf", {"dialect": "plain"}), ("x.svg", {"preset": "laser"})):
        written = []
        for each in (pattern, plain):
            each.write(tmp_path / name, **options)
            written.append((tmp_path / name).read_text())
        assert written[0] == written[1]


@pytest.mark.parametrize("preset", ["print", "laser", "cricut"])
def test_svg_is_drawn_in_actual_size_by_another_renderer(tmp_path, preset):
    pattern = Pattern.from_result(rectangle(150, 700), allowance=10.0, notch_spacing=0).with_only([])
    pattern.write(tmp_path / "strip.svg", preset=preset)
    pixels = rendered_svg(tmp_path / "strip.svg")
    assert pixels.shape == pytest.approx(pattern.svg_size[::-1] * SCALE, abs=1)
    pixels = pixels[round(115 * SCALE) :]  # above the test square
    line = {"print": 0.5, "laser": 0.1, "cricut": 0.3}[preset]
    assert extent(pixels) == pytest.approx((170 + line, 720 + line), abs=1.5 / SCALE)


def rendered_svg(path) -> np.ndarray:
    """Return a mask (h,w) of the pixels with a line, bottom row first."""
    resvg = pytest.importorskip("resvg_py", exc_type=ImportError)
    drawn = resvg.svg_to_bytes(svg_path=str(path), dpi=96, zoom=SCALE * 25.4 / 96, background="#ffffff")
    image = Image.open(io.BytesIO(drawn))
    return np.array(image.convert("L"))[::-1] < 200


def vertices_of(polyline: ezdxf.entities.Polyline) -> np.ndarray:
    return np.array([vertex.dxf.location.vec2 for vertex in polyline.vertices])


@pytest.mark.parametrize("dialect", ["astm", "aama"])
def test_ezdxf_and_dxfgrabber_read_apparel_dxf(tmp_path, dialect):
    pattern = sample("Fitted top", hem=30.0)
    pattern.write(tmp_path / "top.dxf", dialect=dialect)
    document = ezdxf.readfile(tmp_path / "top.dxf")
    assert document.audit().errors == [] and document.dxfversion == "AC1009"
    blocks = [block for block in document.blocks if not block.name.startswith(("*", "$", "_"))]
    inserted = [entity.dxf.name for entity in document.modelspace().query("INSERT")]
    assert sorted(block.name for block in blocks) == sorted(inserted) and len(inserted) == 4
    found, heights = [], set()
    for block in blocks:
        (outline,) = [line for line in block.query("POLYLINE") if line.dxf.layer == "1"]
        points = vertices_of(outline)
        assert outline.is_closed and np.array_equal(points[0], points[-1])
        found.append(points)
        assert len([line for line in block.query("LINE") if line.dxf.layer == "7"]) == 1
        heights |= {round(text.dxf.height, 2) for text in block.query("TEXT") if text.dxf.layer == "15"}
        ring = shapely.LinearRing(points)
        for notch in (point for point in block.query("POINT") if point.dxf.layer == "4"):
            at = np.array(notch.dxf.location.vec2)
            assert ring.distance(shapely.Point(at)) < 0.02 and 2 < notch.dxf.location[2] <= 5
            direction = np.array([np.cos(np.radians(notch.dxf.angle)), np.sin(np.radians(notch.dxf.angle))])
            assert shapely.Polygon(points).contains(shapely.Point(at + direction))
    same_up_to_moves(found, cut_points(pattern), 0.011)
    assert heights == {round(text.height, 2) for piece in pattern.pieces for text in piece.texts}
    grabbed = dxfgrabber.readfile(str(tmp_path / "top.dxf"))
    lines = [each for block in grabbed.blocks for each in block if each.dxftype == "POLYLINE" and each.layer == "1"]
    again = [np.array([point[:2] for point in line.points]) for line in lines]
    same_up_to_moves(again, cut_points(pattern), 0.011)


@pytest.mark.parametrize("dialect", ["astm", "aama"])
@pytest.mark.parametrize("angle", [0.0, 90.0, 30.0])
def test_lines_of_turned_texts_in_apparel_dxf_are_centered_and_apart(tmp_path, dialect, angle):
    pattern = Pattern.from_result(rectangle(200, 200))
    card = Text(("Left sleeve", "Cut 1"), np.array([60.0, 140.0]), 5.0, angle)
    replace(pattern, pieces=[replace(pattern.pieces[0], texts=[card])]).write(tmp_path / "a.dxf", dialect=dialect)
    (block,) = [block for block in ezdxf.readfile(tmp_path / "a.dxf").blocks if block.name == "PIECE_1"]
    texts = [text for text in block.query("TEXT") if text.dxf.layer == "15"]
    assert [(text.dxf.text, text.dxf.rotation) for text in texts] == [(line, angle) for line in card.lines]
    # In the directions of the text, the base lines are above each other. Letters are about 0.6 times as wide as high.
    starts = np.array([text.dxf.insert.vec2 for text in texts]) - card.center
    x, y = (starts @ turn(-angle)).T
    assert x == pytest.approx([-11 * 0.3 * 5, -5 * 0.3 * 5], rel=0.1)
    assert y[0] - y[1] == pytest.approx(1.35 * 5, abs=0.02) and y.mean() == pytest.approx(-0.36 * 5, abs=0.02)


def test_inches_in_apparel_dxf(tmp_path):
    pattern = Pattern.from_result(rectangle(254, 254), allowance=25.4, units="imperial")
    pattern.write(tmp_path / "square.dxf", control_square=True)
    document = ezdxf.readfile(tmp_path / "square.dxf")
    sides = {}
    for block in document.blocks:
        for line in block.query("POLYLINE"):
            if line.dxf.layer == "1":
                sides[block.name] = np.ptp(vertices_of(line)[:, 0])
    assert sides == pytest.approx({"PIECE_1": 12.0, "CONTROL_100MM": 100 / 25.4}, abs=1e-4)
    texts = [entity.dxf.text for entity in document.modelspace().query("TEXT")]
    assert "Units: ENGLISH" in texts


@pytest.mark.parametrize("dialect", ["astm", "aama"])
def test_apparel_dxf_numbers_pieces_whose_names_have_no_ascii_letters(tmp_path, dialect):
    names = ["前身頃", "袖 L", "Ärmel"]
    pattern = Pattern.from_result(flattened("Ball of six gores"), title="型紙", piece_names=[*names, "4", "5", "6"])
    pattern.write(tmp_path / "ball.dxf", dialect=dialect)
    document = ezdxf.readfile(tmp_path / "ball.dxf")
    texts = [text.dxf.text for block in document.blocks for text in block.query("TEXT")]
    found = [text.partition(": ")[2] for text in texts if text.lower().startswith("piece name")]
    assert found == ["PIECE_1", "? L", "Armel", "4", "5", "6"]
    styles = [text.dxf.text for text in document.modelspace().query("TEXT")]
    assert any(style.lower() == "style name: pattern" for style in styles)


def test_plain_dxf_has_named_layers_and_true_extents(tmp_path):
    pattern = sample("Carnival mask", allowance=2.0)
    pattern.write(tmp_path / "mask.dxf", dialect="plain")
    document = ezdxf.readfile(tmp_path / "mask.dxf")
    assert document.audit().errors == []
    assert {"CUT", "SEW", "NOTCHES", "SCALE"} <= {layer.dxf.name for layer in document.layers}
    lines = document.modelspace().query("POLYLINE")
    found = [vertices_of(line) for line in lines if line.dxf.layer == "CUT"]
    same_up_to_moves(found, cut_points(pattern), 1e-4)
    low, high = document.header["$EXTMIN"], document.header["$EXTMAX"]
    assert low[0] == pytest.approx(-110) and high[0] == pytest.approx(max(pattern.size[0], 100), abs=1e-3)


def test_plotter_commands_draw_every_outline_last(tmp_path):
    pattern = sample("Carnival mask", allowance=2.0)
    pattern.write(tmp_path / "mask.plt")
    commands = [command.strip() for command in (tmp_path / "mask.plt").read_text().split(";")]
    assert commands[0] == "IN" and commands[-2:] == ["SP0", ""]
    pens = [command for command in commands if re.fullmatch(r"SP[1-9]", command)]
    assert pens[-1] == "SP1"
    lines, pen = [], ""
    for command in commands:
        numbers = [int(number) for number in re.findall(r"-?\d+", command)]
        if command.startswith("SP"):
            pen = command
        elif command.startswith("PU") and numbers:
            lines.append((pen, numbers))
        elif command.startswith("PD"):
            assert len(numbers) <= 200
            lines[-1][1].extend(numbers)
    found = [np.array(numbers).reshape(-1, 2) / 40 for pen, numbers in lines if pen == "SP1"]
    same_up_to_moves(found, cut_points(pattern), 0.026)


def test_a_failure_leaves_the_old_file_as_it_was(tmp_path, monkeypatch):
    path = tmp_path / "top.svg"
    path.write_text("old")
    pattern = sample("Hat")
    with pytest.raises(wirewarp.FlattenError, match="no option 'paper'"):
        pattern.write(path, paper="a4")
    monkeypatch.setattr("wirewarp.pattern.formats.svg._document", lambda pattern, preset: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        pattern.write(path)
    assert path.read_text() == "old" and list(tmp_path.iterdir()) == [path]


@pytest.mark.parametrize("ending", [suffix[1:] for suffix in FORMATS])
def test_a_wrong_file_replaces_nothing(tmp_path, monkeypatch, ending):
    pattern = sample("Hat")
    written = pattern.write(tmp_path / f"hat.{ending}")
    assert written.off < 0.02 and "3 pieces on" in str(written) and "read again: 0.0" in str(written)
    old = (tmp_path / f"hat.{ending}").read_bytes()
    strokes_of = wirewarp.pattern.sheet.drawing.strokes_of

    def moved(piece):
        for stroke in strokes_of(piece):
            yield replace(stroke, points=stroke.points * 1.001)

    for each in FORMATS.values():
        monkeypatch.setattr(sys.modules[each.write.__module__], "strokes_of", moved)
    with pytest.raises(RuntimeError, match="is off by"):
        pattern.write(tmp_path / f"hat.{ending}", **({"dialect": "plain"} if ending == "dxf" else {}))
    assert (tmp_path / f"hat.{ending}").read_bytes() == old and len(list(tmp_path.iterdir())) == 1


@pytest.mark.parametrize("ending", [suffix[1:] for suffix in FORMATS])
def test_a_stop_leaves_the_old_file(tmp_path, monkeypatch, ending):
    monkeypatch.setattr("wirewarp.pattern.progress.OFTEN", 0.0)
    path, pattern = tmp_path / f"strip.{ending}", Pattern.from_result(rectangle(150, 300))
    asked = []
    pattern.write(path, progress=lambda *reported: asked.append(reported))
    assert asked[-1][0] == "reading again" and all(0 <= fraction < 1 for _, fraction in asked)
    begins = [STAGES[stage] for stage, _ in asked]
    assert begins == sorted(begins)
    old = path.read_bytes()
    moments = {stage: [number for number, (own, _) in enumerate(asked) if own == stage] for stage, _ in asked}
    for count in sorted({number for own in moments.values() for number in (own[0], own[-1])}):
        left = iter([True] * count + [False])
        with pytest.raises(wirewarp.FlattenError, match="canceled before") as stopped:
            pattern.write(path, progress=lambda *_, left=left: next(left))
        assert stopped.value.code == "cancelled"
        assert path.read_bytes() == old and list(tmp_path.iterdir()) == [path]
        steps = pattern.writing(path)
        assert [next(steps) for _ in range(count + 1)] == asked[: count + 1]
        steps.close()
        assert path.read_bytes() == old and list(tmp_path.iterdir()) == [path]


def test_exceptions_of_progress_keep_the_old_file(tmp_path, monkeypatch):
    monkeypatch.setattr("wirewarp.pattern.progress.OFTEN", 0.0)
    path = tmp_path / "hat.pdf"
    path.write_bytes(b"old")

    def progress(*_):
        if len(list(tmp_path.iterdir())) > 1:  # while the new file is written
            raise ZeroDivisionError

    # `raised` keeps the frames of the run alive, so garbage collection cannot remove the new file.
    with pytest.raises(ZeroDivisionError) as raised:
        sample("Hat").write(path, progress=progress)
    assert path.read_bytes() == b"old" and list(tmp_path.iterdir()) == [path], raised


def test_a_pattern_can_be_stopped_while_it_is_made(monkeypatch):
    monkeypatch.setattr("wirewarp.pattern.progress.OFTEN", 0.0)
    asked = []
    Pattern.from_result(flattened("Hat"), progress=lambda stage, _: asked.append(stage))
    assert list(dict.fromkeys(asked)) == list(STAGES)[:3] == ["allowance", "marks and lines", "texts"]
    for stage in dict.fromkeys(asked):
        with pytest.raises(wirewarp.FlattenError, match="canceled before"):
            Pattern.from_result(flattened("Hat"), progress=lambda now, _, stage=stage: now != stage)


def test_paths_that_cannot_be_written_are_refused(tmp_path):
    pattern = sample("Hat")
    with pytest.raises(wirewarp.FlattenError, match="must end in one of .pdf, .svg, .dxf, .plt"):
        pattern.write(tmp_path / "hat.blend")
    with pytest.raises(FileNotFoundError, match="there is no folder"):
        pattern.write(tmp_path / "none" / "hat.svg")
    (tmp_path / "folder.svg").mkdir()
    with pytest.raises(IsADirectoryError, match="is not a file"):
        pattern.write(tmp_path / "folder.svg")


def test_omitted_kinds_of_lines_are_in_no_file(tmp_path):
    pattern = sample("Hat")
    plain = pattern.with_only(["notches"])
    plain.write(tmp_path / "plain.svg")
    roles = {element.get("data-role") for element in ElementTree.parse(tmp_path / "plain.svg").iter()}
    assert {"cut", "notch"} <= roles <= {None, "cut", "inner_cut", "notch", "clip", "drill", "scale"}
    everything = pattern.with_only(["sew", "wires", "grain", "notches", "texts", "line names"])
    assert [len(piece.lines) for piece in everything.pieces] == [len(piece.lines) for piece in pattern.pieces]
    with pytest.raises(wirewarp.FlattenError, match="kinds has 'seams'"):
        pattern.with_only(["seams"])


@pytest.mark.parametrize("suffix", FORMATS)
def test_formats_list_every_option_for_dialogs(tmp_path, suffix):
    chosen = FORMATS[suffix]
    others = ["path", "pattern", *(["paper", "keep_places"] if chosen.has_pages else [])]
    assert sorted(signature(chosen.write).parameters) == sorted([*others, *(option.name for option in chosen.options)])
    for option in chosen.options:
        for value in [choice.value for choice in option.choices] or [False, True]:
            Pattern.from_result(rectangle(60, 40)).write(tmp_path / f"a{suffix}", **{option.name: value})
        assert option.unless is None or option.unless[0] in {other.name for other in chosen.options}
