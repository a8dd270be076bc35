"""Tests of the shaped link of benchmarks: rate, delay, loss, queue, and clean-up."""

from __future__ import annotations

import os
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path as FilePath

import numpy as np
import pytest

import nearfar as nf
from benchmarks.harness.link import CHECKOUT, CLIENT, SERVER, Shaped, shaped
from benchmarks.harness.link.forward import Path
from tests.support import need

GOODPUT = 1448 / 1500
"""TCP payload of a full packet whose headers are IP's, TCP's and a time stamp."""


def path(link: nf.stream.Link, *, queue: int = 10**9, seed: int = 0) -> Path:
    return Path(link._clock(), delay=link.rtt / 2, loss=link.loss, queue=queue, seed=seed)


def arrivals(way: Path) -> list[float]:
    """Arrival times of the packets in transit."""
    times = []
    while (time_due := way.next()) is not None:
        times += [time_due] * len(way.due(time_due))
    return times


def test_packets_leave_one_after_the_other_and_arrive_after_the_delay() -> None:
    way = path(nf.stream.Link(8, rtt_ms=20))
    for now in (0.0, 0.0, 0.0005, 5.0):
        way.take(now, bytes(1000))
    assert way.due(0.0109) == []
    assert arrivals(way) == pytest.approx([0.011, 0.012, 0.013, 5.011], abs=1e-12)


def test_a_trace_changes_the_rate() -> None:
    way = path(nf.stream.Link(trace=([0.0, 1.0, 2.0], [8.0, 0.0, 4.0])))
    for now in (0.0, 0.9995, 2.5):
        way.take(now, bytes(1000))
    # Half of the second packet has passed when the link stops.
    assert arrivals(way) == pytest.approx([0.001, 2.001, 2.502], abs=1e-12)


def test_a_full_queue_drops_the_last_packets() -> None:
    way = path(nf.stream.Link(8), queue=2500)
    for mark in range(4):
        way.take(0.0, bytes([mark]) * 1000)
    way.take(0.0015, bytes([4]) * 1000)
    assert [packet[0] for packet in way.due(1.0)] == [0, 1, 4]
    assert (way.counts.taken, way.counts.overflowed, way.counts.delivered_bytes) == (5, 2, 3000)


def test_losses_follow_the_seed_and_use_capacity() -> None:
    link = nf.stream.Link(8, loss=0.1)
    ways = [path(link, seed=seed) for seed in (3, 3, 4)]
    for way in ways:
        for mark in range(20_000):
            way.take(0.0, mark.to_bytes(4, "big"))
    first, same, other = (way.due(1e9) for way in ways)
    assert first == same != other
    assert abs(ways[0].counts.lost - 2000) < 5 * (20_000 * 0.1 * 0.9) ** 0.5
    # Packets are lost after the bottleneck.
    last = int.from_bytes(first[-1], "big") + 1
    assert ways[0].counts.delivered == len(first)
    slow = path(link, seed=3)
    for mark in range(last):
        slow.take(0.0, mark.to_bytes(4, "big"))
    assert arrivals(slow)[-1] == pytest.approx(last * 4e-6, rel=1e-9)


@dataclass
class Bulk:
    """A server at one side that sends bytes to the first client."""

    address: tuple[str, int]
    kinds: list[str]
    """The congestion control of its connections."""


@contextmanager
def bulk_server(link: Shaped, count: int) -> Iterator[Bulk]:
    with link.side("server"):
        listener = socket.create_server((SERVER, 0))
    bulk = Bulk(listener.getsockname(), [])

    def serve() -> None:
        connection, _address = listener.accept()
        with connection:
            kind = connection.getsockopt(socket.IPPROTO_TCP, socket.TCP_CONGESTION, 16)
            bulk.kinds.append(kind.rstrip(b"\0").decode())
            connection.sendall(bytes(count))

    threading.Thread(target=serve, daemon=True).start()
    with listener:
        yield bulk


def download(link: Shaped, address: tuple[str, int], count: int) -> float:
    """Duration of a download of some bytes, seconds."""
    with link.side("client"):
        client = socket.socket()
    start = time.monotonic()
    with client:
        client.connect(address)
        while part := client.recv(1 << 18):
            count -= len(part)
    assert count == 0
    return time.monotonic() - start


def test_a_download_is_no_faster_than_the_link() -> None:
    need("link")
    mbps, count = 50.0, 3_000_000
    with shaped(nf.stream.Link(mbps, rtt_ms=20)) as link, bulk_server(link, count) as bulk:
        seconds = download(link, bulk.address, count)
        # Only a bound, because the machine may be slow. `Path` itself has exact times, tested above.
        assert seconds > count * 8e-6 / (mbps * GOODPUT)
        # Segments are cut to packets, so that their headers count.
        assert link.counts()["down"]["delivered_bytes"] >= count / GOODPUT
        assert bulk.kinds == ["cubic"]


