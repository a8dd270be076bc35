"""Requests per second, times and memory of the server and of nginx: the same files, generator and machine.

Needs wrk on the PATH, and compares with nginx if that is installed, too. Generator and server share the machine's
cores. Memory is reported after each round of loads.
"""

from __future__ import annotations

import hashlib
import itertools
import re
import shutil
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from benchmarks.harness.process import running
from benchmarks.harness.report import folder_or_temporary, start, table
from benchmarks.harness.timing import resident

SMALL, TYPICAL = ("small.bin", 5_000), ("typical.bin", 300_000)
"""Name and bytes of files as large as a ring's list of texels, and as a ring's geometry."""
REQUESTS = {
    "5 kB": (SMALL[0], None),
    "300 kB": (TYPICAL[0], None),
    "10 kB of 300 kB": (TYPICAL[0], "bytes=100000-109999"),
}
CONNECTIONS = (100, 1000)
SECONDS = 8
HEADER = " | server | connections | requests/s {:,.0f} | MB/s {:,.0f} | median ms {:.1f} | 99th percentile ms {:.1f}"
HEADER += " | errors"

NEARFAR = """
import sys
from pathlib import Path
from nearfar.serve._server import Server
from nearfar.serve._site import Site
folder = Path(sys.argv[1])
files = {f"files/{path.name}": (str(path), path.stat().st_size) for path in (folder / "files").iterdir()}
with Server({"": Site(files)}) as server:
    print(server.url, flush=True)
    sys.stdin.read()
"""

NGINX = """
daemon off; worker_processes 2; pid {folder}/nginx.pid; error_log stderr crit;
events {{ worker_connections 4096; }}
http {{
  access_log off; sendfile on; tcp_nopush on; keepalive_requests 1000000000; default_type application/octet-stream;
  client_body_temp_path {folder}/t1; proxy_temp_path {folder}/t2; fastcgi_temp_path {folder}/t3;
  uwsgi_temp_path {folder}/t4; scgi_temp_path {folder}/t5;
  server {{ listen 127.0.0.1:{port} backlog=4096; root {folder}; }}
}}
"""


@contextmanager
def nearfar(folder: Path) -> Iterator[tuple[str, int]]:
    """Serve a folder's files; yield the address and the process number."""
    with running(sys.executable, "-c", NEARFAR, str(folder)) as (process, url):
        yield url, process.pid


@contextmanager
def nginx(folder: Path) -> Iterator[tuple[str, int]]:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    settings = folder / "nginx.conf"
    settings.write_text(NGINX.format(folder=folder, port=port))
    with subprocess.Popen(["nginx", "-e", "stderr", "-p", str(folder), "-c", str(settings)]) as process:
        while process.poll() is None and not answers(port):
            time.sleep(0.05)
        yield f"http://127.0.0.1:{port}/", process.pid
        process.terminate()


def answers(port: int) -> bool:
    with socket.socket() as line:
        return line.connect_ex(("127.0.0.1", port)) == 0


def megabytes(process: int) -> float:
    """Memory in megabytes of a process and its children."""
    children = Path(f"/proc/{process}/task/{process}/children").read_text().split()
    return sum(resident(process=each) for each in [str(process), *children]) / 1.024e6


def load(url: str, connections: int, seconds: int, part: str | None) -> tuple[float, float, float, float, int]:
    """Requests and megabytes per second, median and 99th percentile in milliseconds, number of errors."""
    headers = [] if part is None else ["-H", f"Range: {part}"]
    command = ["wrk", "-t", "1", "-c", str(connections), "-d", f"{seconds}s", "--latency", *headers, url]
    report = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    units = {"us": 1e-3, "ms": 1.0, "s": 1e3, "m": 6e4}

    def milliseconds(percentile: int) -> float:
        value, unit = re.findall(rf"{percentile}%\s+([\d.]+)(us|ms|s|m)\b", report)[0]
        return float(value) * units[unit]

    count, duration = re.findall(r"(\d+) requests in ([\d.]+)s", report)[0]
    size, unit = re.findall(r"Transfer/sec:\s+([\d.]+)([KMG]?)B", report)[0]
    rate = float(size) * 1024 ** " KMG".index(unit or " ") / 1e6
    failed = re.findall(r"Socket errors: connect (\d+), read (\d+), write (\d+), timeout (\d+)", report)
    refused = re.findall(r"Non-2xx or 3xx responses: (\d+)", report)
    errors = sum(map(int, [*refused, *itertools.chain(*failed)]))
    return int(count) / float(duration), rate, milliseconds(50), milliseconds(99), errors


def row(url: str, server: str, request: str, connections: int, seconds: int) -> list[Any]:
    file, part = REQUESTS[request]
    return [request, server, connections, *load(f"{url}files/{file}", connections, seconds, part)]


def run(folder: Path, seconds: int, rounds: int) -> None:
    """Load the servers in turn, and print the table and memory."""
    servers = {"nearfar": nearfar, **({"nginx": nginx} if shutil.which("nginx") else {})}
    rows: list[list[Any]] = []
    memory: list[list[Any]] = []
    for name, server in servers.items():
        with server(folder) as (url, process):
            load(f"{url}files/{SMALL[0]}", 10, 1, None)
            sizes = [megabytes(process)]
            for number in range(rounds):
                loads = [row(url, name, *load, seconds) for load in itertools.product(REQUESTS, CONNECTIONS)]
                rows += [] if number else loads
                sizes.append(megabytes(process))
            memory.append([name, *sizes[:2], max(sizes), sizes[-1]])
    rows.sort(key=lambda cells: ([*REQUESTS].index(cells[0]), cells[2]))
    print(table("Load", HEADER, rows))
    header = f"server | MB before {{:.0f}} | after a round {{:.0f}} | most {{:.0f}} | after {rounds} {{:.0f}}"
    print(table("Memory", header, memory))
    if "nginx" not in servers:
        print("nginx is not on the PATH: nothing to compare with")


def main() -> None:
    options = start(__doc__, "--quick", rounds=(1, "rounds of loads; rates are those of the first one"))
    if not shutil.which("wrk"):
        sys.exit("wrk: expected it on the PATH")
    with folder_or_temporary() as folder:
        (folder / "files").mkdir()
        for file, count in (SMALL, TYPICAL):
            (folder / "files" / file).write_bytes(hashlib.shake_128(file.encode()).digest(count))
        # nginx's workers run as another user if root starts it.
        folder.chmod(0o755)
        run(folder, 1 if options.quick else SECONDS, options.rounds)


if __name__ == "__main__":
    main()
