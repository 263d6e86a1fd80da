"""A Dask cluster that is there already: reached by its address, and how many processes it has."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from corollary.extras import installing

if TYPE_CHECKING:
    from distributed import Client

SECONDS_TO_CONNECT = 15


class NoCluster(Exception):
    """The cluster cannot be used; one sentence says why and what to do."""


def connect(address: str) -> Client:
    """A client of the scheduler at this address, which the caller closes; raises NoCluster where there is none, or no worker."""
    try:
        from distributed import Client
    except ImportError:
        raise NoCluster(f"a cluster needs Dask; install it with: {installing('dask')}") from None
    try:
        client = Client(address, timeout=SECONDS_TO_CONNECT)
    except (OSError, ValueError) as error:
        raise NoCluster(
            f"no Dask scheduler answers at {address} ({error}); start one, or leave out --executor"
        ) from None
    if not worker_count(client):
        client.close()
        raise NoCluster(
            f"the Dask cluster at {address} has no workers; start some with: dask worker {address} --nthreads 1"
        )
    return client


def worker_count(client: Client) -> int:
    """Of processes."""
    info: Any = client.scheduler_info(n_workers=-1)
    return len(info["workers"])
