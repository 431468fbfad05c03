"""Serves a model with llama.cpp's HTTP server until standard input ends: `python serve.py MODEL KEY CONTEXT`.

The first line of standard output that begins with READY has the address.
"""

from __future__ import annotations

import sys

import xllamacpp


def main() -> None:
    """Serve."""
    parameters = xllamacpp.CommonParams()
    parameters.model.path = sys.argv[1]
    parameters.api_keys = [sys.argv[2]]
    parameters.model_alias = {"tiny-random"}
    parameters.n_ctx = int(sys.argv[3])
    parameters.n_parallel = 2
    parameters.hostnames = ["127.0.0.1"]
    parameters.port = 0
    parameters.warmup = False
    parameters.cpuparams.n_threads = 1
    parameters.use_jinja = True
    server = xllamacpp.Server(parameters)
    print("READY", server.listening_address, flush=True)
    sys.stdin.read()


if __name__ == "__main__":
    main()
