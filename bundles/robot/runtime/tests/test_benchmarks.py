"""Benchmarks run: figures that nobody can measure again are worth nothing."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from typing import Any

import pytest

BENCHMARKS = Path(__file__).parent / "benchmarks"


def load(name: str) -> Any:
    """Return a benchmark as a module."""
    spec = importlib.util.spec_from_file_location(name, BENCHMARKS / f"{name}.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_lockstep_benchmark_prints_its_figures(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Few steps of everything that it measures."""
    benchmark = load("benchmark_lockstep")
    monkeypatch.setattr(benchmark, "STEPS", 2)
    monkeypatch.setattr(benchmark, "MESSAGES", 2)
    benchmark.main()
    printed = capsys.readouterr().out
    assert "RESET until READY" in printed
    assert "callbacks of the four timers" in printed
