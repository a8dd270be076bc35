//! Bindings of `serve`.

use std::collections::HashMap;
use std::io;
use std::net::{IpAddr, SocketAddr};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use bytes::Bytes;
use nearfar_serve::demand::{self, Cache, Demand, Maker, Part, PartMaker, Place, Wanted};
use nearfar_serve::rooms;
use nearfar_serve::site::{Content, Document, Site, Sites};
use nearfar_serve::tls::{self, Identity};
use nearfar_serve::{self as serve, Router, ServerContent, Settings, log};
use pyo3::exceptions::{PyInterruptedError, PyOSError, PyValueError};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use pyo3::types::PyCFunction;

/// A server that runs in its own threads.
#[pyclass(frozen, module = "nearfar._core")]
pub struct Server(serve::Server);

/// Content of a document: bytes, the path and size of a file, or a function that returns bytes.
#[derive(FromPyObject)]
enum Source {
    Bytes(PyBackedBytes),
    File(PathBuf, u64),
    Read(Py<PyAny>),
}

/// Address, names of hosts (None for any), headers and allowed origin of all answers, files of the certificate and its
/// key, limits, and rooms.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct ServerArguments<'py> {
    address: (IpAddr, u16),
    hosts: Option<Vec<String>>,
    headers: Vec<(String, String)>,
    origin: Option<String>,
    certificate: Option<(PathBuf, PathBuf)>,
    limits: Bound<'py, PyAny>,
    rooms: Option<Bound<'py, PyAny>>,
}

/// Path below the site, media type, whether the name identifies the content, and the content.
type DocumentArguments = (String, String, bool, Source);

/// Maker of a site's regions: functions that begin a region and make its next part, the grid's spacing, and the
/// folder and size in bytes of the cache.
type OnDemand = (Py<PyAny>, Py<PyAny>, f64, Option<PathBuf>, u64);

#[pymethods]
impl Server {
    /// `sites` are names with their documents and the makers of regions on demand.
    #[new]
    fn new(
        py: Python<'_>,
        sites: Vec<(String, Vec<DocumentArguments>, Option<OnDemand>)>,
        settings: ServerArguments<'_>,
    ) -> PyResult<Self> {
        let ServerArguments { address: (host, port), hosts, headers, origin, certificate, limits, rooms } = settings;
        let (limits, region_limits) = self::limits(&limits)?;
        let site = |(name, documents, regions)| Ok((name, site(documents, regions, region_limits)?));
        let sites: PyResult<Sites> = sites.into_iter().map(site).collect();
        let headers: PyResult<_> = headers.into_iter().map(header).collect();
        let origin = origin.map(|origin| {
            let error = |_| PyValueError::new_err(format!("origin: expected an origin or *, got {origin:?}"));
            origin.parse().map_err(error)
        });
        let server_content = ServerContent {
            sites: sites?,
            hosts: hosts.map(|names| names.into_iter().collect()),
            headers: headers?,
            origin: origin.transpose()?,
            rooms: rooms.as_ref().map(self::rooms).transpose()?.map(Arc::new),
        };
        let settings =
            Settings { address: SocketAddr::new(host, port), limits, certificate, router: Router::new(server_content) };
        py.detach(|| serve::Server::start(settings)).map(Self).map_err(io_error_to_python)
    }

    #[getter]
    fn port(&self) -> u16 {
        self.0.address().port()
    }

    /// Stops the server; open responses may finish within the grace period.
    fn close(&self, py: Python<'_>) {
        py.detach(|| self.0.close());
    }
}

/// Reads fields of a struct from a Python object's attributes of the same names.
macro_rules! from_attributes {
    ($object:expr, $($type:ident)::+ { $($same:ident),* $(; $($field:ident: $value:expr),*)? }) => {
        $($type)::+ { $($same: $object.getattr(stringify!($same))?.extract()?,)* $($($field: $value,)*)? }
    };
}

