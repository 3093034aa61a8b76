"""The studio's worker process: one simulation, its commands, frames, history and measures."""
