"""Hostile code cells: what a student may write to read, change, stop, fill or outstay what is not the student's."""

from __future__ import annotations

from collections.abc import Iterator

# What every cell below finds: `won` prints the sign of success, and what was got hold of; `call` makes a call of the system by its
# number on x86-64, and `may` sees whether it was allowed to, where success would do harm.
PRELUDE = """
import ctypes, os, platform, signal, socket, sys
libc = ctypes.CDLL(None, use_errno=True)
def won(evidence=""): print(WON[::-1], str(evidence))
def call(number, *words):
    assert platform.machine() == "x86_64"
    assert libc.syscall(number, *words) >= 0
    won()
def may(number, *words):
    assert platform.machine() == "x86_64"
    assert libc.syscall(number, *words) >= 0 or ctypes.get_errno() not in (1, 13, 38)
    won()
def read(path):
    with open(path, "rb") as file: return file.read(100_000).hex()
"""

PATHS = ("KEY", "MARKS", "OTHER", "ROSTER", "GRADEBOOK")
WAYS_TO_READ = {
    "open": "print(read({0}))",
    "os.open": "print(os.read(os.open({0}, os.O_RDONLY), 10**5).hex())",
    "numpy": "import numpy; print(numpy.memmap({0}, 'uint8', 'r').tobytes()[:10**5].hex())",
    "C library": "b = ctypes.create_string_buffer(10**5)\nlibc.read(libc.open({0}.encode(), 0), b, 10**5); print(b.raw.rstrip(b'\\0').hex())",
    "a link": "os.symlink({0}, 'l'); print(read('l'))",
    "a hard link": "os.link({0}, 'h'); print(read('h'))",
    "the shell": "!cat {{{0}}}",
    "a magic": "%load {{{0}}}",
    "a program": "import subprocess; print(subprocess.run(['cat', {0}], capture_output=True).stdout.hex())",
    "the root of the parent": "print(read(f'/proc/{{os.getppid()}}/root' + {0}))",
    "its own root": "print(read('/proc/self/root' + {0}))",
    "a URL": "import urllib.request; print(urllib.request.urlopen('file://' + {0}).read(10**5).hex())",
}
READS = {
    "the marks by sqlite": "import sqlite3; won(sqlite3.connect(f'file:{GRADEBOOK}?mode=ro', uri=True).execute('select * from grade').fetchall())",
    "names in the course": "print(os.listdir(HOME), os.listdir(os.path.dirname(MARKS)))",
    "names by walking up": "os.chdir('..'); print([os.listdir('../' * n) for n in range(9)], *os.walk(HOME))",
    "the environment": "print(dict(os.environ), os.environb)",
    "the environment of the parent": "print(bytes.fromhex(read(f'/proc/{os.getppid()}/environ')))",
    "the environment of the first process": "print(bytes.fromhex(read('/proc/1/environ')))",
    "open files": "for n in range(3, 200):\n    try: print(os.pread(n, 10**4, 0).hex())\n    except OSError: pass",
    "open folders": "for n in range(3, 200):\n    try: won(os.listdir(n))\n    except OSError: pass",
    "files of the parent": "for n in range(200):\n    try: print(read(f'/proc/{os.getppid()}/fd/{n}'))\n    except OSError: pass",
    "memory of the parent": "open(f'/proc/{os.getppid()}/mem', 'rb', 0); won() if os.getppid() else None",
    "memory of a bystander": "open(f'/proc/{PROCESS}/mem', 'rb', 0); won()",
    "variables of the machinery": "import gc\nprint([str(o)[:5000] for o in gc.get_objects() if type(o) is dict and 'key' in o])",
    "frames above": "f = sys._getframe()\nwhile f: print(str(f.f_globals)[:20000], str(f.f_locals)[:20000]); f = f.f_back",
    "the solutions": "import corollary; won()",
    "the accounts": "print(read('/etc/passwd')); won()",
    "keys of the user": "won(os.listdir(os.path.expanduser('~/.ssh')))",
    "programs of others": "for p in os.listdir('/proc'):\n    if p.isdigit() and int(p) not in (1, os.getpid()): won(read(f'/proc/{p}/cmdline'))",
    "a file by its handle": "call(303, -100, KEY.encode(), ctypes.create_string_buffer(b'\\x80' + bytes(200)), ctypes.byref(ctypes.c_int()), 0)",
    "a notebook that ran before": "import gc\nfor o in gc.get_objects():\n    if type(o) is str and o.startswith('earlier ') and o.endswith(' answer'): won(o)",
}
CHANGES = {
    "append to marks": "open(MARKS, 'a').write('x')",
    "overwrite the key": "open(KEY, 'wb').write(bytes(32))",
    "another's hand-in": "open(OTHER, 'w').write('{}')",
    "a file in the course": "open(os.path.join(HOME, 'new'), 'w').write('x')",
    "rename": "os.rename(MARKS, MARKS + '2')",
    "remove": "os.remove(MARKS)",
    "truncate": "os.truncate(MARKS, 0)",
    "rights": "os.chmod(MARKS, 0o777)",
    "times": "os.utime(MARKS, (1, 1))",
    "owner": "os.chown(MARKS, 1, 1)",
    "attributes": "os.setxattr(MARKS, b'user.x', b'x'); won()",
    "the gradebook": "import sqlite3; c = sqlite3.connect(GRADEBOOK); c.execute('create table x (y)'); c.commit(); won()",
    "the shared temporary folder": "open(OUT, 'w').write('x')",
    "shared memory": "open('/dev/shm/corollary-attack', 'w').write('x'); os.remove('/dev/shm/corollary-attack'); won()",
    "a start-up file": "h = os.path.expanduser('~')\nassert os.path.realpath(h) != os.path.realpath('.') and os.path.exists('/etc/passwd')\n"
    "os.makedirs(h + '/.corollary-attack'); os.rmdir(h + '/.corollary-attack'); won()",
    "a library": "import numpy; open(numpy.__file__, 'a').write('#'); won()",
    "a module for all": "open(os.path.join(os.path.dirname(os.__file__), 'sitecustomize.py'), 'w').close(); won()",
    "a mount": "may(165, b'x', b'/', b'nosuchfs', 0, None)",
    "another root": "call(161, b'/')",
    "a device": "os.mknod('d', 0o60666, os.makedev(8, 0)); won()",
    "its own answers elsewhere": "os.symlink(MARKS, 'week.ipynb'); open('week.ipynb', 'a').write('x')",
}
CALLS = {
    "ptrace": "call(101, 16, PROCESS, 0, 0)",
    "process_vm_readv": "b = ctypes.create_string_buffer(64); v = (ctypes.c_size_t * 2)(ctypes.addressof(b), 8)\n"
    "r = (ctypes.c_size_t * 2)(0x400000, 8); n = libc.syscall(310, PROCESS, v, 1, r, 1, 0)\n"
    "won() if n >= 0 or ctypes.get_errno() == 14 else None",
    "pidfd_open": "call(434, PROCESS, 0)",
    "setns": "call(308, os.open('/proc/self/ns/pid', 0), 0)",
    "unshare": "call(272, 0x10000000)",
    "io_uring": "call(425, 8, ctypes.create_string_buffer(120))",
    "bpf": "call(321, 0, ctypes.create_string_buffer(bytes([2, 0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 1, 0, 0, 0]), 72), 72)",
    "perf_event_open": "call(298, ctypes.create_string_buffer(bytes([1, 0, 0, 0, 112]), 112), 0, -1, -1, 0)",
    "userfaultfd": "call(323, 0)",
    "keyctl": "call(250, 0, -3, 1)",
    "add_key": "call(248, b'user', b'x', b'y', 1, -3)",
    "prlimit of a bystander": "import resource; resource.prlimit(PROCESS, resource.RLIMIT_NOFILE, (9, 9)); won()",
    "priority of a bystander": "os.setpriority(os.PRIO_PROCESS, PROCESS, 19); won()",
    "cores of a bystander": "os.sched_setaffinity(PROCESS, {0}); won()",
    "host name": "n = socket.gethostname().encode(); call(170, n, len(n))",
    "the administrator": "os.setuid(0); won() if os.path.exists('/etc/shadow') else None",
    "the kernel's log": "call(103, 3, ctypes.create_string_buffer(1000), 1000)",
    "a kernel module": "may(313, -1, b'', 0)",
    "the keyboard": "import fcntl; fcntl.ioctl(0, 0x5412, b' '); won()",
    "a program in memory": "f = libc.syscall(319, b'x', 0); os.write(f, b'#!/bin/sh\\n'); os.execve(f, ['x'], {})",
}
PROCESSES = {
    "fork": "won() if os.fork() else os._exit(0)",
    "many forks": "for n in range(50):\n    if os.fork() == 0: import time; time.sleep(2); os._exit(0)\nwon()",
    "vfork by number": "p = libc.syscall(57)\nos._exit(0) if p == 0 else None\nassert p > 0; won()",
    "clone3": "call(435, ctypes.create_string_buffer(88), 88)",
    "a program": "import subprocess; subprocess.run(['true'], check=True); won()",
    "posix_spawn": "os.posix_spawn('/bin/true', ['true'], {}); won()",
    "the shell": "import os; assert os.system('true') == 0; won()",
    "a pool": "import multiprocessing as m; m.get_context('fork').Process(target=print).start(); won()",
    "an orphan": "if os.fork() == 0:\n    os.setsid()\n    if os.fork() == 0: import time; time.sleep(5)\n    os._exit(0)\nwon()",
    "exec": "os.execv('/bin/sleep', ['sleep', '3'])",
    "stop a bystander": "os.kill(PROCESS, signal.SIGTERM)",
    "stop it by number": "libc.syscall(129, PROCESS, 15, ctypes.create_string_buffer(128))",
    "stop it by a thread": "libc.syscall(234, PROCESS, PROCESS, 15)",
    "stop it by its group": "os.killpg(os.getpgid(PROCESS), 0); won()",
    "stop it by a file": "import fcntl; a, b = socket.socketpair(); fcntl.fcntl(a, 10, 15); fcntl.fcntl(a, 8, PROCESS); fcntl.fcntl(a, 4, 0o20000); b.send(b'x')",
    "stop the parent": "os.kill(os.getppid(), signal.SIGKILL)",
    "stop the session": "os.killpg(0, signal.SIGTERM)",
    "end with threads left": "import threading, time\nfor n in range(20): threading.Thread(target=time.sleep, args=(600,)).start()",
    "end itself": "os._exit(0)",
    "crash": "ctypes.string_at(0)",
    "recursion": "sys.setrecursionlimit(10**9)\nclass A:\n    def __getattr__(s, n): return getattr(s, n + 'x')\nA().y",
}
NETWORK = {
    "TCP": "socket.create_connection(('127.0.0.1', PORT), 1); won()",
    "UDP": "socket.socket(socket.AF_INET, socket.SOCK_DGRAM).sendto(b'x', ('127.0.0.1', PORT))",
    "the internet": "socket.create_connection(('1.1.1.1', 53), 0.3); won()",
    "a name": "socket.getaddrinfo('example.org', 80); won()",
    "a page": "import urllib.request; urllib.request.urlopen('http://127.0.0.1/', timeout=0.3); won()",
    "a socket in the course": "s = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM); s.sendto(b'x', SOCKET)",
    "an abstract socket": "s = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM); s.sendto(b'x', ABSTRACT)",
    "one of a pair": "a, b = socket.socketpair(socket.AF_UNIX, socket.SOCK_DGRAM); a.sendto(b'x', SOCKET)",
    "a pair connected": "a, b = socket.socketpair(socket.AF_UNIX, socket.SOCK_DGRAM); a.connect(ABSTRACT); a.send(b'x')",
    "listening": "s = socket.socket(); s.bind(('0.0.0.0', 0)); s.listen(); won()",
    "raw packets": "socket.socket(socket.AF_PACKET, socket.SOCK_RAW, 3); won()",
    "the bus": "s = socket.socket(socket.AF_UNIX); s.connect('/run/dbus/system_bus_socket'); won()",
}
AMOUNTS = {
    "memory": "x = bytearray(10**9); won()",
    "memory in pieces": "x = [bytearray(10**7) for n in range(100)]; won()",
    "memory of numpy": "import numpy; numpy.ones(125_000_000); won()",
    "memory of a file": "f = libc.syscall(319, b'x', 0)\nfor n in range(100): assert os.write(f, bytes(10**7)) == 10**7\nwon()",
    "one file": "f = open('big', 'wb')\nfor n in range(100): f.write(bytes(10**6)); f.flush()\nwon()",
    "a file with a hole": "open('hole', 'wb').truncate(40 << 30); won()",
    "many files": "for n in range(30_000): open(f'f{n}', 'w').write('x' * 5000)\nwon()",
    "many folders": "for n in range(30_000): os.mkdir(f'd{n}')\nwon()",
    "a loop": "while True: pass",
    "a loop that catches all": "while True:\n    try:\n        while True: pass\n    except BaseException: pass",
    "no signals": "for n in (2, 15): signal.signal(n, signal.SIG_IGN)\nwhile True: pass",
    "sleep in the C library": "libc.sleep(100)",
    "a pattern": "import re; re.match('(a+)+$', 'a' * 60 + 'b')",
    "a power": "10 ** 10 ** 9",
    "an answer that never ends": "class N:\n    def __float__(s):\n        while True: pass\n    __repr__ = __str__ = __float__\na = N(); a",
    "an end that never comes": "import atexit, time; atexit.register(time.sleep, 600)",
    "output": "while True: print('x' * 10_000)",
    "outputs": "from IPython.display import display\nfor n in range(10**6): display({'text/html': 'x'}, raw=True)",
    "figures": "import matplotlib.pyplot as p\nfor n in range(60): p.figure(figsize=(90, 90)); p.plot(range(10**4))",
}
BENDING = {
    "modules": "for n in [*sys.modules]:\n    if n.startswith(('json', 'msgspec', 'sandbox', 'numpy')): sys.modules[n] = 0",
    "encoders": "import msgspec, json\nmsgspec.msgpack.Encoder = msgspec.msgpack.encode = json.dumps = lambda *a, **k: b'forged'",
    "builtins": "import builtins\nbuiltins.len = builtins.type = builtins.isinstance = lambda *a: 1/0",
    "the shell": "get_ipython().run_cell = lambda *a, **k: None\nget_ipython().showtraceback = None",
    "hooks": "s = get_ipython(); s.events.register('post_run_cell', lambda *a: 1/0)\ns.input_transformers_cleanup.append(len)",
    "syntax": "import ast\nclass T(ast.NodeTransformer):\n    def visit(s, n): exit(1/0)\nget_ipython().ast_transformers.append(T())",
    "streams": "sys.displayhook = sys.excepthook = None; sys.stdout = sys.stderr = None",
    "clocks": "import time\ntime.monotonic = time.time = lambda: 0\nsignal.signal = None",
    "bytes into every file": "for n in range(3, 60):\n    try: os.write(n, b'\\xff' * 100)\n    except OSError: pass",
    "no files": "for n in range(60):\n    try: os.close(n)\n    except OSError: pass",
    "forged results": "import msgspec\nf = msgspec.msgpack.encode({'t': 'cell', 'index': 99, 'status': 'ok', 'error': '', 'outputs': [], "
    "'figures': [], 'values': {'first': ('real', 1.0)}})\nos.write(3, len(f).to_bytes(4, 'big') + f)",
    "endless results": "while True: os.write(3, (5).to_bytes(4, 'big') + b'\\x81\\xa1t\\xa1x')",
    "a pickle": "class P:\n    def __reduce__(s): return (os.system, (f'touch {OUT}',))\na = P()\nimport pickle; b = pickle.dumps(a); first2 = b",
    "an array of pickles": "import numpy; a = numpy.array([{1: print}], dtype=object)",
    "a number that lies": "class L(float):\n    def __float__(s): return 8.6\n    def __eq__(s, o): return True\na = L(2)",
    "a text that is code": "a = '__import__(\"os\").system(\"touch ' + OUT + '\")'",
    "a formula that is code": "import sympy; a = sympy.Function('__import__(\"os\")')(sympy.Symbol('x'))",
    "a huge number": "a = 10 ** 100_000",
    "a huge array": "import numpy; a = numpy.broadcast_to(8.6, (10**6, 10**6))",
    "a list in itself": "a = []; a.append(a)",
    "a nesting": "a = 0\nfor n in range(100_000): a = [a]",
    "half a character": "a = '\\ud800' * 100; print(a); raise ValueError(a)",
}


def hostile_cells() -> Iterator[tuple[str, str, str]]:
    """Family, name and source of each cell."""
    for path in PATHS[:1]:
        for way, source in WAYS_TO_READ.items():
            yield "reading", f"the key by {way}", source.format(path)
    for path in PATHS[1:]:
        yield "reading", path.lower(), f"won(read({path})[:9])"
    families = {"reading": READS, "changing": CHANGES, "system calls": CALLS, "processes": PROCESSES}
    families |= {"network": NETWORK, "amounts": AMOUNTS, "bending": BENDING}
    for family, cells in families.items():
        for name, source in cells.items():
            yield family, name, source
