"""Answers that are made once and sent in the encoding that each client asks for."""

from anyio import to_thread
from starlette.responses import Response
from starlette.types import Receive, Scope, Send

from app.http.body import EncodedBody


class Encoded(Response):
    """Bytes in the encoding that the client asks for; what takes long is made in a thread."""

    def __init__(self, encoded: EncodedBody) -> None:
        super().__init__()
        self._encoded = encoded

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Send them, or 304 to who has them."""
        coding = self._encoded.coding(scope["headers"])
        if self._encoded.takes_long(coding):
            await to_thread.run_sync(self._encoded.encoded, coding)
        self.status_code, self.raw_headers, self.body = self._encoded.reply(
            scope["headers"], coding
        )
        await super().__call__(scope, receive, send)
