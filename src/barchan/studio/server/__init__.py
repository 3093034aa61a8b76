"""The studio's server process: routes, the session, security, the workspace, and the handles of workers.

It imports nothing of the worker but the function that a worker process runs; simulations run elsewhere.
"""
