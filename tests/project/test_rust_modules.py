"""Tests of the parser of Rust imports, on a made-up crate with every kind of cycle."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.support.graphs import cycles
from tests.support.rust_modules import file_graph


def crate(folder: Path, files: dict[str, str]) -> dict[str, set[str]]:
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return file_graph(folder)


# One stage whose mod.rs only declares and re-exports, and one whose mod.rs contains code.
BASE = {
    "lib.rs": "//! Doc.\npub mod shapes;\npub mod walk;\n",
    "shapes/mod.rs": "//! Doc.\nmod cube;\nmod ball;\npub use ball::Ball;\npub use cube::{Cube as Box6, volume};\n",
    "shapes/cube.rs": "pub struct Cube;\npub fn volume() -> f64 { 1.0 }\n",
    "shapes/ball.rs": "pub struct Ball;\nimpl Ball { pub fn new() -> Self { Self } }\n",
    "walk.rs": "use crate::shapes::{self, Box6};\nfn f() { shapes::Ball::new(); }\n",
}


def test_imports_count_to_the_file_that_defines_the_name(tmp_path: Path) -> None:
    graph = crate(tmp_path, BASE)
    assert graph == {"shapes/cube.rs": set(), "shapes/ball.rs": set(), "walk.rs": {"shapes/cube.rs", "shapes/ball.rs"}}
    assert cycles(graph) == []


CYCLES: dict[str, tuple[dict[str, str], list[str]]] = {
    "a plain one": (
        {
            "shapes/cube.rs": "use super::ball::Ball;\npub struct Cube;\npub fn volume() {}\n",
            "shapes/ball.rs": "use super::cube::Cube;\npub struct Ball;\n",
        },
        ["shapes/ball.rs", "shapes/cube.rs"],
    ),
    "through a re-export and another name": (
        {"shapes/ball.rs": "use crate::{walk, shapes::{Box6}};\npub struct Ball(Box6);\nfn f() { walk::step() }\n"},
        ["shapes/ball.rs", "walk.rs"],
    ),
    "by a path within a function": (
        {"shapes/cube.rs": "pub struct Cube;\npub fn volume() -> f64 { crate::walk::step::<f64>() }\n"},
        ["shapes/cube.rs", "walk.rs"],
    ),
    "by an import within a function": (
        {"shapes/cube.rs": "pub struct Cube;\npub fn volume() { use crate::walk::step; step() }\n"},
        ["shapes/cube.rs", "walk.rs"],
    ),
    "by a sibling module and a name in it": (
        {
            "shapes/cube.rs": "use super::ball;\npub struct Cube;\npub fn volume() { ball::f() }\n",
            "shapes/ball.rs": "pub struct Ball;\npub fn f() { super::cube::volume() }\n",
        },
        ["shapes/ball.rs", "shapes/cube.rs"],
    ),
    "through a mod.rs that computes": (
        {
            "shapes/mod.rs": "mod cube;\nmod ball;\npub use ball::Ball;\npub use cube::Cube as Box6;\n"
            "pub const EDGE: f64 = 1.0;\nfn all() { cube::volume() }\n",
            "shapes/cube.rs": "use super::EDGE;\npub struct Cube;\npub fn volume() {}\n",
        },
        ["shapes/cube.rs", "shapes/mod.rs"],
    ),
    "through a chain of re-exports": (
        {
            "lib.rs": "pub mod shapes;\npub mod walk;\npub use shapes::Round;\n",
            "shapes/mod.rs": "mod cube;\nmod ball;\npub use self::ball::Ball as Round;\n"
            "pub use {ball::Ball, cube::Cube as Box6};\n",
            "walk.rs": "use crate::Round;\npub fn step() {}\n",
            "shapes/ball.rs": "pub struct Ball;\nfn f() { super::super::walk::step() }\n",
        },
        ["shapes/ball.rs", "walk.rs"],
    ),
    "by a glob import": (
        {
            "walk.rs": "use crate::shapes::*;\npub fn step(_: Ball) {}\n",
            "shapes/ball.rs": "use crate::walk::*;\npub struct Ball;\nfn f() { step(Ball) }\n",
        },
        ["shapes/ball.rs", "walk.rs"],
    ),
    "through a glob re-export": (
        {
            "shapes/mod.rs": "mod cube;\nmod ball;\npub use ball::*;\npub use cube::Cube as Box6;\n",
            "shapes/ball.rs": "pub struct Ball;\nfn f() { crate::walk::step() }\n",
        },
        ["shapes/ball.rs", "walk.rs"],
    ),
    "by a macro's path, and a macro in scope": (
        {
            "lib.rs": "#[macro_use]\nmod wide;\npub mod shapes;\npub mod walk;\n",
            "wide.rs": "macro_rules! wide { ($a:ident) => { $crate::walk::step() } }\n",
            "walk.rs": "pub fn step() { wide! { x } }\n",
        },
        ["walk.rs", "wide.rs"],
    ),
    "by a function that a macro makes": (
        {
            "walk.rs": "use crate::shapes::Ball;\nmacro_rules! two { ($f:ident) => { fn $f() {} } }\n"
            "two! { fn step(n: usize) -> f64 = step_all; }\npub struct Step;\n",
            "shapes/ball.rs": "use crate::walk::step;\npub struct Ball;\n",
        },
        ["shapes/ball.rs", "walk.rs"],
    ),
    "in a module within braces": (
        {
            "walk.rs": "mod inner { use crate::shapes::Ball; pub fn step() {} }\npub use inner::step;\n",
            "shapes/ball.rs": "use crate::walk::step;\npub struct Ball;\n",
        },
        ["shapes/ball.rs", "walk.rs"],
    ),
    "of three files in nested folders": (
        {
            "shapes/mod.rs": "mod ball;\nmod cube;\nmod flat;\npub use ball::Ball;\npub use cube::Cube as Box6;\n"
            "pub use flat::Square;\n",
            "shapes/flat/mod.rs": "mod square;\npub use square::Square;\n",
            "shapes/flat/square.rs": "use super::super::ball::Ball;\npub struct Square(Ball);\n",
            "shapes/ball.rs": "use super::cube::Cube;\npub struct Ball;\n",
            "shapes/cube.rs": "pub struct Cube;\npub fn volume(_: super::Square) {}\n",
        },
        ["shapes/ball.rs", "shapes/cube.rs", "shapes/flat/square.rs"],
    ),
}


@pytest.mark.parametrize("name", CYCLES)
def test_cycles_are_found(tmp_path: Path, name: str) -> None:
    files, expected = CYCLES[name]
    assert cycles(crate(tmp_path, BASE | files)) == [expected]


INNOCENT = {
    "tests": "pub struct Ball;\n#[cfg(test)]\nmod tests { use crate::walk::step; #[test] fn f() { step() } }\n",
    "what is for fuzzing alone": "#[cfg(any(test, fuzzing))]\npub mod trial;\npub struct Ball;\n",
    "imports for tests alone": "#[cfg(test)]\nuse crate::walk::step;\npub struct Ball;\n",
    "comments and strings": "pub struct Ball; // crate::walk::step\n"
    '/* use crate::walk; */ const S: &str = "crate::walk::f";\n',
    "names of other crates": "use std::fmt;\nuse walk::step;\npub struct Ball;\n"
    "fn f<'a>(c: &'a str) { fmt::walk('{', b'}') }\n",
}


@pytest.mark.parametrize("name", INNOCENT)
def test_tests_comments_and_other_crates_make_no_cycle(tmp_path: Path, name: str) -> None:
    assert cycles(crate(tmp_path, BASE | {"shapes/ball.rs": INNOCENT[name]})) == []


def test_the_graph_of_a_program_starts_at_main(tmp_path: Path) -> None:
    main = {"main.rs": "mod one;\nconst N: u8 = 1;\nfn main() { one::f() }\n", "one.rs": "pub fn f() { crate::N; }\n"}
    assert cycles(crate(tmp_path, main)) == [["main.rs", "one.rs"]]


def test_a_mod_file_with_an_item_is_a_node_of_the_graph(tmp_path: Path) -> None:
    computing = BASE["shapes/mod.rs"] + "pub const EDGE: f64 = 1.0;\n"
    assert "shapes/mod.rs" in crate(tmp_path / "computing", BASE | {"shapes/mod.rs": computing})
    assert "shapes/mod.rs" not in crate(tmp_path / "declaring", BASE)
