"""Transforms of fields: the same bits for any number of threads, and numpy's numbers."""

import numpy as np
import pytest

from barchan.aeolian import transforms
from barchan.aeolian.transforms import sum_of_waves, waves_of
from barchan.kernels.core.threads import asked_for


@pytest.mark.parametrize("shape", [(512, 512), (300, 1001), (37, 50)])
def test_bits_do_not_depend_on_the_number_of_threads(shape, monkeypatch):
    monkeypatch.setattr(transforms, "LARGE", 1)
    monkeypatch.delenv("BARCHAN_THREADS", raising=False)
    field = np.random.default_rng(1).normal(size=shape)
    found = []
    for threads in (1, 2, 3, 8):
        with asked_for(threads):
            waves = waves_of(field)
            found.append((waves.tobytes(), sum_of_waves(waves, shape).tobytes()))
    assert len(set(found)) == 1


def test_they_are_those_of_numpy():
    field = np.random.default_rng(2).normal(size=(40, 63))
    waves = waves_of(field)
    np.testing.assert_allclose(waves, np.fft.rfft2(field), atol=1e-10)
    np.testing.assert_allclose(sum_of_waves(waves, field.shape), field, atol=1e-12)
