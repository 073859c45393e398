# SPDX-License-Identifier: GPL-3.0-or-later
"""python -m wirewarp propose prints the cuts that propose_darts(), propose_seams() and similar functions return."""

import json

import commands
import numpy as np
import pytest
from surfaces import chain_edges, column_chain, half_cylinder, spherical_patch
from wirewarp import Options, flatten, plan_cuts, propose_darts, propose_seams, simplify_seams
from wirewarp.command.model import read_model
from wirewarp.pattern import piece_width

trimesh = pytest.importorskip("trimesh")


def propose(*words, code=0):
    return commands.propose(*words, code=code)[0]


@pytest.fixture
def dome(tmp_path):
    vertices, faces = spherical_patch(8, 8)
    trimesh.Trimesh(100 * vertices, faces, process=False).export(tmp_path / "dome.obj")  # in mm
    return tmp_path / "dome.obj"


def edges(line):
    return np.column_stack([line[:-1], line[1:]])


def write_seams(folder, lines):
    """Write lines of vertices, and return the option that makes them seams."""
    (folder / "seams.json").write_text(json.dumps([[int(vertex) for vertex in line] for line in lines]))
    return "--seams", folder / "seams.json"


def check_energy(model, proposal, folder, *words):
    """Check that flattening with the proposed lines as seams gives the proposed energy."""
    seams = write_seams(folder, proposal["lines"])
    ((listed,), _) = commands.flatten(model, "--out", folder / "out", *words, *seams, "--format", "svg")
    assert listed["codes"] == []
    assert listed["figures"]["energy"] == pytest.approx(proposal["energy"], rel=1e-6)


@pytest.mark.parametrize(("kind", "function"), [("dart", propose_darts), ("seam", propose_seams)])
def test_proposals_are_the_same_as_through_python(dome, kind, function):
    (line,) = propose(dome, "--cut", kind, "--count", 2, "--unit", "mm")
    model = read_model(dome)
    expected = function(model.vertices, model.faces, count=2)
    assert (line["model"], line["verdict"], line["cut"]) == (str(dome), "proposed", kind)
    assert len(line["proposals"]) == len(expected)
    for listed, proposal in zip(line["proposals"], expected, strict=True):
        assert np.array_equal(edges(listed["lines"][0]), proposal.edges)
        assert listed["length_m"] == pytest.approx(proposal.length / 1000)
        assert (listed["piece"], listed["strain"]) == (1, pytest.approx(proposal.strain, rel=1e-6))
        assert listed["twin"] == (None if proposal.twin is None else proposal.twin + 1)


def test_a_printed_line_can_be_a_seam_of_flatten(dome, tmp_path):
    (line,) = propose(dome, "--unit", "mm", "--count", 1)
    check_energy(dome, line["proposals"][0], tmp_path, "--unit", "mm")


def test_cut_sets_of_a_closed_model_can_be_seams_of_flatten(tmp_path):
    trimesh.creation.icosphere(subdivisions=1).export(tmp_path / "ball.obj")
    (line,) = propose(tmp_path / "ball.obj", "--cut", "seam", "--strain", "25%")
    model, first = read_model(tmp_path / "ball.obj"), line["proposals"][0]
    expected = propose_seams(model.vertices, model.faces, strain=0.25)[0]
    assert np.concatenate([edges(each) for each in first["lines"]]).tolist() == expected.edges.tolist()
    assert first["strain"] <= 0.25 and first["strain_before"] is None and first["energy_before"] is None
    width = min(map(piece_width, flatten(model.vertices, model.faces, seams=expected.edges).pieces))
    assert first["narrowest_width_m"] / first["length_m"] == pytest.approx(width / expected.length, rel=1e-6)
    check_energy(tmp_path / "ball.obj", first, tmp_path)


def test_cuts_with_together_are_those_of_the_plan(dome):
    (line,) = propose(dome, "--together", 2, "--strain", "1%", "--unit", "mm")
    model = read_model(dome)
    expected = plan_cuts(model.vertices, model.faces, most=2, strain=0.01)
    assert line["together"] and "twin" not in line["proposals"][0]
    assert [edges(cut["lines"][0]).tolist() for cut in line["proposals"]] == [cut.edges.tolist() for cut in expected]


def test_seams_to_keep_are_the_same_as_through_python(dome, tmp_path):
    columns = [column_chain(8, 8, column) for column in (2, 4, 6)]
    words = (*write_seams(tmp_path, columns), "--cut", "fewer", "--strain", "20%", "--unit", "mm")
    (line,) = propose(dome, *words)
    model = read_model(dome)
    seams = np.concatenate([chain_edges(column) for column in columns])
    expected = simplify_seams(model.vertices, model.faces, seams=seams, strain=0.2)
    (listed,) = line["proposals"]
    assert (line["verdict"], line["cut"]) == ("proposed", "fewer")
    assert [edge for each in listed["lines"] for edge in edges(each).tolist()] == expected.edges.tolist()
    assert (listed["pieces_before"], listed["pieces"]) == (4, expected.num_pieces)
    width = min(map(piece_width, flatten(model.vertices, model.faces, seams=expected.edges).pieces))
    assert listed["narrowest_width_m"] == pytest.approx(width / 1000, rel=1e-6)
    assert listed["length_before_m"] == pytest.approx(expected.length_before / 1000)
    assert listed["strain"] == pytest.approx(expected.strain, rel=1e-6)


