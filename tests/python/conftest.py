import json
import os
import subprocess

import pytest


@pytest.fixture(scope="session")
def answer():
    """The values that the command answers, as its JSON gives them."""

    def ask(*words):
        out = subprocess.run([os.environ["RAILBOOK"], *words, "--json"], check=True, capture_output=True, text=True)
        return json.loads(out.stdout)["values"]

    return ask
