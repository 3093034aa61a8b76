"""Models and parameters side by side: one ensemble, its statistics over seeds, and a report in one file."""
