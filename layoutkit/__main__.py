"""``python -m layoutkit``."""

import sys

from layoutkit.cli.app import main

sys.exit(main())
