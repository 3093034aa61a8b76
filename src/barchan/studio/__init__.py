"""The studio: a live laboratory in the browser. A server, one worker process per simulation, a protocol.

Both processes share only the modules of this folder: ``protocol`` (messages and frames) and ``commands`` (who
carries out each). Models and measures stand in the rooms below; nothing here knows of one model.
"""
