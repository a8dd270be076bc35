//! A server without a network: sites whose documents are known, beside files that nobody may see.

use std::collections::BTreeMap;
use std::fs;
use std::net::{IpAddr, Ipv4Addr};
use std::path::Path;
use std::sync::Arc;

use axum::body::{Bytes, to_bytes};
use axum::http::header::{CONTENT_LENGTH, HOST};
use axum::http::{HeaderMap, HeaderValue, Method, Request, StatusCode, Uri};
use nearfar_serve::demand::{Cache, Demand, Limits, Maker, Part, PartMaker, Place, Wanted};
use nearfar_serve::site::{Content, Document, Site, Sites};
use nearfar_serve::{Router, ServerContent};
use tokio::runtime::Runtime;

/// Content of files that no site lists; longer than what refusals repeat of a request.
const SECRET: &[u8] = b"nobody may see this, however it is asked for and whatever the headers say";
/// The name by which the server may be called.
pub const NAME: &str = "localhost";
/// Places farther out have no region.
const FARTHEST: f64 = 1e6;
const CLIENT: IpAddr = IpAddr::V4(Ipv4Addr::LOCALHOST);
/// Answers are shorter.
const MAX: usize = 1 << 20;

/// An answer whose body has come.
pub struct Answered {
    pub status: StatusCode,
    pub headers: HeaderMap,
    pub body: Bytes,
}

/// Several sites, or one that has all paths, in a folder with secrets around them.
pub struct Served {
    runtime: Runtime,
    router: Arc<Router>,
    /// Documents by their path without its leading slash.
    pub listed: BTreeMap<String, Vec<u8>>,
    /// Names of sites below the root.
    pub sites: &'static [&'static str],
    /// Path of the site that makes regions on demand.
    pub scene: &'static str,
}

impl Served {
    /// A folder of that name, below that of temporary files, is made anew.
    pub fn new(name: &str, is_single: bool) -> Self {
        let folder = std::env::temp_dir().join(format!("nearfar-fuzz-{name}"));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(folder.join("bundle/files")).expect("a folder for files");
        let secrets = ["secret", "bundle/secret", "bundle/files/secret", "bundle/files/longer.bin"];
        for secret in secrets {
            fs::write(folder.join(secret), SECRET).expect("a file is written");
        }
        let (in_memory, on_disk) = (in_memory(), on_disk(&folder.join("bundle")));
        let site = |documents: &[(&str, Document, Vec<u8>)]| Site {
            documents: documents.iter().map(|(name, document, _)| ((*name).to_owned(), document.clone())).collect(),
            demand: None,
        };
        let demand = Some(Arc::new(on_demand(&folder.join("regions"))));
        let (sites, scene): (Sites, _) = if is_single {
            ([(String::new(), Site { demand, ..site(&[in_memory.clone(), on_disk.clone()].concat()) })].into(), "")
        } else {
            let scene = Site { demand, ..Site::default() };
            let named = [("memory", site(&in_memory)), ("disk", site(&on_disk)), ("scene", scene)];
            (named.map(|(name, site)| (name.to_owned(), site)).into(), "scene/")
        };
        let content = |site: &str, documents: Vec<(&str, Document, Vec<u8>)>| -> Vec<(String, Vec<u8>)> {
            let site = if is_single { "" } else { site };
            documents.into_iter().map(|(name, _, content)| (format!("{site}{name}"), content)).collect()
        };
        let mut listed: BTreeMap<_, _> = content("memory/", in_memory).into_iter().collect();
        listed.extend(content("disk/", on_disk));
        listed.remove(&format!("{}files/longer.bin", if is_single { "" } else { "disk/" }));
        listed.insert("healthz".into(), b"200 OK: the server runs\n".to_vec());
        let hosts = Some([NAME.to_owned()].into());
        let router = Router::new(ServerContent { sites, hosts, headers: Vec::new(), origin: None, rooms: None });
        let runtime = tokio::runtime::Builder::new_current_thread().build().expect("a runtime");
        let names: &[&str] = if is_single { &[] } else { &["memory", "disk", "scene"] };
        Served { runtime, router: Arc::new(router), listed, sites: names, scene }
    }

    /// Ask, and see that no secret comes.
    pub fn ask(&self, method: Method, target: &Uri, headers: &HeaderMap) -> Answered {
        let mut request = Request::new(());
        *request.method_mut() = method;
        *request.uri_mut() = target.clone();
        *request.headers_mut() = headers.clone();
        request.headers_mut().entry(HOST).or_insert(HeaderValue::from_static(NAME));
        let (head, body) = self.runtime.block_on(async {
            let (head, body) = Arc::clone(&self.router).answer(CLIENT, request).await.into_parts();
            (head, to_bytes(body, MAX).await.expect("a body comes to its end"))
        });
        assert!(!body.windows(SECRET.len()).any(|part| part == SECRET), "a secret is told");
        Answered { status: head.status, headers: head.headers, body }
    }

