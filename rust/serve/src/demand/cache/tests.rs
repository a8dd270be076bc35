use std::collections::BTreeMap;
use std::io::Read;
use std::time::Duration;

use super::*;

fn region(names: &[(&str, &str)]) -> HashMap<String, Bytes> {
    let mut content: HashMap<String, Bytes> =
        names.iter().map(|(name, data)| (format!("files/{name}"), Bytes::copy_from_slice(data.as_bytes()))).collect();
    let described: BTreeMap<&String, _> = content
        .iter()
        .map(|(name, data)| (name, serde_json::json!({"bytes": data.len(), "sha256": hash(data)})))
        .collect();
    let manifest = serde_json::to_vec(&serde_json::json!({ "files": described })).unwrap();
    content.insert(MANIFEST.into(), manifest.into());
    content
}

fn read(content: Option<Content>) -> Vec<u8> {
    let Some(Content::File(path, bytes)) = content else { panic!("no file") };
    let data = fs::read(path).unwrap();
    assert_eq!(data.len() as u64, bytes);
    data
}

fn open(folder: &Path, budget: u64) -> Cache {
    Cache::open(folder, budget).unwrap().expect("no other server uses it")
}

#[test]
fn a_folder_belongs_to_one_server_at_a_time() {
    let folder = tempfile::tempdir().unwrap();
    let first = open(folder.path(), 100);
    let path = folder.path().to_path_buf();
    let (sender, second) = std::sync::mpsc::channel();
    std::thread::spawn(move || sender.send(Cache::open(&path, 100).unwrap().is_none()));
    assert_eq!(second.recv_timeout(Duration::from_secs(60)), Ok(true), "the second server does not wait");
    drop(first);
    open(folder.path(), 100);
}

#[test]
fn a_folder_that_cannot_be_made_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("file/cache");
    fs::write(folder.path().join("file"), "").unwrap();
    let error = Cache::open(&path, 100).err().expect("a file is no folder").to_string();
    assert!(error.starts_with(&format!("{}: the cache cannot be opened: ", path.display())), "{error}");
}

#[test]
fn files_are_replaced_rather_than_overwritten() {
    let folder = tempfile::tempdir().unwrap();
    let cache = open(folder.path(), 1 << 20);
    let path = folder.path().join("files/a.glb");
    fs::write(&path, "earlier").unwrap();
    let mut reader = File::open(&path).unwrap();
    cache.store("1,2,3", &region(&[("a.glb", "geometry")])).unwrap();
    let mut content = String::new();
    reader.read_to_string(&mut content).unwrap();
    assert_eq!((content.as_str(), fs::read(&path).unwrap().as_slice()), ("earlier", &b"geometry"[..]));
}

#[test]
fn cached_regions_are_found_after_a_restart() {
    let folder = tempfile::tempdir().unwrap();
    let content = region(&[("a.glb", "geometry"), ("b.webp", "picture")]);
    let first = open(folder.path(), 1 << 20);
    assert!(first.find("1,2,3").is_none());
    first.store("1,2,3", &content).unwrap();
    drop(first);
    for _ in 0..2 {
        let cache = open(folder.path(), 1 << 20);
        assert_eq!(cache.find("1,2,3").unwrap(), content[MANIFEST]);
        assert_eq!(read(cache.file("files/a.glb")), b"geometry");
        assert!(cache.find("1,2,4").is_none());
        for name in ["files/c.glb", "a.glb", "../a.glb", "files/../at/x", "at/1,2,3.json"] {
            assert!(cache.file(name).is_none(), "{name}");
        }
    }
}

#[test]
fn regions_share_files_and_the_least_recently_used_are_evicted() {
    let folder = tempfile::tempdir().unwrap();
    let long = "x".repeat(1000);
    let both = region(&[("shared.bin", &long), ("own.glb", "first")]);
    let cache = open(folder.path(), 4000);
    cache.store("1,0,0", &both).unwrap();
    cache.store("2,0,0", &region(&[("shared.bin", &long), ("other.glb", "second")])).unwrap();
    assert!(cache.bytes() < 2000, "{}", cache.bytes());
    assert!(cache.find("1,0,0").is_some());
    // Over the budget: the second region is the least recently used one.
    cache.store("3,0,0", &region(&[("large.bin", &"y".repeat(2600))])).unwrap();
    assert!(cache.find("2,0,0").is_none() && cache.find("1,0,0").is_some() && cache.find("3,0,0").is_some());
    assert!(cache.file("files/other.glb").is_none() && cache.file("files/shared.bin").is_some());
    assert_eq!(fs::read_dir(folder.path().join("files")).unwrap().count(), 3);
    assert!(cache.bytes() <= 4000);
    // A smaller budget applies when the cache is opened.
    drop(cache);
    let cache = open(folder.path(), 100);
    assert_eq!((cache.bytes(), fs::read_dir(folder.path().join("files")).unwrap().count()), (0, 0));
}

