"""Meshes in parts and meshes that move, as pygltflib and trimesh read them."""

import numpy as np
import pytest

from barchan.errors import ExportError
from barchan.export import export
from tests.export import readers
from tests.export.gltf_scene import Scene
from tests.export.scenes import CELL, COLUMNS, ROWS, SLAB, asymmetric, slabs


@pytest.fixture(scope="module")
def run():
    return asymmetric()


@pytest.mark.parametrize("most", [5, 8, 255])
def test_parts_make_up_the_surface_without_gaps_and_keep_to_the_limit(run, tmp_path, most):
    export(run, tmp_path / "dunes.glb", split=most)
    scene = Scene(tmp_path / "dunes.glb")
    expected = {(column, row): slabs(10)[row, column] for row in range(ROWS) for column in range(COLUMNS)}
    squares = 0
    for part in scene.parts:
        places = scene.array(part.attributes.POSITION)
        assert len(places) <= most**2
        assert len(np.unique(places[:, 0])) <= most
        corners = scene.array(part.indices)
        assert corners.dtype == "<u2"
        squares += len(corners) // 6
        for east, up, south in places:
            assert up == pytest.approx(expected[round(east / CELL - 0.5), round(-south / CELL - 0.5)] * SLAB)
    assert squares == (ROWS - 1) * (COLUMNS - 1)
    assert readers.car_of(tmp_path / "dunes.glb")["parts"]["number"] == len(scene.parts)


def test_normals_along_the_edges_of_parts_are_those_of_the_whole(run, tmp_path):
    export(run, tmp_path / "whole.glb")
    export(run, tmp_path / "parts.glb", split=6)
    (whole,) = readers.trimesh.load(tmp_path / "whole.glb", process=False).geometry.values()
    at = {
        tuple(place): normal
        for place, normal in zip(whole.vertices.round(4), whole.vertex_normals, strict=True)
    }
    for part in readers.trimesh.load(tmp_path / "parts.glb", process=False).geometry.values():
        for place, normal in zip(part.vertices.round(4), part.vertex_normals, strict=True):
            np.testing.assert_allclose(normal, at[tuple(place)], atol=1e-6)


@pytest.mark.parametrize("most", [1, 256])
def test_parts_that_sixteen_bits_cannot_number_are_refused(run, tmp_path, most):
    with pytest.raises(ExportError, match=rf"--split: is {most}; allowed: 2 to 255"):
        export(run, tmp_path / "dunes.glb", split=most)


@pytest.mark.parametrize("options", [{}, {"split": 8}], ids=["whole", "parts"])
def test_every_frame_of_an_animation_is_the_first_one_and_its_shape(run, tmp_path, options):
    export(run, tmp_path / "dunes.glb", format="animation", frames_per_second=4.0, **options)
    scene = Scene(tmp_path / "dunes.glb")
    for part in scene.parts:
        first = scene.array(part.attributes.POSITION)
        row = np.rint(-first[:, 2] / CELL - 0.5).astype(int)
        column = np.rint(first[:, 0] / CELL - 0.5).astype(int)
        np.testing.assert_allclose(first[:, 1], slabs(0)[row, column] * SLAB, rtol=1e-6)
        for step, target in zip((5, 10), part.targets, strict=True):
            moved = first + scene.array(target["POSITION"])
            np.testing.assert_allclose(moved[:, 1], slabs(step)[row, column] * SLAB, rtol=1e-5)
            normals = scene.array(part.attributes.NORMAL) + scene.array(target["NORMAL"])
            np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1.0, atol=1e-5)


def test_an_animation_shows_one_frame_after_the_other(run, tmp_path):
    """Of three frames the first has no shape; the others are there wholly at their times, 1/4 s apart."""
    export(run, tmp_path / "dunes.glb", format="animation", frames_per_second=4.0)
    scene = Scene(tmp_path / "dunes.glb")
    (animation,) = scene.file.animations
    (sampler,) = animation.samplers
    assert scene.array(sampler.input)[:, 0].tolist() == [0.0, 0.25, 0.5]
    assert scene.array(sampler.output).reshape(3, 2).tolist() == [[0, 0], [1, 0], [0, 1]]
    assert [channel.target.path for channel in animation.channels] == ["weights"]
    assert scene.file.meshes[0].weights == [0.0, 0.0]


def test_exaggerated_heights_of_an_animation_stand_over_the_lowest_of_all_frames(run, tmp_path):
    """The lowest height, 0 slabs at step 0, stays; all frames are raised over it."""
    export(run, tmp_path / "dunes.glb", format="animation", exaggerate=3.0)
    scene = Scene(tmp_path / "dunes.glb")
    (part,) = scene.parts
    last = scene.array(part.attributes.POSITION) + scene.array(part.targets[1]["POSITION"])
    assert last[:, 1].min() == pytest.approx(3.0 * 2 * SLAB, rel=1e-5)


def test_an_animation_of_one_frame_is_refused(run, tmp_path):
    with pytest.raises(ExportError, match="an animation needs two frames"):
        export(run, tmp_path / "dunes.glb", format="animation", step=5)


def test_an_animation_too_large_for_its_readers_is_refused_before_it_is_made(run, tmp_path):
    """3 frames of 8000 × 6000 points of 24 bytes are 3.5 GB."""
    with pytest.raises(
        ExportError, match=r"8000 × 6000 cells in 3 frames make a file of 3.5 GB; allowed: up to 1 GB"
    ):
        export(run, tmp_path / "dunes.glb", format="animation", cells=(8000, 6000))
    assert not list(tmp_path.iterdir())
