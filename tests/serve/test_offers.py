"""Requests that offer another protocol, as Java's client does by default, are read as all others."""

import json
import shutil
import socket
import subprocess
from collections.abc import Callable, Iterator
from http.client import HTTPResponse
from pathlib import Path
from typing import Any

import pytest

from app.settings import Settings
from tests.api.wire import Address, served

PATIENCE_S = 30.0
BODY = json.dumps({"items": [{"n_t": 1.5}] * 50}).encode()
OFFERS = {
    "as Java": b"Connection: Upgrade, HTTP2-Settings\r\nUpgrade: h2c\r\nHTTP2-Settings: AAEAAEAA\r\n",
    "a web socket": b"Connection: keep-alive, Upgrade\r\nUpgrade: websocket\r\n",
    "in capitals": b"CONNECTION: UPGRADE\r\nUPGRADE: TLS/1.3\r\n",
}
JAVA = """
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse.BodyHandlers;

public class Post {
    public static void main(String[] given) throws Exception {
        HttpClient client = HttpClient.newHttpClient();
        for (int i = 0; i < 3; i++) {
            HttpRequest asked = HttpRequest.newBuilder(URI.create(given[0] + "/evaluate"))
                .header("Content-Type", "application/json")
                .POST(HttpRequest.BodyPublishers.ofString(given[1])).build();
            var answer = client.send(asked, BodyHandlers.ofString());
            System.out.println(answer.statusCode() + " " + answer.body());
        }
        var asked = HttpRequest.newBuilder(URI.create(given[0] + "/models/exact")).build();
        System.out.println(client.send(asked, BodyHandlers.ofString()).statusCode());
    }
}
"""


@pytest.fixture(scope="module", params=["h11", "httptools"])
def address(request: pytest.FixtureRequest) -> Iterator[Address]:
    with served(settings=Settings(http=request.param)) as where:
        yield where


def post(offer: bytes, body: bytes = BODY) -> bytes:
    head = b"POST /api/v1/evaluate HTTP/1.1\r\nHost: x\r\nContent-Type: application/json\r\n"
    return head + offer + b"Content-Length: %d\r\n\r\n" % len(body) + body


def post_in_chunks(offer: bytes) -> bytes:
    head, _, _ = post(offer).partition(b"Content-Length")
    return head + b"Transfer-Encoding: chunked\r\n\r\n%x\r\n%b\r\n0\r\n\r\n" % (len(BODY), BODY)


def answered(connection: socket.socket) -> tuple[int, Any]:
    answer = HTTPResponse(connection)
    answer.begin()
    return answer.status, json.loads(answer.read())


@pytest.mark.parametrize("offer", OFFERS)
@pytest.mark.parametrize("apart", [False, True])
def test_the_body_is_read_and_what_follows_is_in_step(
    address: Address, offer: str, apart: bool
) -> None:
    with socket.create_connection(address, PATIENCE_S) as connection:
        for _ in range(3):
            sent = post(OFFERS[offer])
            cut = sent.index(b"\r\n\r\n") + 4 if apart else len(sent)
            connection.sendall(sent[:cut])
            connection.sendall(sent[cut:])
            status, answer = answered(connection)
            assert (status, len(answer["results"]), answer["failed"]) == (200, 50, 0)
        connection.sendall(post(b""))
        assert answered(connection)[0] == 200


def test_a_get_with_an_offer_is_answered(address: Address) -> None:
    with socket.create_connection(address, PATIENCE_S) as connection:
        for _ in range(2):
            connection.sendall(
                b"GET /api/v1/models/exact HTTP/1.1\r\nHost: x\r\n" + OFFERS["as Java"] + b"\r\n"
            )
            assert answered(connection)[0] == 200


@pytest.mark.parametrize("posted", [post, post_in_chunks])
def test_an_offer_on_a_connection_in_use_loses_nothing_unsaid(
    address: Address, posted: Callable[[bytes], bytes]
) -> None:
    """Its body may be lost then; the client is told to send it again, on another connection."""
    with socket.create_connection(address, PATIENCE_S) as connection:
        connection.sendall(post(b""))
        assert answered(connection)[0] == 200
        connection.sendall(posted(OFFERS["as Java"]))
        status, answer = answered(connection)
        if status == 503:
            assert "send both again" in answer["detail"]
            assert connection.recv(1) == b""
        else:
            assert (status, len(answer["results"])) == (200, 50)


@pytest.mark.skipif(shutil.which("java") is None, reason="no Java")
def test_javas_own_client(address: Address, tmp_path: Path) -> None:
    source = tmp_path / "Post.java"
    source.write_text(JAVA, "utf-8")
    url = f"http://{address[0]}:{address[1]}/api/v1"
    command = ["java", str(source), url, BODY.decode()]
    ended = subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)
    assert ended.returncode == 0, ended.stderr
    *posted, got = ended.stdout.splitlines()
    assert got == "200"
    assert len(posted) == 3
    for line in posted:
        status, _, body = line.partition(" ")
        assert status == "200"
        assert len(json.loads(body)["results"]) == 50


@pytest.mark.skipif(shutil.which("curl") is None, reason="no curl")
def test_curls_offer_of_http_2(address: Address) -> None:
    url = f"http://{address[0]}:{address[1]}/api/v1/evaluate"
    command = ["curl", "--silent", "--http2", "--json", "@-", url, url]
    ended = subprocess.run(command, input=BODY, capture_output=True, check=False, timeout=60)
    assert ended.returncode == 0, ended.stderr
    first, second = ended.stdout.decode().replace("}{", "}\n{").splitlines()
    assert json.loads(first) == json.loads(second)
    assert json.loads(first)["failed"] == 0