/// Reads limits of connections and of regions on demand.
fn limits(limits: &Bound<'_, PyAny>) -> PyResult<(serve::Limits, demand::Limits)> {
    let connections = from_attributes!(limits, serve::Limits {
        connections, per_client, header_bytes;
        headers: seconds(limits, "header_seconds")?,
        silence: seconds(limits, "silent_seconds")?,
        grace: seconds(limits, "grace_seconds")?
    });
    let regions = from_attributes!(limits, demand::Limits {
        regions;
        workers: limits.getattr("threads")?.extract()?,
        per_client: limits.getattr("regions_per_client")?.extract()?,
        memory: limits.getattr("memory_bytes")?.extract()?
    });
    Ok((connections, regions))
}

/// Creates rooms from their settings: limits, the key's secret bytes, whether users need a token, whether pages may
/// exchange files, and whether users may connect by WebTransport.
fn rooms(settings: &Bound<'_, PyAny>) -> PyResult<rooms::Rooms> {
    let limits = from_attributes!(settings, rooms::Limits {
        rooms, users, sockets_per_client, rooms_per_client, message_bytes, queue_bytes, messages_per_second,
        bytes_per_second, said_bytes_per_second, poses_per_second;
        burst: seconds(settings, "burst_seconds")?,
        hello: seconds(settings, "hello_seconds")?,
        ping: seconds(settings, "ping_seconds")?,
        silence: seconds(settings, "silent_seconds")?,
        linger: seconds(settings, "linger_seconds")?
    });
    let secret: Option<PyBackedBytes> = settings.getattr("key")?.extract()?;
    let key = secret.map(|secret| rooms::Key::new(&secret)).transpose().map_err(PyValueError::new_err)?;
    let needs_token: bool = settings.getattr("needs_token")?.extract()?;
    let rooms = match key {
        Some(key) if !needs_token => rooms::Rooms::without_tokens(limits, key),
        key => rooms::Rooms::new(limits, key),
    };
    let mut rooms = rooms.map_err(PyValueError::new_err)?;
    rooms.peers = settings.getattr("peers")?.extract()?;
    rooms.datagrams = settings.getattr("datagrams")?.extract()?;
    Ok(rooms)
}

/// Creates a token for a room that expires at `ends`, in seconds since 1970; `number` must be unpredictable.
#[pyfunction]
pub fn room_token(room: &str, ends: u64, number: rooms::TokenNumber, key: PyBackedBytes) -> PyResult<String> {
    let key = rooms::Key::new(&key).map_err(PyValueError::new_err)?;
    Ok(key.token(room, ends, number))
}

/// SHA-256 of a certificate, its expiry in seconds since 1970, and its host names.
#[pyfunction]
pub fn certificate(certificate: PathBuf, key: PathBuf) -> PyResult<(String, i64, Vec<String>)> {
    let identity = Identity::read(&certificate, &key).map_err(PyValueError::new_err)?;
    Ok((identity.fingerprint, identity.ends, identity.names))
}

/// Generates a self-signed certificate for host names, and its key, both in PEM.
#[pyfunction]
pub fn self_signed(names: Vec<String>) -> PyResult<(String, String)> {
    tls::self_signed(names).map_err(PyValueError::new_err)
}

/// Starts logging events of at least a level to standard error; False if logging has already been started.
#[pyfunction]
pub fn begin_log(level: &str, as_json: bool) -> PyResult<bool> {
    let level = level.parse().map_err(|_| PyValueError::new_err(format!("level: expected a level, got {level:?}")))?;
    Ok(log::start(level, as_json))
}

fn site(documents: Vec<DocumentArguments>, regions: Option<OnDemand>, limits: demand::Limits) -> PyResult<Site> {
    let documents: HashMap<_, _> = documents.into_iter().map(document).collect();
    let Some((begin, next, grid, folder, bytes)) = regions else { return Ok(Site { documents, demand: None }) };
    let cache = folder.map(|folder| Cache::open(&folder, bytes)).transpose()?.flatten();
    let demand = Demand::start(Box::new(Regions { begin, next: Arc::new(next) }), grid, cache, limits)?;
    Ok(Site { documents, demand: Some(Arc::new(demand)) })
}