def test_a_round_trip_takes_twice_the_delay() -> None:
    need("link")
    with shaped(nf.stream.Link(50, rtt_ms=30)) as link, datagram_sockets(link) as (server, client):
        for mark in range(12):
            start = time.monotonic()
            client.sendto(bytes([mark]), server.getsockname())
            data, address = server.recvfrom(100)
            server.sendto(data, address)
            assert client.recv(100) == bytes([mark])
            # At least the delay, however slow the machine is.
            assert time.monotonic() - start >= 0.030


def test_losses_are_counted_and_datagrams_pass() -> None:
    need("link")
    count, share = 1500, 0.05
    link_of = nf.stream.Link(100, rtt_ms=2, loss=share)
    with shaped(link_of, queue=10**8, seed=5) as link, datagram_sockets(link) as (server, client):
        server.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 8 << 20)
        rng = np.random.default_rng(7)
        sent = [mark.to_bytes(4, "big") + rng.bytes(1196) for mark in range(count)]
        got: list[bytes] = []
        for start in range(0, count, 50):
            for datagram in sent[start : start + 50]:
                client.sendto(datagram, server.getsockname())
            wait_for_taken(link, start + 50)
            up = link.counts()["up"]
            while len(got) < up["taken"] - up["lost"]:
                got.append(server.recv(2000))
        up = link.counts()["up"]
        assert up["taken"] == count
        assert up["overflowed"] == 0
        assert len(got) == count - up["lost"]
        assert got == [datagram for datagram in sent if datagram in set(got)]
        assert abs(up["lost"] - count * share) < 5 * (count * share * (1 - share)) ** 0.5
        # A datagram of 1200 bytes with the headers of UDP and IP.
        assert up["delivered_bytes"] == len(got) * 1228


def wait_for_taken(link: Shaped, count: int) -> None:
    for _ in range(2000):
        if link.counts()["up"]["taken"] >= count:
            return
        time.sleep(0.005)
    raise AssertionError(f"the link has not taken {count} packets: {link.counts()}")


@contextmanager
def datagram_sockets(link: Shaped) -> Iterator[tuple[socket.socket, socket.socket]]:
    """UDP sockets at the server's side and at the client's."""
    with link.side("server"):
        server = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    with link.side("client"):
        client = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    with server, client:
        for made, address in ((server, SERVER), (client, CLIENT)):
            made.bind((address, 0))
            made.settimeout(20.0)
        yield server, client


def test_programs_run_at_a_side_and_the_machines_network_is_unchanged() -> None:
    need("link")
    before = network()
    with shaped(nf.stream.Link(50)) as link:
        assert network() == before
        seen = subprocess.run(link.command("client", ["ip", "-brief", "address"]), capture_output=True, text=True)
        assert CLIENT in seen.stdout
        assert SERVER not in seen.stdout
        program = link.program("server", "/bin/cat")
        seen = subprocess.run([program, "/proc/net/dev"], capture_output=True, text=True, check=True)
        assert sorted(line.split(":")[0].strip() for line in seen.stdout.splitlines()[2:]) == ["lo", "shaped0"]
    assert network() == before


def network() -> dict[str, str]:
    """Routes, devices and TCP's settings of the machine."""
    devices = [line.split(":")[0].strip() for line in FilePath("/proc/net/dev").read_text().splitlines()[2:]]
    settings = FilePath("/proc/sys/net/ipv4")
    return {
        "devices": " ".join(sorted(devices)),
        "routes": FilePath("/proc/net/route").read_text(),
        **{path.name: path.read_text() for path in settings.glob("tcp_*") if os.access(path, os.R_OK)},
    }


def test_an_unknown_congestion_control_is_refused() -> None:
    need("link")
    with pytest.raises(OSError, match="congctl no-such"), shaped(nf.stream.Link(50), congestion="no-such"):
        pass


HOLDER = """
import signal, time
import nearfar as nf
from benchmarks.harness.link import shaped
# Background jobs of a shell ignore SIGINT.
signal.signal(signal.SIGINT, signal.default_int_handler)
with shaped(nf.stream.Link(50)) as link:
    print(link._process.pid, flush=True)
    time.sleep(600)
"""


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGINT])
def test_a_link_is_removed_when_its_process_dies(number: signal.Signals) -> None:
    need("link")
    command = [sys.executable, "-c", HOLDER]
    with subprocess.Popen(
        command, cwd=CHECKOUT, text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL
    ) as holder:
        assert holder.stdout
        forwarder = FilePath("/proc", holder.stdout.readline().strip())
        assert forwarder.exists()
        holder.send_signal(number)
    for _ in range(2000):
        if not forwarder.exists() or "\nState:\tZ" in (forwarder / "status").read_text():
            return
        time.sleep(0.01)
    raise AssertionError("the process that carries packets lives on")
