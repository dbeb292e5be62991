"""The documentation's Python prints what it says."""

import contextlib
import io
import re
from pathlib import Path

import duckdb
import pyarrow.parquet as pq
import pytest
from parkade import batch

ROOT = Path(__file__).parents[2]
PAGES = ["docs/python.md", "python/README.md"]


@pytest.mark.parametrize("page", PAGES)
def test_lines_print_what_they_say(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = (ROOT / page).read_text()
    names = {}
    blocks = re.findall(r"```python\n(.*?)```", text, re.S)
    assert blocks
    for code in blocks:
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(code, page, "exec"), names)
        expected = [line.split("  # ", 1)[1] for line in code.splitlines() if line.startswith("print(")]
        assert printed.getvalue().splitlines() == expected


def test_the_sql_of_the_columns_counts_what_there_is(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    scenes = [{"family": "random", "size": 20, "seed": seed} for seed in range(10)]
    tasks = batch.manifest(scenes, ["four", "eight"], batch.sweep(margin=[0, 0.1]))
    pq.write_table(tasks, "manifest.parquet")
    results = batch.plan_table(tasks.slice(0, 33))
    for name in ("sweep.parquet", "results.parquet"):
        batch.write(results, name)
    blocks = re.findall(r"```sql\n(.*?)```", (ROOT / "docs/command.md").read_text(), re.S)
    quantiles, wins, rest = (duckdb.sql(code).fetchall() for code in blocks)
    assert sum(row[2] for row in quantiles) == 33
    assert all(row[3] == 1 for row in quantiles)
    by_rival = {row[:2]: row[2:] for row in wins}
    assert by_rival["eight", "four"][0] > 0
    assert by_rival["eight", "four"] == by_rival["four", "eight"][::-1]
    assert len(rest) == 7
