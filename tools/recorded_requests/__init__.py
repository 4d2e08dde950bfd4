"""Record what a server and its commands answer, and compare another build with that.

    python -m tools.recorded_requests record --url http://127.0.0.1:8000 --to FOLDER
    python -m tools.recorded_requests compare --url http://127.0.0.1:8000 --with FOLDER

`record-cli` and `compare-cli` do so with command lines. Kept outside CI: it is for changes that must
leave behavior as it is. Record from a server with FRESNEL_CACHE_BYTES=0, whose answers do not depend
on those before, and compare with one that has its cache.
"""
