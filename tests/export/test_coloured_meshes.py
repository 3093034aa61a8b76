"""Meshes coloured by a field, still and moving, as pygltflib and trimesh read them."""

import numpy as np
import pytest
import trimesh

from barchan.errors import ExportError
from barchan.export import export
from tests.export.gltf_scene import Scene
from tests.export.readers import car_of
from tests.export.scenes import CELL, COLUMNS, ROWS, SLAB, STEPS, asymmetric, slabs


@pytest.fixture(scope="module")
def run():
    return asymmetric()


@pytest.fixture(scope="module")
def moving(run, tmp_path_factory):
    """Three frames coloured by depth, in parts."""
    path = tmp_path_factory.mktemp("moving") / "dunes.glb"
    export(run, path, format="animation", colour_by="depth", split=8, frames_per_second=4.0)
    return path


def frames_of(scene):
    """The numbers of each frame's meshes, by the name of its node."""
    roots = scene.file.scenes[0].nodes
    return {
        scene.file.nodes[root].name: [
            scene.file.nodes[child].mesh for child in scene.file.nodes[root].children
        ]
        for root in roots
    }


def points_of(scene, mesh):
    """Rows, columns, heights and colours of a mesh's points."""
    attributes = scene.file.meshes[mesh].primitives[0].attributes
    east, up, south = scene.array(attributes.POSITION).T
    row, column = np.rint(-south / CELL - 0.5).astype(int), np.rint(east / CELL - 0.5).astype(int)
    return row, column, up, scene.array(attributes.COLOR_0)


def size_at(scene, node, time):
    """The scale of a node at a time, by its sampler, whose values jump."""
    (animation,) = scene.file.animations
    (channel,) = [one for one in animation.channels if one.target.node == node]
    assert channel.target.path == "scale"
    sampler = animation.samplers[channel.sampler]
    assert sampler.interpolation == "STEP"
    times = scene.array(sampler.input)[:, 0]
    return scene.array(sampler.output)[np.searchsorted(times, time, side="right") - 1]


def test_each_frame_has_its_own_surface_without_gaps(moving):
    scene = Scene(moving)
    frames = frames_of(scene)
    assert list(frames) == [f"step {step}" for step in STEPS]
    for step, meshes in zip(STEPS, frames.values(), strict=True):
        seen = np.zeros((ROWS, COLUMNS), bool)
        for mesh in meshes:
            row, column, up, _ = points_of(scene, mesh)
            np.testing.assert_allclose(up, slabs(step)[row, column] * SLAB, rtol=1e-5)
            seen[row, column] = True
        assert seen.all()


def test_one_frame_is_shown_at_a_time_and_the_last_as_long_as_the_others(moving):
    """At 4 frames a second the three frames last to 0.25, 0.5 and 0.75 s."""
    scene = Scene(moving)
    nodes = scene.file.scenes[0].nodes
    for time, shown in ((0.0, 0), (0.2, 0), (0.3, 1), (0.6, 2), (0.75, 2)):
        sizes = [size_at(scene, node, time).tolist() for node in nodes]
        assert sizes == [[float(k == shown)] * 3 for k in range(3)]
    (animation,) = scene.file.animations
    assert max(scene.array(one.input).max() for one in animation.samplers) == 0.75


def test_programs_without_animation_show_the_first_frame(moving):
    nodes = Scene(moving).file.nodes
    assert [node.scale for node in nodes if node.children] == [[1, 1, 1], [0, 0, 0], [0, 0, 0]]


def test_a_depth_has_the_same_colour_in_all_frames_and_moves_with_the_sand(moving):
    scene = Scene(moving)
    colours: dict[int, set] = {}
    for step, meshes in zip(STEPS, frames_of(scene).values(), strict=True):
        for mesh in meshes:
            row, column, _, colour = points_of(scene, mesh)
            for depth, one in zip(slabs(step)[row, column], colour, strict=True):
                colours.setdefault(int(depth), set()).add(tuple(one))
    assert all(len(found) == 1 for found in colours.values())
    low, high = colours[min(colours)].pop(), colours[max(colours)].pop()
    assert max(abs(int(a) - int(b)) for a, b in zip(low, high, strict=True)) > 50
    assert low[3] == high[3] == 255


def test_the_file_beside_names_the_field_its_unit_and_the_ends_of_its_scale(moving):
    told = car_of(moving)["colours"]
    assert (told["of"], told["unit"]) == ("depth", "m")
    assert 0.0 <= told["lowest"] < told["highest"] <= slabs(10).max() * SLAB


def test_trimesh_reads_the_meshes_of_all_frames(moving):
    scene = trimesh.load(moving, process=False)
    points = sum(len(mesh.vertices) for mesh in scene.geometry.values())
    assert points >= 3 * ROWS * COLUMNS


def test_a_still_mesh_is_coloured_by_a_field(run, tmp_path):
    """Of 'shadow' there are two colours, of cells in it and of others."""
    export(run, tmp_path / "dunes.glb", colour_by="shadow")
    *_, colours = points_of(Scene(tmp_path / "dunes.glb"), 0)
    assert len(np.unique(colours, axis=0)) == 2


def test_several_files_have_one_scale(run, tmp_path):
    export(run, tmp_path / "dunes.ply", step="all", colour_by="depth")
    colours = {}
    for step, path in zip(STEPS, sorted(tmp_path.glob("dunes-*.ply")), strict=True):
        mesh = trimesh.load(path, process=False)
        colours[step] = np.asarray(mesh.visual.vertex_colors).reshape(ROWS, COLUMNS, 4)
    same = (slabs(0) == 7), (slabs(10) == 7)
    assert same[0].any()
    assert same[1].any()
    assert (colours[0][same[0]] == colours[10][same[1]][0]).all()


@pytest.mark.parametrize("format", ["glb", "animation"])
def test_a_field_that_does_not_exist_is_refused_with_those_that_do(run, tmp_path, format):  # noqa: A002
    with pytest.raises(ExportError, match=r"--colour-by: no field 'slop'; there are natural, .*slope"):
        export(run, tmp_path / "dunes.glb", format=format, colour_by="slop")
    assert not list(tmp_path.iterdir())
