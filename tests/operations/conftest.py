import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))


@pytest.fixture(scope="session")
def stages():
    """What runs stages, with all plugins."""
    from layoutkit.hooks.host import Host
    from layoutkit.hooks.running import Runner

    return Runner(Host.load())
