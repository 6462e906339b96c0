"""Inputs of the tests: a scan as file and as arrays, and the command line, $SPIRALING_EDGE_PROGRAM."""
import json
import os
import subprocess

import pytest

import spiraling_edge as se


@pytest.fixture(scope="session")
def program():
    """program(*words): what the command line prints."""
    def run(*words):
        command = [os.environ["SPIRALING_EDGE_PROGRAM"], *map(str, words)]
        return subprocess.run(command, check=False, capture_output=True, text=True).stdout
    return run


@pytest.fixture(scope="session")
def answer(program):
    """answer(*words): the JSON that the command line prints."""
    return lambda *words: json.loads(program(*words, "--json"))


@pytest.fixture(scope="session")
def scan(tmp_path_factory, program):
    """A file with points and normals."""
    path = tmp_path_factory.mktemp("scan") / "scan.ply"
    program("run", "scene:torus", "-q", "--max-pivots", 0, "-o", path)
    return path


@pytest.fixture(scope="session")
def torus():
    return se.read("scene:torus")