    /// Ask, and see that HEAD gets the same without the body.
    pub fn ask_twice(&self, target: &Uri, headers: &HeaderMap) -> Answered {
        let found = self.ask(Method::GET, target, headers);
        let head = self.ask(Method::HEAD, target, headers);
        assert_eq!((head.status, &head.headers), (found.status, &found.headers));
        assert!(head.body.is_empty());
        if let Some(length) = found.headers.get(CONTENT_LENGTH) {
            assert_eq!(length.as_bytes(), found.body.len().to_string().as_bytes());
        }
        found
    }

    /// Whether a decoded path is one of a region, whose documents come and go: `files/part` and those of places.
    pub fn is_of_region(&self, path: &str) -> bool {
        let Some(path) = path.strip_prefix(self.scene) else { return false };
        let below = path.strip_prefix("at/").and_then(|rest| rest.split_once('/'));
        match below {
            None => path == "files/part",
            Some((place, name)) => {
                let numbers: Vec<f64> = place.split(',').filter_map(|text| text.parse().ok()).collect();
                let are_scenes = numbers.len() == 3 && numbers.iter().all(|number| number.abs() <= 1e12);
                are_scenes && ["parts", "manifest.json", "tileset.json", "files/part"].contains(&name)
            }
        }
    }
}

type Listed = Vec<(&'static str, Document, Vec<u8>)>;

/// Names that are decoded once, or not at all.
fn in_memory() -> Listed {
    let whole = |text: &str| text.as_bytes().to_vec();
    let changing = |text: &'static str| Document::mutable(Bytes::from_static(text.as_bytes()), "text/plain");
    let long = "long enough to be worth a compressed copy\n".repeat(100);
    let read = || Ok(Bytes::from_static(b"read elsewhere"));
    let elsewhere = Document::immutable("files/elsewhere", Content::Elsewhere(Arc::new(read)), "text/plain");
    vec![
        ("", changing("the page"), whole("the page")),
        ("page.js", changing("its script"), whole("its script")),
        ("files/%2e%2e", changing("percent signs"), whole("percent signs")),
        ("files/ü €", changing("other letters"), whole("other letters")),
        ("long.js", Document::mutable(long.clone().into(), "text/javascript"), long.into()),
        ("empty", changing(""), Vec::new()),
        ("files/elsewhere", elsewhere, whole("read elsewhere")),
    ]
}

/// The last file is longer than it is listed.
fn on_disk(folder: &Path) -> Listed {
    let content: Vec<u8> = (0..200).collect();
    fs::write(folder.join("files/a.bin"), &content).expect("a file is written");
    let file = |name: &'static str, bytes: u64| {
        let content = Content::File(folder.join(name), bytes);
        (name, Document::immutable(name, content, "application/octet-stream"))
    };
    let [(name, document), (longer, wrong)] = [file("files/a.bin", 200), file("files/longer.bin", 3)];
    vec![(name, document, content), (longer, wrong, Vec::new())]
}

fn on_demand(folder: &Path) -> Demand {
    let cache = Cache::open(folder, 1 << 14).expect("an empty folder");
    assert!(cache.is_some(), "another process uses {}", folder.display());
    let limits = Limits { memory: 1 << 14, ..Limits::default() };
    Demand::start(Box::new(Trivial), 2.0, cache, limits).expect("threads start")
}

/// Regions of one file.
struct Trivial;

struct Once(Place);

impl Maker for Trivial {
    fn begin(&self, place: Place) -> Result<Box<dyn PartMaker>, String> {
        if place.0[0].abs() > FARTHEST { Err("there is nothing".into()) } else { Ok(Box::new(Once(place))) }
    }
}

impl PartMaker for Once {
    fn next(&mut self, _: &Wanted) -> Result<Part, String> {
        const HASH: &str = "37a680133bd09342f934afb8dd2c7d9e1b624da5f35e3a38adb103e37c055ed1";
        let manifest = format!(
            "{{\"place\":\"{}\",\"files\":{{\"files/part\":{{\"bytes\":4,\"sha256\":\"{HASH}\"}}}}}}\n",
            self.0
        );
        let files =
            vec![("files/part".to_owned(), Bytes::from_static(b"part")), ("manifest.json".to_owned(), manifest.into())];
        Ok(Part { stage: 0, line: Bytes::from_static(b"{\"event\":\"end\"}\n"), files, next: None })
    }
}
