//! Server: listens, and limits the number of connections, until shutdown.

use std::io;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::Arc;
use std::thread::JoinHandle;
use std::time::Duration;

use parking_lot::Mutex;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{OwnedSemaphorePermit, oneshot, watch};
use tokio_rustls::TlsAcceptor;

use crate::clients::{Gate, Limits};
use crate::connection::{self, Shared};
use crate::offer::Offer;
use crate::quic;
use crate::rooms::Datagrams;
use crate::router::Router;
use crate::tls::CurrentCertificate;

/// Pause after a connection could not be accepted, for example because the process has too many open files.
const RETRY_PAUSE: Duration = Duration::from_millis(100);
/// Interval at which a certificate's files are checked.
const CHECK_INTERVAL: Duration = Duration::from_secs(60);

/// Settings of a server.
pub struct Settings {
    /// Address and port; port 0 for any free one.
    pub address: SocketAddr,
    /// Limits on connections.
    pub limits: Limits,
    /// PEM files of a certificate and its key; none for unencrypted connections.
    pub certificate: Option<(PathBuf, PathBuf)>,
    /// Router with the sites and the accepted host names.
    pub router: Router,
}

/// A server that runs in its own threads.
pub struct Server {
    address: SocketAddr,
    router: Arc<Router>,
    end: Mutex<Option<(oneshot::Sender<()>, JoinHandle<()>)>>,
}

impl Server {
    /// Starts listening.
    pub fn start(settings: Settings) -> io::Result<Self> {
        let Settings { address, limits, certificate, router } = settings;
        let invalid = |reason: String| io::Error::new(io::ErrorKind::InvalidInput, reason);
        let current = certificate.map(|(certificate, key)| CurrentCertificate::read(certificate, key)).transpose();
        let current = current.map_err(invalid)?;
        let tls = current.as_ref().map(CurrentCertificate::config).transpose().map_err(invalid)?.map(TlsAcceptor::from);
        let runtime = tokio::runtime::Builder::new_multi_thread()
            .worker_threads(2)
            .thread_name("nearfar serve")
            .enable_all()
            .build()?;
        let listener = runtime.block_on(TcpListener::bind(address))?;
        let address = listener.local_addr()?;
        let _context = runtime.enter();
        let bound = router.rooms().filter(|rooms| rooms.datagrams).and_then(|rooms| {
            let bound = quic::Listener::bind(address, rooms.limits, current.as_ref());
            // On failure rooms work over WebSocket only.
            bound.inspect_err(|error| tracing::warn!(%error, "rooms have no datagrams")).ok()
        });
        let (quic, offer) = bound.unzip();
        let certificate_names = current.as_ref().map_or_else(Vec::new, |current| current.identity().names.clone());
        let router = Arc::new(router.configure(limits.connections, limits.header_bytes, certificate_names, offer));
        let (end, ended) = oneshot::channel();
        let shared = Arc::new(Shared { router: Arc::clone(&router), limits, tls });
        let thread = std::thread::Builder::new().name("nearfar serve".into()).spawn(move || {
            runtime.spawn(renew(current, Arc::clone(&shared.router)));
            runtime.block_on(listen(listener, quic.map(Arc::new), shared, ended));
            // Blocked file reads are abandoned.
            runtime.shutdown_timeout(limits.grace);
        })?;
        Ok(Server { address, router, end: Mutex::new(Some((end, thread))) })
    }

    /// Address of the server.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// WebTransport settings for pages; none if it is off.
    pub fn datagrams(&self) -> Option<Datagrams> {
        self.router.datagrams()
    }

    /// Accepts no more requests, lets responses finish within the grace period, and stops.
    pub fn close(&self) {
        let ended = self.end.lock().take();
        // Regions are closed first, so that responses that wait for them finish.
        for demand in self.router.content.sites.values().filter_map(|site| site.demand.as_ref()) {
            demand.close();
        }
        if let Some(rooms) = self.router.rooms() {
            rooms.close();
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

async fn listen(
    listener: TcpListener,
    quic: Option<Arc<quic::Listener>>,
    shared: Arc<Shared>,
    mut ended: oneshot::Receiver<()>,
) {
    let limits = shared.limits;
    let (gate, (end, shutdown)) = (Gate::new(limits.connections, limits.per_client), watch::channel(()));
    if let Some(quic) = &quic {
        tokio::spawn(Arc::clone(quic).listen(Arc::clone(&shared), gate.clone(), shutdown.clone()));
    }
    loop {
        let accepted = tokio::select! {
            accepted = accept(&listener, &gate) => accepted,
            _ = &mut ended => break,
        };
        let (stream, address, slot) = match accepted {
            Ok(accepted) => accepted,
            Err(error) => {
                tracing::warn!(%error, "a connection cannot be accepted");
                tokio::time::sleep(RETRY_PAUSE).await;
                continue;
            }
        };
        let client = address.ip().to_canonical();
        let Some(entry) = gate.enter_with(client, slot) else {
            shared.router.metrics.count_lost("connections");
            continue;
        };
        let (state, shutdown) = (Arc::clone(&shared), shutdown.clone());
        connection::spawn(Arc::clone(&shared), entry, async move {
            connection::serve(&state, stream, client, shutdown).await
        });
    }
    drop(listener);
    let _ = end.send(());
    let finished = async {
        gate.wait_until_empty().await;
        if let Some(quic) = quic {
            quic.finish().await;
        }
    };
    let _ = tokio::time::timeout(limits.grace, finished).await;
}

/// Waits for a free connection slot, then accepts a connection.
async fn accept(listener: &TcpListener, gate: &Gate) -> io::Result<(TcpStream, SocketAddr, OwnedSemaphorePermit)> {
    let slot = gate.wait().await.map_err(io::Error::other)?;
    let (stream, address) = listener.accept().await?;
    Ok((stream, address, slot))
}

/// Periodically reloads changed certificate files, updates the expiry metric, and replaces the self-signed certificate.
async fn renew(current: Option<Arc<CurrentCertificate>>, router: Arc<Router>) {
    loop {
        if let Some(current) = &current {
            if let Err(reason) = current.refresh() {
                tracing::warn!(%reason, "the new certificate is not used");
            }
            router.metrics.set_expiry(current.identity().ends);
        }
        if let Some(Err(reason)) = router.offer.as_ref().map(Offer::refresh) {
            tracing::warn!(%reason, "pages cannot connect for datagrams");
        }
        tokio::time::sleep(CHECK_INTERVAL).await;
    }
}
