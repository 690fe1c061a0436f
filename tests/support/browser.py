# SPDX-License-Identifier: MIT
"""A page in headless Chromium: what it becomes once its script has run, on paper, and as a picture."""
import shutil
import subprocess
import tempfile

FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--disable-quic", "--no-first-run", "--disable-background-networking",
         "--disable-component-update", "--disable-sync", "--hide-scrollbars", "--enable-logging=stderr", "--virtual-time-budget=5000"]
DARK = ["--blink-settings=preferredColorScheme=0"]


def browser():
    return next((p for p in map(shutil.which, ("chromium", "chromium-browser", "google-chrome")) if p), None)


def run(folder, page, *arguments):
    """What the browser prints, and what it logs; its profile is new each time."""
    with tempfile.TemporaryDirectory(dir=folder) as profile:
        return subprocess.run([browser(), *FLAGS, "--user-data-dir=" + profile, *arguments, page.as_uri()],
                              capture_output=True, text=True, timeout=600, check=True)