@pytest.mark.parametrize(
    ("columns", "strain", "problem"),
    [
        ([], "5%", "The model has no seams that could be left out."),
        ([4], "0%", "Every seam is needed for this strain."),
    ],
)
def test_the_reason_for_removing_no_seam_is_reported(dome, tmp_path, columns, strain, problem):
    seams = write_seams(tmp_path, [column_chain(8, 8, column) for column in columns])
    (line,) = propose(dome, *seams, "--cut", "fewer", "--strain", strain, code=1)
    assert (line["verdict"], line["codes"], line["problems"]) == ("nothing to propose", ["no_proposal"], [problem])


def test_the_least_width_is_in_the_unit_of_the_option(tmp_path):
    ball = trimesh.creation.icosphere(subdivisions=1)
    vertices = 100 * ball.vertices * (1 + 0.3 * ball.vertices[:, :1])  # mm
    trimesh.Trimesh(vertices, ball.faces, process=False).export(tmp_path / "ball.obj")
    words = (tmp_path / "ball.obj", "--cut", "seam", "--strain", "10%", "--unit", "mm")
    (line,) = propose(*words, "--narrowest", "4cm")
    (any_width,) = propose(*words)
    model = read_model(tmp_path / "ball.obj")
    expected = propose_seams(model.vertices, model.faces, strain=0.1, narrowest=40.0)
    assert [each["length_m"] for each in line["proposals"]] == pytest.approx([each.length / 1000 for each in expected])
    assert line["proposals"] != any_width["proposals"]


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        ("--cut dart --narrowest 0mm", "--narrowest is for sets of seams"),
        ("--cut seam --together 2 --narrowest 12mm", "--narrowest is for sets of seams"),
        ("--cut fewer", "--cut fewer"),
        ("--cut fewer --seams uv --together 2", "--cut fewer"),
        ("--cut fewer --seams uv --no-seam a.json", "--cut fewer"),
        ("--cut fewer --seams uv --longest 0mm", "--cut fewer"),
        ("--cut fewer --seams uv --narrowest 0mm", "--cut fewer"),
        ("--together 2 --piece 1", "without --piece and --count"),
    ],
)
def test_options_that_contradict_each_other_are_refused(dome, words, sentence):
    lines, said = commands.propose(dome, *words.split(), code=2)
    assert lines == [] and sentence in said


def test_cuts_keep_the_limits_on_length_and_place(dome, tmp_path):
    (line,) = propose(dome, "--count", 1, "--unit", "mm")
    forbidden = line["proposals"][0]["lines"][0]
    (tmp_path / "front.json").write_text(json.dumps([forbidden]))
    (line,) = propose(dome, "--no-seam", tmp_path / "front.json", "--longest", "6cm", "--unit", "mm")
    taken = {tuple(sorted(pair)) for pair in edges(forbidden).tolist()}
    for listed in line["proposals"]:
        assert listed["length_m"] <= 0.06
        assert not taken & {tuple(sorted(pair)) for pair in edges(listed["lines"][0]).tolist()}


def test_errors_are_in_the_line_of_their_model(dome, tmp_path):
    trimesh.Trimesh(*half_cylinder(), process=False).export(tmp_path / "half.ply")
    trimesh.creation.box().export(tmp_path / "box.stl")
    lines = propose(tmp_path / "half.ply", dome, tmp_path / "box.stl", tmp_path / "top.blend", "--jobs", 2, code=2)
    verdicts = [line["verdict"] for line in lines]
    assert verdicts == ["nothing to propose", "proposed", "refused", "refused"]
    assert [line["codes"] for line in lines] == [["no_proposal"], [], ["closed_chart"], ["input"]]
    assert "is flat enough" in lines[0]["problems"][0] and "add-on" in lines[3]["problems"][0]
    propose(tmp_path / "half.ply", code=1)


def test_the_energy_is_that_of_the_cloth(dome):
    (line,) = propose(dome, "--cloth", "woven", "--count", 1, "--unit", "mm")
    model, first = read_model(dome), line["proposals"][0]
    cut = flatten(model.vertices, model.faces, seams=edges(first["lines"][0]), options=Options(cloth="woven"))
    assert first["energy"] == pytest.approx(cut.pieces[0].metrics.cloth_energy, rel=1e-6)


@pytest.mark.parametrize("text", ["[" * 100_000, "[[0, 18446744073709551616]]"])
def test_an_invalid_file_of_lines_is_refused_and_the_next_model_read(dome, tmp_path, text):
    (tmp_path / "lines.json").write_text(text)
    first, second = propose(dome, dome, "--no-seam", tmp_path / "lines.json", code=2)
    assert first["verdict"] == second["verdict"] == "refused" and "lines.json" in first["problems"][0]
