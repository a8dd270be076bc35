//! Listens, and keeps connections within their limits until the server ends.

use std::convert::Infallible;
use std::io;
use std::net::SocketAddr;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::Duration;

use axum::http::Request;
use hyper::body::Incoming;
use hyper::service::service_fn;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::server::graceful::GracefulShutdown;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{OwnedSemaphorePermit, Semaphore, oneshot};
use tokio_io_timeout::TimeoutStream;

use crate::router::Router;

/// Pause after a connection could not be accepted, because the process has too many files open.
const PAUSE: Duration = Duration::from_millis(100);

/// How long and how many connections are kept.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Connections at the same time; others wait until one ends.
    pub connections: usize,
    /// Time for the headers of a request.
    pub headers: Duration,
    /// Time in which a client takes no byte of an answer.
    pub silence: Duration,
    /// Bytes of a request's headers.
    pub header_bytes: usize,
    /// Time that answers get to end when the server does.
    pub grace: Duration,
}

impl Default for Limits {
    fn default() -> Self {
        let seconds = Duration::from_secs;
        Limits {
            connections: 1024,
            headers: seconds(30),
            silence: seconds(60),
            header_bytes: 1 << 15,
            grace: seconds(3),
        }
    }
}

/// Where and how a server listens.
pub struct Settings {
    /// Address and port; 0 for any that is free.
    pub address: SocketAddr,
    /// Limits of connections.
    pub limits: Limits,
    /// Sites, and the names by which they may be asked for.
    pub router: Router,
}

/// A server that runs in threads of its own.
pub struct Server {
    address: SocketAddr,
    router: Arc<Router>,
    end: Mutex<Option<(oneshot::Sender<()>, JoinHandle<()>)>>,
}

impl Server {
    /// Listen and answer from now on.
    pub fn start(settings: Settings) -> io::Result<Self> {
        let Settings { address, limits, router } = settings;
        let runtime = tokio::runtime::Builder::new_multi_thread()
            .worker_threads(2)
            .thread_name("nearfar serve")
            .enable_all()
            .build()?;
        let listener = runtime.block_on(TcpListener::bind(address))?;
        let (address, router) = (listener.local_addr()?, Arc::new(router));
        let (end, ended) = oneshot::channel();
        let shared = Arc::clone(&router);
        let thread = std::thread::Builder::new().name("nearfar serve".into()).spawn(move || {
            runtime.block_on(listen(listener, shared, limits, ended));
            // Reads of files that hang are left alone.
            runtime.shutdown_timeout(limits.grace);
        })?;
        Ok(Server { address, router, end: Mutex::new(Some((end, thread))) })
    }

    /// The address that it listens at.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// Accept no more requests, let answers end within the grace, and stop.
    pub fn close(&self) {
        let ended = self.end.lock().unwrap_or_else(PoisonError::into_inner).take();
        // Who waits for a region is told first, so that those answers end.
        for demand in self.router.sites.values().filter_map(|site| site.demand.as_ref()) {
            demand.close();
        }
        if let Some((end, thread)) = ended {
            let _ = end.send(());
            let _ = thread.join();
        }
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        self.close();
    }
}

async fn listen(listener: TcpListener, router: Arc<Router>, limits: Limits, mut ended: oneshot::Receiver<()>) {
    let (open, graceful) = (Arc::new(Semaphore::new(limits.connections)), GracefulShutdown::new());
    loop {
        let accepted = tokio::select! {
            accepted = next(&listener, &open) => accepted,
            _ = &mut ended => break,
        };
        match accepted {
            Ok((stream, address, place)) => serve(stream, address, place, Arc::clone(&router), limits, &graceful),
            Err(error) => {
                tracing::warn!(%error, "a connection is not accepted");
                tokio::time::sleep(PAUSE).await;
            }
        }
    }
    drop(listener);
    let _ = tokio::time::timeout(limits.grace, graceful.shutdown()).await;
}

/// Wait for a place among the connections, then for one.
async fn next(
    listener: &TcpListener,
    open: &Arc<Semaphore>,
) -> io::Result<(TcpStream, SocketAddr, OwnedSemaphorePermit)> {
    let place = Arc::clone(open).acquire_owned().await.map_err(io::Error::other)?;
    let (stream, address) = listener.accept().await?;
    Ok((stream, address, place))
}

fn serve(
    stream: TcpStream,
    address: SocketAddr,
    place: OwnedSemaphorePermit,
    router: Arc<Router>,
    limits: Limits,
    graceful: &GracefulShutdown,
) {
    // Without it the end of a short answer waits for the client's acknowledgement.
    let _ = stream.set_nodelay(true);
    let mut stream = TimeoutStream::new(stream);
    // Not of reads: a client that waits for a long answer sends nothing.
    stream.set_write_timeout(Some(limits.silence));
    let answer = service_fn(move |request: Request<Incoming>| {
        let router = Arc::clone(&router);
        async move { Ok::<_, Infallible>(router.answer(address.ip(), request).await) }
    });
    let connection = hyper::server::conn::http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(limits.headers)
        .max_buf_size(limits.header_bytes)
        .serve_connection(TokioIo::new(Box::pin(stream)), answer);
    let connection = graceful.watch(connection);
    tokio::spawn(async move {
        if let Err(error) = connection.await {
            tracing::debug!(client = %address, %error, "a connection broke off");
        }
        drop(place);
    });
}
