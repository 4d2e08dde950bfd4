"""nginx as `deploy/` configures it, before servers on this machine."""

import os
import shutil
import socket
import subprocess
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path

import pytest

from tests.serve.command import ROOT, Served, wait_for

CONFIGURATION = ROOT / "deploy" / "nginx" / "nginx.conf"


def find_nginx(folder: Path) -> Path:
    """Find nginx, or unpack the distribution's into a folder; skip without one, and fail in CI.

    Unpacking needs no rights and starts no service, as installing would.
    """
    installed = shutil.which(
        "nginx", path=f"{os.environ.get('PATH', '')}:/usr/sbin:/usr/local/sbin"
    )
    if installed:
        return Path(installed)
    unpacked = folder / "usr" / "sbin" / "nginx"
    if shutil.which("apt-get") and (_unpack(folder) or (_update() and _unpack(folder))):
        return unpacked
    reason = "no nginx: install one, or let apt-get download it"
    if os.environ.get("CI"):
        pytest.fail(reason)
    pytest.skip(reason)


def _update() -> bool:
    return _succeeds(["apt-get", "update", "-qq"], Path.cwd())


def _unpack(folder: Path) -> bool:
    if not _succeeds(["apt-get", "download", "-qq", "nginx"], folder):
        return False
    (package,) = folder.glob("nginx_*.deb")
    _succeeds(["dpkg", "-x", package.name, "."], folder)
    return _succeeds([str(folder / "usr" / "sbin" / "nginx"), "-v"], folder)


def _succeeds(command: Sequence[str], folder: Path) -> bool:
    ended = subprocess.run(command, cwd=folder, capture_output=True, check=False, timeout=300)
    return ended.returncode == 0


@contextmanager
def in_front_of(
    nginx: Path, folder: Path, addresses: Sequence[str], changed: Mapping[str, str] | None = None
) -> Iterator[Served]:
    """Start nginx with the configuration of `deploy/`, other ports, folders and texts put in.

    127.0.0.7 stands for a proxy before it.
    """
    with socket.create_server(("127.0.0.1", 0)) as probe:
        port = probe.getsockname()[1]
    text = CONFIGURATION.read_text("utf-8")
    here = {"listen 8080": f"listen 127.0.0.1:{port}", "/tmp/": f"{folder}/"}  # noqa: S108
    for theirs, ours in (here | dict(changed or {})).items():
        assert theirs in text
        text = text.replace(theirs, ours)
    (folder / "nginx.conf").write_text(text, "utf-8")
    servers = "".join(f"server {address} max_fails=1 fail_timeout=5s;\n" for address in addresses)
    upstream = f"""
        upstream servers {{ zone servers 64k; least_conn; {servers} keepalive 32; }}
        geo $realip_remote_addr $is_proxy {{ default 0; 127.0.0.7 1; }}
        set_real_ip_from 127.0.0.7;
        real_ip_header X-Forwarded-For;
        real_ip_recursive on;
    """
    (folder / "upstream.conf").write_text(upstream, "utf-8")
    # Workers of a master that runs as root would be another user, who may not enter the folder.
    main = "daemon off;" + (" user root;" if os.geteuid() == 0 else "")
    output, errors = folder / "stdout", folder / "stderr"
    with (
        output.open("wb") as out,
        errors.open("wb") as err,
        subprocess.Popen(
            [nginx, "-p", folder, "-c", folder / "nginx.conf", "-g", main], stdout=out, stderr=err
        ) as process,
    ):
        front = Served(process, f"http://127.0.0.1:{port}", output)
        try:
            wait_for(lambda: process.poll() is not None or front.listens())
            assert process.poll() is None, errors.read_text("utf-8")
            yield front
        finally:
            process.terminate()