#[test]
fn damaged_and_incomplete_regions_are_not_used() {
    let content = region(&[("a.glb", "geometry"), ("b.bin", "numbers")]);
    type Damage = fn(&Path);
    let damages: [(&str, Damage); 6] = [
        ("changed", |folder| fs::write(folder.join("files/a.glb"), "geometrx").unwrap()),
        ("shorter", |folder| fs::write(folder.join("files/a.glb"), "geo").unwrap()),
        ("missing", |folder| fs::remove_file(folder.join("files/b.bin")).unwrap()),
        ("a link", |folder| {
            fs::rename(folder.join("files/a.glb"), folder.join("elsewhere")).unwrap();
            std::os::unix::fs::symlink(folder.join("elsewhere"), folder.join("files/a.glb")).unwrap();
        }),
        ("manifest changed", |folder| {
            let path = fs::read_dir(folder.join("at")).unwrap().next().unwrap().unwrap().path();
            let text = fs::read_to_string(&path).unwrap();
            fs::write(path, text.replace("a.glb", "../../etc/passwd")).unwrap();
        }),
        ("no manifest", |folder| {
            let path = fs::read_dir(folder.join("at")).unwrap().next().unwrap().unwrap().path();
            fs::remove_file(path).unwrap();
        }),
    ];
    for (name, damage) in damages {
        let folder = tempfile::tempdir().unwrap();
        open(folder.path(), 1 << 20).store("1,2,3", &content).unwrap();
        fs::write(folder.path().join("files/half.glb.part"), "ha").unwrap();
        damage(folder.path());
        let cache = open(folder.path(), 1 << 20);
        assert!(cache.find("1,2,3").is_none(), "{name}");
        assert!(cache.file("files/a.glb").is_none() || name == "missing", "{name}");
        assert!(!folder.path().join("files/half.glb.part").exists(), "{name}");
        // A damaged region is made again, also if the damage happens while the server runs.
        cache.store("1,2,3", &content).unwrap();
        if !["changed", "manifest changed"].contains(&name) {
            damage(folder.path());
            assert!(cache.find("1,2,3").is_none(), "{name}");
            cache.store("1,2,3", &content).unwrap();
        }
        assert_eq!(cache.find("1,2,3").unwrap(), content[MANIFEST], "{name}");
    }
}

#[test]
fn names_that_leave_the_folder_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let cache = open(folder.path(), 1 << 20);
    for name in ["../x", "a/b", "..", ".", "", "a\0b", "/etc/passwd", "a\\b"] {
        let error = cache.store("1,2,3", &region(&[(name, "data")])).unwrap_err();
        assert_eq!(error.kind(), io::ErrorKind::InvalidData, "{name:?}");
    }
    let mut names: Vec<_> = fs::read_dir(folder.path()).unwrap().map(|found| found.unwrap().file_name()).collect();
    names.sort();
    assert_eq!(names, [PLACES, FILES, LOCK]);
}

#[test]
fn tilesets_of_regions_are_kept_apart() {
    let folder = tempfile::tempdir().unwrap();
    let texts = ["one", "another"];
    let content = texts.map(|text| {
        let tileset = serde_json::json!({"bytes": text.len(), "sha256": hash(text.as_bytes())});
        let manifest = serde_json::to_vec(&serde_json::json!({"files": {}, "tileset": tileset})).unwrap();
        HashMap::from([(MANIFEST.into(), manifest.into()), (TILESET.into(), Bytes::from_static(text.as_bytes()))])
    });
    for is_first_run in [true, false] {
        let cache = open(folder.path(), 1 << 20);
        for (place, (text, content)) in texts.iter().zip(&content).enumerate() {
            if is_first_run {
                cache.store(&format!("{place},0,0"), content).unwrap();
            }
            let manifest = cache.find(&format!("{place},0,0")).unwrap();
            assert_eq!(read(cache.tileset(&manifest)), text.as_bytes());
        }
        assert!(cache.tileset(&region(&[])[MANIFEST]).is_none());
    }
}

#[test]
fn a_region_that_the_disk_does_not_take_leaves_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let cache = open(folder.path(), 1 << 20);
    let content = region(&[("a.glb", "geometry"), ("b.bin", "numbers")]);
    // A folder in place of the file makes writing fail for every user, root included.
    fs::create_dir(folder.path().join("files/b.bin")).unwrap();
    cache.store("1,2,3", &content).unwrap_err();
    assert!(cache.find("1,2,3").is_none());
    assert!(!folder.path().join("files/a.glb").exists() && cache.bytes() == 0);
    fs::remove_dir(folder.path().join("files/b.bin")).unwrap();
    cache.store("1,2,3", &content).unwrap();
    assert!(cache.find("1,2,3").is_some());
}
