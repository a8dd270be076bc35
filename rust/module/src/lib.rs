//! The extension module `nearfar._core`. Its only content is the bindings, which are a crate of their own because cargo
//! compiles a library beside the crates that it uses, but a shared library after them.

use nearfar_py as _;