fn document((name, media, is_named, source): DocumentArguments) -> (String, Document) {
    let document = match source {
        Source::Bytes(data) if !is_named => Document::mutable(Bytes::from_owner(data), &media),
        Source::Bytes(data) => Document::immutable(&name, Content::Bytes(Bytes::from_owner(data)), &media),
        Source::File(path, bytes) => Document::immutable(&name, Content::File(path, bytes), &media),
        Source::Read(read) => Document::immutable(&name, Content::Elsewhere(Arc::new(move || call(&read))), &media),
    };
    (name, document)
}

/// Calls a Python function that returns bytes.
fn call(read: &Py<PyAny>) -> io::Result<Bytes> {
    Python::attach(|py| {
        let data = read.call0(py).and_then(|data| Ok(data.extract::<PyBackedBytes>(py)?));
        data.map(Bytes::from_owner).map_err(|error| io::Error::other(error_message(py, &error)))
    })
}

fn header((name, value): (String, String)) -> PyResult<(serve::HeaderName, serve::HeaderValue)> {
    let error = || PyValueError::new_err(format!("headers: expected a header of HTTP, got {name:?}"));
    Ok((name.parse().map_err(|_| error())?, value.parse().map_err(|_| error())?))
}

fn seconds(object: &Bound<'_, PyAny>, name: &str) -> PyResult<Duration> {
    let value = object.getattr(name)?.extract()?;
    Duration::try_from_secs_f64(value)
        .map_err(|_| PyValueError::new_err(format!("{name}: expected seconds, got {value}")))
}

/// Converts an error and keeps its number, by which Python recognises a port in use.
fn io_error_to_python(error: io::Error) -> PyErr {
    match error.raw_os_error() {
        Some(number) => PyOSError::new_err((number, error.to_string())),
        None if error.kind() == io::ErrorKind::InvalidInput => PyValueError::new_err(error.to_string()),
        None => error.into(),
    }
}

/// Maker of regions, implemented in Python.
struct Regions {
    begin: Py<PyAny>,
    next: Arc<Py<PyAny>>,
}

/// Maker of a region's parts, implemented in Python.
struct Region {
    parts: Py<PyAny>,
    next: Arc<Py<PyAny>>,
}

impl Maker for Regions {
    fn begin(&self, Place(center): Place) -> Result<Box<dyn PartMaker>, String> {
        Python::attach(|py| {
            let parts = self.begin.call1(py, (center.to_vec(),)).map_err(|error| error_message(py, &error))?;
            Ok(Box::new(Region { parts, next: Arc::clone(&self.next) }) as Box<dyn PartMaker>)
        })
    }
}

/// A part in Python's form.
#[derive(FromPyObject)]
struct PythonPart {
    stage: u8,
    line: PyBackedBytes,
    files: HashMap<String, PyBackedBytes>,
    next: Option<u8>,
}

impl PartMaker for Region {
    fn next(&mut self, is_wanted: &Wanted) -> Result<Part, String> {
        Python::attach(|py| {
            let is_wanted = Arc::clone(is_wanted);
            let check = PyCFunction::new_closure(py, None, None, move |_, _| {
                if is_wanted() { Ok(()) } else { Err(PyInterruptedError::new_err("nobody waits")) }
            });
            let part = check.and_then(|check| self.next.call1(py, (&self.parts, check)));
            let part = part.and_then(|part| part.extract::<PythonPart>(py));
            let PythonPart { stage, line, files, next } = part.map_err(|error| error_message(py, &error))?;
            let files = files.into_iter().map(|(name, data)| (name, Bytes::from_owner(data))).collect();
            Ok(Part { stage, line: Bytes::from_owner(line), files, next })
        })
    }
}

fn error_message(py: Python<'_>, error: &PyErr) -> String {
    let sentence = error.value(py).to_string();
    let name = error.get_type(py).name().map_or_else(|_| "an error".into(), |name| name.to_string());
    if error.is_instance_of::<PyValueError>(py) { sentence } else { format!("{name}: {sentence}") }
}
