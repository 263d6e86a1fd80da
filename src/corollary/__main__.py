"""`python -m corollary` is the command `corollary`, for a Python that has the package but no such command on its path."""

import sys

from corollary.cli.main import main

if __name__ == "__main__":
    sys.exit(main())
