"""Report of `nearfar reduce` as JSON and Markdown."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from nearfar._base import formats
from nearfar._reduce import default_radii
from nearfar.cli._output import bytes_text, count, metres, radii_text
from nearfar.cli._page import fill, table


def save(folder: Path, document: dict[str, Any]) -> None:
    """Write report.json and report.md."""
    formats.write_json(folder / "report.json", document)
    (folder / "report.md").write_text(markdown(document), encoding="utf-8")


def markdown(document: dict[str, Any]) -> str:
    """Format the report as Markdown."""
    share = 100.0 * document["triangles_left"] / max(document["triangles"], 1)
    differences = [
        [name, count(value["pixels"]), f"{100 * value['share']:.2f} %", f"{value['rmse']:.4f}"]
        for name, value in document["pictures"].items()
    ]
    notes = "".join(f"- {note}\n" for note in document["notes"])
    return fill(
        "reduce.md",
        source=document["source"],
        unit_note=f"Note: {document['unit_note']}.\n\n" if document["unit_note"] else "",
        triangles=count(document["triangles"]),
        triangles_left=count(document["triangles_left"]),
        share=f"{share:.3g}",
        face_size=document["face_size"],
        map_bytes=bytes_text(document["map_bytes"]),
        findings="".join(f"**Note:** {note}.\n\n" for note in document["findings"]),
        center=metres(document["center"]),
        user=metres(document["user"]),
        radii=radii_text(document),
        differences=table(["picture", "pixels that differ from the truth", "share", "RMSE"], *differences),
        published=_on_published(document),
        load_curve=table(*load_curve_rows(document)),
        plot="![load curve](load_curve.png)\n\n" if "load_curve.png" in document["files"] else "",
        times=table(*time_rows(document)),
        notes=f"\nNot drawn as in the file:\n\n{notes}" if notes else "",
        generator=document["generator"],
    )


def load_curve_rows(document: dict[str, Any]) -> list[list[str]]:
    """Return the table of the load curve, header first."""
    rows = ([f"{entry['radius']:g} m", count(entry["triangles"])] for entry in document["load_curve"])
    return [["within", "triangles"], *rows]


def time_rows(document: dict[str, Any]) -> list[list[str]]:
    """Return the table of the time of each step, header first."""
    return [["step", "seconds"], *([name, f"{value:.2f}"] for name, value in document["seconds"].items())]


def _on_published(document: dict[str, Any]) -> str:
    if "published" not in document["pictures"]:
        return ""
    wide, narrow = default_radii.PUBLISHED * document["r2"], document["r1"]
    return (
        f"The last picture has r1 = {wide:g} m, the published ratio to r2: it shears the ground more than {narrow:g} m."
        "\n\n"
    )
