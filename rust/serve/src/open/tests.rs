use std::io::Read;
use std::os::unix::fs::symlink;

use super::*;

type Open = fn(&Path) -> io::Result<File>;

/// The system's call, the fallback for other systems, and the non-blocking call.
const OPEN_FUNCTIONS: [Open; 3] = [open, open_checked, |path| open_now(path).unwrap_or_else(|| open(path))];

#[test]
fn files_are_opened_and_links_are_not_followed() {
    let folder = tempfile::tempdir().unwrap();
    let top = folder.path().canonicalize().unwrap();
    fs::create_dir_all(top.join("real/files")).unwrap();
    fs::write(top.join("real/files/a"), "content").unwrap();
    symlink(top.join("real/files/a"), top.join("real/files/link")).unwrap();
    symlink("real", top.join("above")).unwrap();
    for open in OPEN_FUNCTIONS {
        let mut text = String::new();
        open(&top.join("real/files/a")).unwrap().read_to_string(&mut text).unwrap();
        assert_eq!(text, "content");
        for refused in ["real/files/link", "above/files/a", "above/files/link", "real/files/none", "real/files/a/b"] {
            assert!(open(&top.join(refused)).is_err(), "{refused}");
        }
    }
}

#[test]
fn opening_a_pipe_does_not_block() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().canonicalize().unwrap().join("pipe");
    let made = std::process::Command::new("mkfifo").arg(&path).status().unwrap();
    assert!(made.success());
    for open in OPEN_FUNCTIONS {
        assert!(!open(&path).unwrap().metadata().unwrap().is_file());
    }
}
