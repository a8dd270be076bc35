use axum::body::to_bytes;

use super::*;

#[tokio::test]
async fn parts_of_any_length_equal_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().canonicalize().unwrap().join("file");
    let content: Vec<u8> = (0..3 * PIECE_BYTES + 7).map(|place| (place % 251) as u8).collect();
    std::fs::write(&path, &content).unwrap();
    let bytes = content.len() as u64;
    for part in
        [0..bytes, 0..0, 5..9, 0..PIECE_BYTES, 1..PIECE_BYTES + 1, PIECE_BYTES - 1..3 * PIECE_BYTES, bytes - 1..bytes]
    {
        let body = open(&path, bytes).await.unwrap().body(part.clone()).await.unwrap();
        let found = to_bytes(body, usize::MAX).await.unwrap();
        assert!(found == content[part.start as usize..part.end as usize], "{part:?}");
    }
}

#[tokio::test]
async fn a_file_that_becomes_shorter_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().canonicalize().unwrap().join("file");
    std::fs::write(&path, vec![1; 3 * PIECE_BYTES as usize]).unwrap();
    assert!(open(&path, 5).await.is_err());
    let body = open(&path, 3 * PIECE_BYTES).await.unwrap().body(0..3 * PIECE_BYTES).await.unwrap();
    std::fs::File::options().write(true).open(&path).unwrap().set_len(PIECE_BYTES + 5).unwrap();
    assert!(to_bytes(body, usize::MAX).await.is_err());
}
