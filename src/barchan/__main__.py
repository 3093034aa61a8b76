"""``python -m barchan`` is the command ``barchan``."""

from barchan.cli import main

if __name__ == "__main__":
    main()
