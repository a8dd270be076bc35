"""Cards that show objects in notebooks: HTML and SVG in the page's colours, without scripts, style sheets and links."""

from __future__ import annotations

import base64
import functools
import html
import io
import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from PIL import Image

Kind = TypeVar("Kind")

COLORS = ("#2f7fc1", "#c8701a", "#2f9457", "#c2504e", "#8a68c0", "#94705a", "#b8579a", "#7a7a7a")
"""Colours of curves and areas, of medium brightness: readable on white and on black."""

MAX_PIXELS = 640
"""Greatest width and height of an embedded picture in pixels; larger ones are scaled down."""

MIN_PIXELS = 160
"""Pictures are enlarged by an integer factor until about this wide."""

PLOT = (420, 250)
"""Width and height of a plot, in pixels where the page has room for it."""

_MARGINS = (58, 12, 12, 44)
"""Left, right, upper and lower margin of a plot."""


def repr_html(make: Callable[[Kind], str]) -> Callable[[Kind], str]:
    """Make a `_repr_html_` that falls back to the object's `repr` if making the card fails.

    An exception in the display would hide the object, and damaged objects must be visible most of all.
    """

    @functools.wraps(make)
    def safe(self: Kind) -> str:
        try:
            return make(self)
        except Exception:
            import logging

            logging.getLogger("nearfar").debug("no card for a %s", type(self).__name__, exc_info=True)
            return f"<pre>{html.escape(plain(self))}</pre>"

    return safe


def repr_png(make: Callable[[Kind], NDArray[np.uint8]]) -> Callable[[Kind], bytes | None]:
    """Make a `_repr_png_` from pixels (H, W, 3 or 4); None on failure, so that the object's `repr` is shown."""

    @functools.wraps(make)
    def safe(self: Kind) -> bytes | None:
        try:
            return png(make(self))
        except Exception:
            return None

    return safe


def plain(value: object) -> str:
    """Return an object's `repr`, or its class if that fails too."""
    try:
        return repr(value)
    except Exception:
        return f"<{type(value).__module__}.{type(value).__qualname__}, damaged>"


def page(title: str, facts: Iterable[tuple[str, str]], *parts: str, notes: Sequence[str] = ()) -> str:
    """Assemble a card: a title, parts in HTML, a table of facts, and notes.

    Title, facts and notes are plain text, which is escaped.
    """
    items = "".join(f"<li>{html.escape(note)}</li>" for note in notes)
    note_list = f'<ul style="margin:.4em 0 0;padding-left:1.2em;opacity:.8">{items}</ul>' if items else ""
    return (
        f'<div style="max-width:62em"><div style="margin-bottom:.4em;overflow-wrap:anywhere"><b>{html.escape(title)}'
        f'</b></div><div style="display:flex;flex-wrap:wrap;gap:.6em 1.5em;align-items:flex-start">'
        f"{''.join(parts)}{table(facts)}</div>{note_list}</div>"
    )


def table(rows: Iterable[Sequence[str]], header: Sequence[str] = ()) -> str:
    """Make a table of plain text: rows of two are names and values, longer rows are columns of numbers."""
    # Notebooks have styles for tables, which each cell must override.
    cell = "padding:.1em 1em .1em 0;vertical-align:top;background:none;line-height:1.45;"
    lines = []
    for number, row in enumerate([header, *rows] if header else rows):
        is_head, cells = bool(header) and number == 0, []
        for column, text in enumerate(row):
            is_name = is_head or (len(row) == 2 and column == 0)
            name_style = "opacity:.75;font-weight:normal;" if is_name else ""
            side = "right" if len(row) > 2 else "left"
            wrap = "white-space:nowrap;" if len(row) > 2 else "overflow-wrap:break-word;"
            tag = "th" if name_style else "td"
            cells.append(f'<{tag} style="{cell}{name_style}{wrap}text-align:{side}">{html.escape(text)}</{tag}>')
        lines.append(f'<tr style="background:none">{"".join(cells)}</tr>')
    if not lines:
        return ""
    style = "border-collapse:collapse;margin:0;font-variant-numeric:tabular-nums"
    return f'<div style="overflow-x:auto;max-width:100%"><table style="{style}">{"".join(lines)}</table></div>'


