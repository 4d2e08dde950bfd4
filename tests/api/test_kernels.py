"""`/kernels.js`: the formulas as a script that any page may import."""

from fastapi import FastAPI

from app.optics.registry import default_registry
from app.snippets.kernels import kernels
from tests.api.raw import send


def test_is_a_script_that_is_asked_after_and_read_anywhere(app: FastAPI) -> None:
    answer = send(app, b"/kernels.js")
    assert answer.status == 200
    assert answer.body.decode() == kernels(default_registry())
    assert answer.headers["content-type"] == "text/javascript; charset=utf-8"
    assert answer.headers["cache-control"] == "no-cache"
    assert answer.headers["access-control-allow-origin"] == "*"
    again = send(app, b"/kernels.js", headers={"If-None-Match": answer.headers["etag"]})
    assert (again.status, again.body) == (304, b"")
    packed = send(app, b"/kernels.js", headers={"Accept-Encoding": "br"})
    assert packed.headers["content-encoding"] == "br"
    assert len(packed.body) < 12_000
    assert '"kernels.js"' in send(app, b"/sw.js").body.decode()
