"""The studio's server process: routes, sessions, security, workspace, and the handles of worker processes."""
