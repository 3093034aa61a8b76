"""Steps of a model of grains: iterations of all grains in the air, or complete trajectories one by one."""

from typing import TYPE_CHECKING

import numpy as np

from barchan.grains.bed import GrainGround
from barchan.grains.iterations import batches, shared_scene
from barchan.grains.rules import entrainment_of, rules_of
from barchan.grains.shelter import Shelter
from barchan.grains.splash import Splash
from barchan.kernels.grains.state import Scene
from barchan.streams import Stream, derive
from barchan.wind.segment import Segment

if TYPE_CHECKING:
    from barchan.grains.model import GrainModel

_TOGETHER = 256
"""Trajectories of one call: a signal is handled between two calls."""


def iterate(model: "GrainModel", wind: Segment, stream: Stream, ground: GrainGround) -> None:
    """Let all grains fly for the iterations of a step, in a wind recomputed now and then."""
    rules, feedback = model.parameters, model.feedback
    iterations = round(wind.share * rules.iterations_per_step)
    every = rules.iterations_per_step if feedback is None else feedback.closure.update_every
    for first in range(0, iterations, every):
        air = model.blow(ground, wind)
        model.pool.use_few(_spare_slots(model))
        count = min(every, iterations - first)
        scene = model.scene(ground, air, rules_of(model.setting(wind)))
        _fly(model, first, count, stream, scene, ground)
        if feedback is not None:
            feedback.update(ground.momentum_loss(), count * rules.time_step, ground.direction)
    ground.relax(derive(stream.key, model.iteration))


def _spare_slots(model: "GrainModel") -> int:
    """Free slots that fly too, for grains that start within a step.

    Where splash starts most grains: some to start with, and a sixteenth of those in use; else all.
    """
    return model.pool.size if model.parameters.part(Splash) is None else 64 + model.pool.flying // 16


def _fly(
    model: "GrainModel", first: int, count: int, stream: Stream, scene: Scene, ground: GrainGround
) -> None:
    """Let grains fly for ``count`` iterations of a step from ``first`` on, in a wind that blows as it is."""
    collapse, shelter = model.parameters.collapse_every, model.parameters.part(Shelter)
    intervals = [collapse] if shelter is None else [collapse, shelter.update_every]
    with shared_scene(scene, stream.key, model.pool.in_use, model.iteration) as fly_until:
        for number, some in batches(first, first + count, model.pool.in_use, *intervals):
            if shelter is not None and number % shelter.update_every == 0:
                ground.raise_shelter()
            if number and number % collapse == 0:
                ground.relax(derive(stream.key, model.iteration))
            model.iteration += some
            fly_until(model.iteration)


def follow_trajectories(model: "GrainModel", wind: Segment, stream: Stream, ground: GrainGround) -> None:
    """Let as many grains as the field has cells fly from lift-off to rest, one after the other."""
    from barchan.kernels.grains.trajectories import trajectories

    key, cells, setting = derive(stream.key, model.iteration), model.lattice.cells, model.setting(wind)
    ground.raise_shelter()
    air = model.blow(ground, wind)
    ground.reseed(derive(key, cells))
    scene = model.scene(ground, air, rules_of(setting, lifts=False))
    lifting = entrainment_of(setting)
    for first in range(0, cells, _TOGETHER):
        count = min(_TOGETHER, cells - first)
        trajectories(first, count, np.uint64(key), scene, lifting, ground.slopes)
    model.iteration += 1
