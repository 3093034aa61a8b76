"""A grain touches the bed and bounces (Wang & Hu 2012)."""

import math

import numpy as np

from barchan.kernels.core.internal import internal
from barchan.kernels.grains.state import LANDED


@internal(error_model="numpy", forceinline=True)
def bounce(slot, surface, east, north, grains, rule):
    """Throw a grain back off a surface with slopes, or leave it where it is (Szabó 2019, eq. 3.9)."""
    length = math.sqrt(1.0 + east * east + north * north)
    normal_x, normal_y, normal_z = -east / length, -north / length, 1.0 / length
    u, v, w = np.float64(grains.u[slot]), np.float64(grains.v[slot]), np.float64(grains.w[slot])
    into = u * normal_x + v * normal_y + w * normal_z
    out = rule.normal * abs(into)
    u = rule.tangential * (u - into * normal_x) + out * normal_x
    v = rule.tangential * (v - into * normal_y) + out * normal_y
    w = rule.tangential * (w - into * normal_z) + out * normal_z
    grains.z[slot] = np.float32(surface)
    stops = u * u + v * v + w * w < rule.stop_speed * rule.stop_speed
    if stops or grains.bounces[slot] >= rule.most:
        grains.status[slot] = LANDED
        return
    grains.bounces[slot] += 1
    grains.u[slot] = np.float32(u)
    grains.v[slot] = np.float32(v)
    grains.w[slot] = np.float32(w)
