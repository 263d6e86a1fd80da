"""Run as an ordinary user: a hostile notebook among this user's files, processes and sockets; prints what became of them."""

from __future__ import annotations

import json
import os
import socket
import subprocess
import sys
import tempfile
from pathlib import Path

from kernel import promised

from corollary.formula.value import Text
from corollary.sandbox.job import Cell, Job
from corollary.sandbox.runner import Runner

SECRET = "GROUSE-71-LANTERN"
HOSTILE = """
import ctypes, os, signal, socket
found = []
def attempt(deed):
    try: found.append(str(deed()))
    except BaseException: pass
def append():
    with open(FILE, "a") as file: file.write("changed")
def own(target, command):
    import fcntl
    a, b = socket.socketpair()
    fcntl.fcntl(a, command, target)
    fcntl.fcntl(a, fcntl.F_SETFL, os.O_ASYNC)
    b.send(b"x")
def own_with_signal(target):
    import fcntl
    a, b = socket.socketpair()
    fcntl.fcntl(a, 10, signal.SIGTERM)
    fcntl.fcntl(a, fcntl.F_SETOWN, target)
    fcntl.fcntl(a, fcntl.F_SETFL, os.O_ASYNC)
    b.send(b"x")
def datagram(family, address):
    with socket.socket(family, socket.SOCK_DGRAM) as s: s.sendto(b"x", address)
def from_pair(address):
    for half in socket.socketpair(socket.AF_UNIX, socket.SOCK_DGRAM):
        with half: half.sendto(b"x", address)
def connected_pair(address):
    for half in socket.socketpair(socket.AF_UNIX, socket.SOCK_DGRAM):
        with half:
            half.connect(address)
            half.send(b"x")
def memory(process):
    with open(f"/proc/{process}/maps") as maps:
        for line in maps:
            begin, end = (int(each, 16) for each in line.split()[0].split("-"))
            if " rw-p " in line and end - begin < 1 << 28:
                with open(f"/proc/{process}/mem", "rb", 0) as m:
                    m.seek(begin)
                    if SECRET[::-1].encode() in m.read(end - begin): return SECRET[::-1]
attempt(lambda: open(FILE).read())
attempt(lambda: os.listdir(HOME))
attempt(append)
attempt(lambda: open(os.path.join(HOME, "new"), "w").close())
attempt(lambda: os.chmod(FILE, 0o606))
attempt(lambda: os.utime(FILE, (1, 1)))
attempt(lambda: os.rename(FILE, FILE + "2"))
attempt(lambda: os.truncate(FILE, 0))
attempt(lambda: os.kill(PROCESS, signal.SIGTERM))
attempt(lambda: ctypes.CDLL(None).syscall(129, PROCESS, signal.SIGTERM, ctypes.create_string_buffer(128)))
attempt(lambda: own(PROCESS, 8))
attempt(lambda: own_with_signal(PROCESS))
attempt(lambda: datagram(socket.AF_INET, ("127.0.0.1", PORT)))
for address in (PATH, ABSTRACT):
    attempt(lambda: datagram(socket.AF_UNIX, address))
    attempt(lambda: from_pair(address))
    attempt(lambda: connected_pair(address))
if os.getppid():
    attempt(lambda: "zygote" if open(f"/proc/{os.getppid()}/mem", "rb") else "")
    attempt(lambda: "zygote" if open(f"/proc/{os.getppid()}/environ", "rb") else "")
seen = " ".join(found)
"""


def main(without: frozenset[str]) -> dict[str, object]:
    home = Path(tempfile.mkdtemp())
    file = home / "marks"
    file.write_text(SECRET)
    before = file.stat()
    process = subprocess.Popen(["sleep", "600"])
    inet = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    inet.bind(("127.0.0.1", 0))
    listening = [inet]
    path, abstract = str(home / "socket"), f"\0{home}"
    for address in (path, abstract):
        listening.append(socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM))
        listening[-1].bind(address)
    places = {"FILE": str(file), "HOME": str(home), "PROCESS": process.pid, "PORT": inet.getsockname()[1]}
    places |= {"PATH": path, "ABSTRACT": abstract, "SECRET": SECRET[::-1]}
    setting = "\n".join(f"{name} = {value!r}" for name, value in places.items())
    try:
        with Runner(without=without) as runner:
            result = runner.execute(Job((Cell("set", setting), Cell("do", HOSTILE)), ("seen",)))
            value = result.values["seen"]
            seen = value.text if isinstance(value, Text) else ""
            isolation = runner.isolation
        for each in listening:
            each.setblocking(False)
        arrived = [bool(_received(each)) for each in listening]
        unchanged = (
            file.exists() and file.read_text() == SECRET and _metadata(file.stat()) == _metadata(before)
        )
        return {
            "promised": promised(without),
            "level": isolation.level,
            "guaranteed": isolation.guaranteed,
            "missing": isolation.missing,
            "ran": [cell.status for cell in result.cells],
            "reads": SECRET not in seen and "marks" not in seen,
            "writes": unchanged and not (home / "new").exists(),
            "signals": process.poll() is None,
            "network": not any(arrived),
            "zygote": "zygote" not in seen,
        }
    finally:
        process.kill()
        process.wait()


def _metadata(status: os.stat_result) -> tuple[int, float]:
    return status.st_mode, status.st_mtime


def _received(listening: socket.socket) -> bytes:
    try:
        return listening.recv(10)
    except BlockingIOError:
        return b""


if __name__ == "__main__":
    print(json.dumps(main(frozenset(sys.argv[1:]))))
