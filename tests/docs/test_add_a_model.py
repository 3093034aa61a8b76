"""The worked example of docs/add-a-model.md is a model like any other, found by its entry point."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

PAGE = Path(__file__).parents[2] / "docs" / "add-a-model.md"


@pytest.fixture
def installed(tmp_path):
    """A folder that holds the example as if it had been installed, and how to run ``barchan`` with it."""
    text = PAGE.read_text("utf-8")
    module = re.search(r"<!-- file: damp.py -->\n```python\n(.*?)```", text, re.DOTALL)
    entry = re.search(r"```toml\n\[project\.entry-points\.\"(.*?)\"\]\n(\w+) = \"(.*?)\"\n```", text)
    (tmp_path / "damp.py").write_text(module[1], "utf-8")
    info = tmp_path / "damp-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: damp\nVersion: 1.0\n")
    (info / "entry_points.txt").write_text(f"[{entry[1]}]\n{entry[2]} = {entry[3]}\n")
    path = os.pathsep.join(filter(None, [str(tmp_path), os.environ.get("PYTHONPATH")]))

    def barchan(*arguments):
        command = [sys.executable, "-c", "from barchan.cli import main; main()", *arguments]
        environment = {**os.environ, "PYTHONPATH": path}
        return subprocess.run(
            command, env=environment, cwd=tmp_path, capture_output=True, text=True, check=True
        )

    return barchan


@pytest.mark.extended
def test_a_model_of_another_package_is_found_and_run(installed, tmp_path):
    size = ["--lattice.rows", "32", "--lattice.columns", "64", "--run.steps", "20", "--run.seed", "1"]
    model = ["--model.name", "damp", "--model.water-table", "0.4"]
    installed("run", "sand-patch", *size, *model, "--out", "damp", "--quiet")
    assert (tmp_path / "damp" / "last.png").exists()
    assert "model.water_table" in installed("parameters", "model").stdout
    assert "water_table" in installed("schema").stdout


def test_its_mistakes_are_reported_like_any_others(installed):
    with pytest.raises(subprocess.CalledProcessError) as failed:
        installed("check", "barchans", "--model.name", "damp", "--model.water-table", "5000")
    assert "model.water_table: is 5000" in failed.value.stderr
