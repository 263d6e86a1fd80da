"""Seccomp: the system calls a computation needs; every other one fails with "operation not permitted" (seccomp(2))."""

import errno
import os

_FILES = """read write readv writev pread64 pwrite64 preadv pwritev preadv2 pwritev2 lseek _llseek close close_range
 open openat stat lstat fstat newfstatat stat64 lstat64 fstat64 fstatat64 statx statfs fstatfs access faccessat faccessat2
 readlink readlinkat getdents getdents64 getcwd chdir fchdir mkdir mkdirat rmdir unlink unlinkat rename renameat renameat2
 symlink symlinkat truncate ftruncate fallocate fsync fdatasync fadvise64 sendfile copy_file_range dup dup2 dup3 flock
 umask pipe pipe2 poll ppoll select pselect6 epoll_create epoll_create1 epoll_ctl epoll_wait epoll_pwait eventfd2
 socketpair recvfrom shutdown getsockname getpeername getsockopt setsockopt"""
_MEMORY = "mmap munmap mremap mprotect madvise brk mincore msync membarrier"
_TIME = """clock_gettime clock_getres clock_nanosleep nanosleep gettimeofday time times getitimer setitimer alarm
 timer_create timer_settime timer_gettime timer_delete"""
_SELF = """getpid gettid getppid getuid geteuid getgid getegid getresuid getresgid getgroups getpgrp getpgid getsid
 getrusage getrlimit setrlimit prlimit64 getpriority sysinfo uname getrandom getcpu sched_yield sched_getaffinity
 sched_getparam sched_getscheduler sched_get_priority_max sched_get_priority_min futex futex_waitv set_robust_list
 get_robust_list rseq set_tid_address arch_prctl exit exit_group wait4 waitid pause restart_syscall
 rt_sigaction rt_sigprocmask rt_sigreturn rt_sigpending rt_sigsuspend rt_sigtimedwait sigaltstack"""
_ALLOWED = f"{_FILES} {_MEMORY} {_TIME} {_SELF}"
_SIGNALS = "kill tkill tgkill"
# Library code calls these in passing (shutil.copy, tempfile); they succeed and change nothing.
_PRETENDED = "chmod fchmod fchmodat fchmodat2 chown fchown lchown fchownat utime utimes utimensat futimesat"
_UNSUPPORTED = "getxattr lgetxattr fgetxattr listxattr llistxattr flistxattr setxattr lsetxattr fsetxattr"
# ioctl(2): TCGETS TIOCGWINSZ FIONREAD FIONBIO FIONCLEX FIOCLEX. Not TIOCSTI, which types into the grader's terminal
# (CVE-2017-5226), and not FIOSETOWN, which is F_SETOWN by another name.
_IOCTL = (0x5401, 0x5413, 0x541B, 0x5421, 0x5450, 0x5451)
# fcntl(2): F_DUPFD F_GETFD F_SETFD F_GETFL F_SETFL, locks, open file description locks, F_DUPFD_CLOEXEC, pipe sizes, seals.
# Not F_SETOWN, F_SETOWN_EX and F_SETSIG: with O_ASYNC they have the kernel send any signal to any process of the user.
_FCNTL = (0, 1, 2, 3, 4, 5, 6, 7, 36, 37, 38, 1030, 1031, 1032, 1033, 1034)
_CLONE_THREAD = 0x00010000


class NoSeccomp(Exception):
    """Seccomp cannot be used here; the message says why."""


def compile_filter(signals):
    """The filter as BPF instructions; `signals` says whether sending them is harmless, since they reach no other process."""
    try:
        import pyseccomp
    except (ImportError, OSError, RuntimeError) as error:
        raise NoSeccomp("pyseccomp or libseccomp is not installed (the extra `isolation`)") from error
    refused = pyseccomp.ERRNO(errno.EPERM)
    rules = pyseccomp.SyscallFilter(refused)
    for names, action in (
        (_ALLOWED, pyseccomp.ALLOW),
        (_PRETENDED, pyseccomp.ERRNO(0)),
        (_UNSUPPORTED, pyseccomp.ERRNO(errno.ENOTSUP)),
        (_SIGNALS if signals else "", pyseccomp.ALLOW),
        # The flags of clone3 lie in memory, where a filter cannot look; libc then falls back to clone.
        ("clone3", pyseccomp.ERRNO(errno.ENOSYS)),
    ):
        for name in names.split():
            _add(rules, action, name)
    _add(rules, pyseccomp.ALLOW, "clone", pyseccomp.Arg(0, pyseccomp.MASKED_EQ, _CLONE_THREAD, _CLONE_THREAD))
    # A pair of sockets has no way out, unless a datagram is sent with an address.
    _add(rules, pyseccomp.ALLOW, "sendto", pyseccomp.Arg(4, pyseccomp.EQ, 0))
    for call, requests in (("ioctl", _IOCTL), ("fcntl", _FCNTL)):
        for request in requests:
            _add(rules, pyseccomp.ALLOW, call, pyseccomp.Arg(1, pyseccomp.EQ, request))
    return _exported(rules)


def _add(rules, action, name, *arguments):
    try:
        rules.add_rule(action, name, *arguments)
    except (OSError, ValueError, RuntimeError) as error:
        # A call this architecture does not have needs no rule.
        if isinstance(error, OSError) and error.errno not in (
            errno.EFAULT,
            errno.EINVAL,
            errno.EDOM,
            errno.ENOENT,
        ):
            raise NoSeccomp(f"libseccomp refused a rule for {name}: {error}") from error


def _exported(rules):
    descriptor = os.memfd_create("filter")
    with os.fdopen(descriptor, "w+b") as file:
        rules.export_bpf(file)
        file.seek(0)
        return file.read()
