"""How many steps to do in one go, so that each go takes about the same time."""


class StepPacer:
    """The number of steps that take a given time, learnt from the steps done so far."""

    def __init__(self, seconds: float) -> None:
        """Aim at goes of this duration; the first go is one step."""
        self.seconds = seconds
        self.steps = 1
        """Steps to do in the next go."""

    def record(self, steps: int, seconds: float) -> None:
        """Learn from steps that took a time; a go has at most twice the steps of the one before."""
        if steps > 0:
            fitting = int(steps * self.seconds / max(seconds, 1e-9))
            self.steps = max(1, min(2 * self.steps, fitting))