def picture(pixels: NDArray[np.uint8], alt: str, caption: str = "", legend: Iterable[tuple[str, str]] = ()) -> str:
    """Embed a picture (H, W, 3 or 4), with a caption and a legend of pairs of a colour and its meaning."""
    image = _fit_to_page(pixels)
    data = base64.b64encode(_encoded(image)).decode("ascii")
    return (
        f'<figure style="margin:0;width:{image.width}px;max-width:100%">'
        f'<img style="display:block;width:100%;height:auto" '
        f'alt="{html.escape(alt, quote=True)}" src="data:image/png;base64,{data}">{_caption(caption, legend)}</figure>'
    )


def _caption(text: str, legend: Iterable[tuple[str, str]]) -> str:
    keys = " ".join(
        f'<span style="white-space:nowrap"><span style="color:{color}">&#9632;</span> {html.escape(meaning)}</span>'
        for color, meaning in legend
    )
    return f'<figcaption style="opacity:.8;font-size:.9em">{html.escape(text)} {keys}</figcaption>'


def png(pixels: NDArray[np.uint8]) -> bytes:
    """Encode a picture (H, W, 3 or 4) as PNG, scaled to a size that suits pages."""
    return _encoded(_fit_to_page(pixels))


def _fit_to_page(pixels: NDArray[np.uint8]) -> Image.Image:
    from PIL import Image

    image = Image.fromarray(np.ascontiguousarray(pixels))
    image.thumbnail((MAX_PIXELS, MAX_PIXELS), Image.Resampling.BOX)
    if (factor := MIN_PIXELS // max(image.size)) > 1:
        image = image.resize((image.width * factor, image.height * factor), Image.Resampling.NEAREST)
    return image


def _encoded(image: Image.Image) -> bytes:
    buffer = io.BytesIO()
    image.save(buffer, format="PNG")
    return buffer.getvalue()


def subsample(image: NDArray[Any]) -> NDArray[Any]:
    """Subsample an image (H, W, …) to at most twice the embedded size."""
    step = max(1, math.ceil(max(image.shape[:2]) / (2 * MAX_PIXELS)))
    return image[::step, ::step]


@dataclass(frozen=True, eq=False)
class Line:
    """A curve of a plot, and the points that it was fitted to."""

    x: NDArray[np.float64]
    y: NDArray[np.float64]
    label: str = ""
    points: tuple[NDArray[np.float64], NDArray[np.float64]] | None = None


def plot(lines: Sequence[Line], x_label: str, y_label: str, *, log_y: bool = False) -> str:
    """Draw curves over a logarithmic x axis as SVG; values that the axes cannot show are left out."""
    every_x = np.concatenate([line.x for line in lines])
    every_y = np.concatenate([part for line in lines for part in (line.y, *(line.points or ())[1:])])
    x = _Axis.spanning(every_x, True, _MARGINS[0], PLOT[0] - _MARGINS[1])
    y = _Axis.spanning(every_y, log_y, PLOT[1] - _MARGINS[3], _MARGINS[2])
    grid, middle, foot = [], (x.start + x.end) / 2, PLOT[1] - _MARGINS[3]
    for value, text in x.ticks():
        grid.append(f'<path d="M{x(value):.1f} {y.start}V{y.end}" stroke="currentColor" stroke-opacity=".15"/>')
        grid.append(_text(float(x(value)), foot + 15, text))
    for value, text in y.ticks():
        grid.append(f'<path d="M{x.start} {y(value):.1f}H{x.end}" stroke="currentColor" stroke-opacity=".15"/>')
        grid.append(_text(x.start - 5, float(y(value)) + 4, text, anchor="end"))
    grid += [
        _text(middle, foot + 34, x_label),
        _text(0, 0, y_label, f' transform="translate(12 {foot / 2}) rotate(-90)"'),
    ]
    elements = []
    for number, line in enumerate(lines):
        color = COLORS[number % len(COLORS)]
        track = " ".join(f"{a:.1f},{b:.1f}" for a, b in _positions(x, y, line.x, line.y))
        elements.append(f'<polyline points="{track}" fill="none" stroke="{color}" stroke-width="2"/>')
        if line.points is not None:
            elements += [
                f'<circle cx="{a:.1f}" cy="{b:.1f}" r="2" fill="{color}"/>' for a, b in _positions(x, y, *line.points)
            ]
    legend = [(COLORS[number % len(COLORS)], line.label) for number, line in enumerate(lines) if line.label]
    return svg(PLOT, "".join(grid + elements), f"{y_label} over {x_label}", legend)


def svg(size: tuple[int, int], content: str, alt: str, legend: Iterable[tuple[str, str]] = ()) -> str:
    """Wrap SVG elements in a figure that shrinks with the page and inherits its text colour."""
    return (
        f'<figure style="margin:0;width:{size[0]}px;max-width:100%"><svg viewBox="0 0 {size[0]} {size[1]}" '
        f'style="display:block;width:100%;height:auto" role="img" aria-label="{html.escape(alt, quote=True)}" '
        f'font-family="sans-serif" font-size="12" fill="none">{content}</svg>'
        f"{_caption('', legend)}</figure>"
    )


def length(metres: float) -> str:
    """Format a length without its unit: four digits, or whole metres."""
    return f"{metres:,.4g}" if abs(metres) < 1000.0 else f"{metres:,.0f}"


def point(position: Iterable[float]) -> str:
    """Format a position in metres."""
    return ", ".join(length(value) for value in position) + " m"


def _text(x: float, y: float, text: str, more: str = "", anchor: str = "middle") -> str:
    attributes = f'x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"'
    return f'<text {attributes} fill="currentColor" fill-opacity=".85"{more}>{html.escape(text)}</text>'


@dataclass(frozen=True)
class _Axis:
    low: float
    high: float
    is_log: bool
    start: float
    end: float

    @classmethod
    def spanning(cls, values: NDArray[np.float64], is_log: bool, start: float, end: float) -> _Axis:
        """Make the axis that shows all values, except values that are not finite or have no logarithm."""
        visible = values[np.isfinite(values) & (values > 0.0)] if is_log else values[np.isfinite(values)]
        low, high = (float(visible.min()), float(visible.max())) if visible.size else (1.0, 10.0)
        if high <= low:
            low, high = (low / 2.0, high * 2.0) if is_log else (low - 0.5, high + 0.5)
        return cls(low, high, is_log, start, end)

    def __call__(self, value: Any) -> Any:
        scale = np.log10 if self.is_log else np.asarray
        with np.errstate(divide="ignore", invalid="ignore"):
            fraction = (scale(value) - scale(self.low)) / (scale(self.high) - scale(self.low))
        return self.start + fraction * (self.end - self.start)

    def ticks(self) -> list[tuple[float, str]]:
        """Return two to seven tick values, round ones if possible, with their texts."""
        if self.is_log:
            low, high = math.ceil(math.log10(self.low) - 1e-9), math.floor(math.log10(self.high) + 1e-9)
            if high > low:
                powers_per_tick = max(1, math.ceil((high - low) / 6))
                return [(10.0**power, _short(10.0**power)) for power in range(low, high + 1, powers_per_tick)]
            return [(value, _short(value)) for value in (self.low, self.high)]
        min_step = (self.high - self.low) / 5.0
        unit = 10.0 ** math.floor(math.log10(min_step))
        step = next(unit * factor for factor in (1.0, 2.0, 5.0, 10.0) if unit * factor >= min_step)
        first = math.ceil(self.low / step - 1e-9)
        return [(n * step, f"{n * step:.3g}") for n in range(first, math.floor(self.high / step + 1e-9) + 1)]


def _short(value: float) -> str:
    for limit, letter in ((1e9, "G"), (1e6, "M"), (1e3, "k")):
        if value >= limit:
            return f"{value / limit:.3g}{letter}"
    return f"{value:.3g}"


def _positions(x: _Axis, y: _Axis, x_values: Any, y_values: Any) -> list[tuple[float, float]]:
    pairs = np.stack([x(np.asarray(x_values, np.float64)), y(np.asarray(y_values, np.float64))], axis=-1)
    return [(a, b) for a, b in pairs[np.isfinite(pairs).all(axis=-1)].tolist()]
