"""The studio: a live laboratory in the browser. A server, one worker process per simulation, a protocol.

What a model does, and what is measured, stands in the rooms below; nothing here knows of one model.
"""
