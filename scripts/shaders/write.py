"""Writes the morph for engines, in each language: `python -m scripts.shaders.write`."""

from __future__ import annotations

from pathlib import Path

from scripts.shaders.declarations import translate

CHECKOUT = Path(__file__).resolve().parents[2]
SOURCES = ("morph.wgsl", "world.wgsl")
"""Files in rust/gpu/src/shaders; each may call functions declared in previous ones."""

HEADER = """\
// The morph of nearfar in {language}: where the user is shown a point of the world. Licence: MIT or Apache-2.0.
// Written by `python -m scripts.shaders.write` from {sources}; docs/engines.md tells how to use it.
//
// Call nearfar_morph or nearfar_morph_cylinder in the vertex stage; and, if points are morphed by the cylinder,
// nearfar_range_cylinder where the far map's range is read. Their parameters:
//   p              a point of the world, any unit of length; y is up
//   user           the position U of the eye that the picture is for, same unit and axes; each eye has its own
//   center         the centre O of the reduction, from which the far map was baked, same unit and axes
//   r1, r2         radii of the near zone and of all geometry, same unit
//   strength       1; below it, near points move to where the centre sees them (0), so that they can appear smoothly
//   direction      a unit vector, in which the map is looked up
//   range          what the map holds there: the distance from the centre, same unit
"""


def source() -> str:
    """Return the WGSL for all languages."""
    texts = [(CHECKOUT / "rust" / "gpu" / "src" / "shaders" / name).read_text(encoding="utf-8") for name in SOURCES]
    return "\n".join(texts)


def files() -> dict[str, str]:
    """Return the texts of all files by their paths in the checkout."""
    wgsl = source()
    headers = {name: HEADER.format(language=name, sources=" and ".join(SOURCES)) for name in ("WGSL", "GLSL", "HLSL")}
    glsl = f"{headers['GLSL']}\n{translate(wgsl, 'glsl')}"
    hlsl = f"{headers['HLSL']}\n{translate(wgsl, 'hlsl')}"
    return {
        "docs/engines/morph.wgsl": f"{headers['WGSL']}\n{wgsl}",
        "docs/engines/morph.glsl": _once(glsl),
        "docs/engines/morph.hlsl": _once(hlsl),
        "web/src/shaders/morph.ts": _typescript(glsl),
    }


def _once(text: str) -> str:
    """Guard a text against multiple inclusion."""
    return f"#ifndef NEARFAR_MORPH\n#define NEARFAR_MORPH\n{text}\n#endif\n"


def _typescript(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace("`", "\\`").replace("${", "\\${")
    return (
        "// Written by `python -m scripts.shaders.write`.\n\n"
        "/** docs/engines/morph.glsl, for GLSL ES 3.00; the shader around it states the precision of float. */\n"
        f"export const MORPH = `\\\n{escaped}`;\n"
    )


def main() -> None:
    """Write every file."""
    for name, text in files().items():
        path = CHECKOUT / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
