"""Settings, each an environment variable that starts with FRESNEL_."""

from collections.abc import Iterable
from difflib import get_close_matches
from pathlib import Path
from typing import Literal

from pydantic import Field, field_validator
from pydantic_settings import BaseSettings, SettingsConfigDict


def _static_dir() -> Path:
    """The page's files: inside the installed package, or beside it in a checkout."""
    here = Path(__file__).parent
    places = (here / "static", here.parent / "static")
    return next((path for path in places if path.is_dir()), places[0])


PREFIX = "FRESNEL_"


class Settings(BaseSettings):
    """What an operator may change without touching the code."""

    model_config = SettingsConfigDict(env_prefix=PREFIX, extra="forbid", frozen=True)

    host: str = Field("127.0.0.1", min_length=1, description="Address to listen on.")
    port: int = Field(8000, ge=0, le=65535, description="Port to listen on; 0 takes a free one.")
    http: Literal["auto", "h11", "httptools"] = Field(
        "auto",
        description="What reads requests: `h11` bounds what it keeps of one, `httptools` is faster "
        "and for servers that strangers reach through a proxy alone; `auto` takes `httptools` on a "
        "loopback address, else `h11`.",
    )
    workers: int = Field(1, ge=1, le=256, description="Processes that answer at the same port.")
    access_log: bool = Field(
        False, description="Write a line of JSON to standard output for every request."
    )
    drain_s: float = Field(
        0.0, ge=0, le=3600, description="Seconds to go on answering after SIGTERM, not ready."
    )
    grace_s: int = Field(
        25, ge=0, le=3600, description="Seconds that requests in flight are then given to end."
    )
    static_dir: Path = Field(default_factory=_static_dir, description="Folder of the page's files.")
    page: Literal["auto", "packed", "sources"] = Field(
        "auto",
        description="Whether the page comes in few files, as `make pack` made them, or module by "
        "module; `auto` takes the files unless they are missing or older than the sources.",
    )
    max_age_s: int = Field(
        3600, ge=0, description="How long caches may keep an answer of the API, in seconds."
    )
    cache_bytes: int = Field(
        64_000_000, ge=0, description="Memory for finished answers of the API, in bytes."
    )
    threads: int = Field(2, ge=1, description="How many large answers are computed at a time.")
    max_waiting: int = Field(32, ge=0, description="How many large answers wait to be computed.")
    timeout_s: float = Field(
        30.0, gt=0.0, description="How long a large answer may take, waiting included, in seconds."
    )
    picture_timeout_s: float = Field(
        20.0,
        gt=0.0,
        description="How long the browser may take for a picture before it is ended, in seconds.",
    )
    max_samples: int = Field(20_001, ge=2, description="Most angles of a curve.")
    max_cells: int = Field(250_000, ge=4, description="Most cells of a map.")
    max_body_bytes: int = Field(
        128_000_000, ge=1, description="Longest body of a request, in bytes."
    )
    max_target_bytes: int = Field(
        16_384, ge=100, le=65_535, description="Longest path with its query, in bytes."
    )
    max_header_bytes: int = Field(
        32_768, ge=1000, description="Longest headers of a request together, in bytes."
    )
    max_connections: int = Field(
        5000,
        ge=1,
        description="Most connections at a time; beyond, requests are answered with 503.",
    )
    read_timeout_s: float = Field(
        30.0,
        gt=0.0,
        description="How far a client may fall behind 100 kB a second in sending a body, in seconds.",
    )
    write_timeout_s: float = Field(
        30.0,
        gt=0.0,
        description="How far a client may fall behind 100 kB a second in reading a large answer, in "
        "seconds.",
    )
    keep_alive_s: int = Field(
        5, ge=0, description="How long a connection stays open after an answer, in seconds."
    )
    trusted_proxies: str = Field(
        "",
        description="Addresses or networks of proxies that are believed who the client is, "
        "separated by commas; * for all.",
    )
    allowed_hosts: str = Field(
        "*",
        description="Host names that are answered for, separated by commas; *.example.org for all "
        "below one, * for all. Health and metrics are answered under any name.",
    )

    @field_validator("static_dir")
    @classmethod
    def _has_the_page(cls, folder: Path) -> Path:
        if not (folder / "index.html").is_file():
            raise ValueError("there is no folder with the page's index.html")
        return folder


def without_effect(environment: Iterable[str]) -> list[str]:
    """Sentences on variables that start as the settings do and are none: most are misspelt."""
    known = [PREFIX + name.upper() for name in Settings.model_fields]
    told = []
    for name in sorted(environment):
        if not name.upper().startswith(PREFIX) or name.upper() in known:
            continue
        nearest = get_close_matches(name.upper(), known, n=1, cutoff=0.5)
        told.append(
            f"{name} is no setting and has no effect"
            + (f": did you mean {nearest[0]}?" if nearest else ".")
        )
    return told
