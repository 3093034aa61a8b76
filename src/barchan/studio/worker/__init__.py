"""The studio's worker process: one simulation, its commands, frames, history and measures.

It knows the pipe that it was given, never the server or the browser behind it.
"""
