"""Index page that lists the sites of a server."""

from __future__ import annotations

import html
from collections.abc import Mapping
from urllib.parse import quote

_STYLE = """
:root { color-scheme: light dark; font: 16px/1.5 system-ui, sans-serif }
body { max-width: 44rem; margin: 0 auto; padding: 2rem 1rem }
h1 { font-size: 1.4rem; font-weight: 600 }
ul { list-style: none; padding: 0; display: grid; gap: .75rem }
a { display: block; padding: .9rem 1.1rem; border: 1px solid color-mix(in srgb, currentcolor 25%, transparent);
    border-radius: .6rem; color: inherit; text-decoration: none; overflow-wrap: anywhere }
a:hover, a:focus-visible { border-color: #3b7ddd; outline: 2px solid #3b7ddd; outline-offset: 1px }
strong { display: block }
span { opacity: .75 }
"""


def index(titles: Mapping[str, str]) -> dict[str, bytes]:
    """Return the page's documents: links to the sites with their titles."""
    items = "\n".join(
        f'<li><a href="{html.escape(quote(name, safe=""))}/"><strong>{html.escape(name)}</strong>'
        f"<span>{html.escape(title)}</span></a></li>"
        for name, title in sorted(titles.items())
    )
    page = (
        '<!doctype html>\n<html lang="en">\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n<title>Scenes</title>\n'
        '<link rel="icon" href="data:,">\n<link rel="stylesheet" href="index.css">\n'
        f"<h1>Scenes</h1>\n<ul>\n{items}\n</ul>\n</html>\n"
    )
    return {"index.html": page.encode(), "index.css": _STYLE.strip().encode()}
