"""Settings of all tests."""

import os

from hypothesis import settings

os.environ.setdefault("NUMBA_NUM_THREADS", "2")
settings.register_profile("default", deadline=None, derandomize=True)
settings.load_profile("default")
