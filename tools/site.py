# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the site in build/docs/ with mkdocs, from docs/ and the pages generated from the add-on and the package."""

import shutil

from tools.blender import NUMPY, run_with_addon
from tools.environment import BUILD, DEBIAN_VERSION, ROOT, run, run_quietly, say
from tools.libraries import PATTERN
from tools.package import venv_with_core

SITE_TOOLS = ("pdoc==16.0.0", "mkdocs==1.6.1", "mkdocs-material==9.8.2")
PAGES = BUILD / "pages"  # source folder of the pages, as in mkdocs.yml


def build_site() -> None:
    """Build the site. A broken link is an error."""
    shutil.rmtree(PAGES, ignore_errors=True)
    shutil.copytree(ROOT / "docs", PAGES, ignore=shutil.ignore_patterns("*.py", "*.css", "__pycache__"))
    python = venv_with_core("docs", DEBIAN_VERSION, *SITE_TOOLS, NUMPY[DEBIAN_VERSION], *PATTERN)
    run([python, "docs/write_reference.py", PAGES / "python" / "api"])
    run_with_addon("docs", ROOT / "docs" / "write_blender_pages.py", PAGES / "reference")
    run_quietly("building the site", [python, "-m", "mkdocs", "build", "--strict"])
    say("build/docs/index.html")
