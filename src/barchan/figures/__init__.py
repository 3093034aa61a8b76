"""Pictures of a run: each function takes data and returns a matplotlib figure, or writes a film."""
