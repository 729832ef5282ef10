#!/usr/bin/env python3
"""Makes the page's service worker: the list of the page's files with their hashes, and then what it does with them.

  offline_files.py FOLDER SCRIPT NAME...

FOLDER is the page's, NAME... are its files, and SCRIPT is web/offline/service_worker.js, bundled or as it is. Writes
FOLDER/service_worker.js, whose first line is `const build = { id, files: { NAME: SHA-256 } };`. Browsers take a service worker
as new when a byte of it is: so a change of any file is a new version.
"""
import hashlib
import json
import sys
from pathlib import Path


def main(folder, script, *names):
    hashes = {name: hashlib.sha256((folder / name).read_bytes()).hexdigest() for name in sorted(map(str, names))}
    listed = json.dumps(hashes, separators=(",", ":"))
    # What the list says is the version, not the worker's own text: pages of the same files are the same.
    build = hashlib.sha256(listed.encode()).hexdigest()[:16]
    (folder / "service_worker.js").write_text(
        f'const build = {{ "id": "{build}", "files": {listed} }};\n{script.read_text(encoding="utf-8")}', encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    main(*map(Path, sys.argv[1:]))
