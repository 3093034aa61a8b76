"""What all kernels use: random numbers, vectors, atomic counters, a work queue and the threads that share it.

Nothing here knows what a bed, a slab or a grain is.
"""
