use std::io::Read;
use std::os::unix::fs::symlink;

use axum::body::to_bytes;
use tempfile::TempDir;

use super::*;

type Open = fn(&Path) -> io::Result<File>;

/// The system's call, the fallback for other systems, and the non-blocking call.
const OPEN_FUNCTIONS: [Open; 3] = [open, open_checked, |path| open_cached(path).unwrap_or_else(|| open(path))];

/// A temporary folder, and its path without links.
fn folder() -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().canonicalize().unwrap();
    (folder, path)
}

async fn body(path: &Path, bytes: u64, part: Range<u64>) -> io::Result<Body> {
    Content::File(path.to_path_buf(), bytes).open().await?.1.body(part).await
}

#[tokio::test]
async fn parts_of_any_length_equal_the_file() {
    let (_folder, top) = folder();
    let path = top.join("file");
    let content: Vec<u8> = (0..3 * PIECE_BYTES + 7).map(|n| (n % 251) as u8).collect();
    fs::write(&path, &content).unwrap();
    let bytes = content.len() as u64;
    for part in
        [0..bytes, 0..0, 5..9, 0..PIECE_BYTES, 1..PIECE_BYTES + 1, PIECE_BYTES - 1..3 * PIECE_BYTES, bytes - 1..bytes]
    {
        let data = to_bytes(body(&path, bytes, part.clone()).await.unwrap(), usize::MAX).await.unwrap();
        assert!(data == content[part.start as usize..part.end as usize], "{part:?}");
    }
}

#[tokio::test]
async fn a_file_of_another_length_is_an_error() {
    let (_folder, top) = folder();
    let path = top.join("file");
    fs::write(&path, vec![1; 3 * PIECE_BYTES as usize]).unwrap();
    assert!(body(&path, 5, 0..5).await.is_err());
    let shortened = body(&path, 3 * PIECE_BYTES, 0..3 * PIECE_BYTES).await.unwrap();
    File::options().write(true).open(&path).unwrap().set_len(PIECE_BYTES + 5).unwrap();
    assert!(to_bytes(shortened, usize::MAX).await.is_err());
}

#[test]
fn files_are_opened_and_links_are_not_followed() {
    let (_folder, top) = folder();
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
    let (_folder, top) = folder();
    let path = top.join("pipe");
    let status = std::process::Command::new("mkfifo").arg(&path).status().unwrap();
    assert!(status.success());
    for open in OPEN_FUNCTIONS {
        assert!(!open(&path).unwrap().metadata().unwrap().is_file());
    }
}
