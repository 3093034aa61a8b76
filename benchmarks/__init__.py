"""How fast Barchan is: ``python -m benchmarks`` measures and prints, ``--write`` puts it into the docs."""
