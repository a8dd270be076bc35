use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Duration;

use super::super::region::{Part, PartMaker, Wanted};
use super::*;

const ANN: IpAddr = IpAddr::V4(std::net::Ipv4Addr::new(127, 0, 0, 1));
const BOB: IpAddr = IpAddr::V4(std::net::Ipv4Addr::new(127, 0, 0, 2));

/// Makes two stages of one part each; each part waits for a permit of the test.
#[derive(Clone)]
struct Stepped {
    begun: Arc<AtomicUsize>,
    /// Places and stages of parts, in the order in which they are started.
    log: Sender<(Place, u8)>,
    permits: Arc<Mutex<Receiver<()>>>,
}

struct SteppedRegion {
    place: Place,
    stage: u8,
    maker: Stepped,
}

impl Maker for Stepped {
    fn begin(&self, place: Place) -> Result<Box<dyn PartMaker>, String> {
        if place.0[0] > 1e6 {
            return Err("center: expected one with objects around it".into());
        }
        self.begun.fetch_add(1, Ordering::SeqCst);
        Ok(Box::new(SteppedRegion { place, stage: 0, maker: self.clone() }))
    }
}

impl PartMaker for SteppedRegion {
    fn next(&mut self, is_wanted: &Wanted) -> Result<Part, String> {
        let stage = self.stage;
        self.stage += 1;
        self.maker.log.send((self.place, stage)).unwrap();
        assert!(self.place.0[0] != 666.0, "a panic of a maker");
        while self.maker.permits.lock().recv_timeout(Duration::from_millis(5)).is_err() {
            if !is_wanted() {
                return Err("nobody waits".into());
            }
        }
        let line = Bytes::from(format!("{{\"stage\":{stage}}}\n"));
        let files = vec![(format!("files/{}-{stage}", self.place.0[0]), Bytes::from_static(b"data"))];
        let whole = vec![("manifest.json".to_owned(), Bytes::from_static(b"{\"files\":{}}"))];
        Ok(Part { stage, line, files: if stage == 0 { files } else { whole }, next: (stage == 0).then_some(1) })
    }
}

struct Bench {
    demand: Demand,
    begun: Arc<AtomicUsize>,
    log: Receiver<(Place, u8)>,
    permits: Sender<()>,
}

impl Bench {
    fn new(cache: Option<Cache>, limits: Limits) -> Self {
        let begun = Arc::new(AtomicUsize::new(0));
        let ((sender, log), (permits, receiver)) = (channel(), channel());
        let maker = Stepped { begun: Arc::clone(&begun), log: sender, permits: Arc::new(Mutex::new(receiver)) };
        Bench { demand: Demand::start(Box::new(maker), 2.0, cache, limits).unwrap(), begun, log, permits }
    }

    fn permit(&self, parts: usize) {
        (0..parts).for_each(|_| self.permits.send(()).unwrap());
    }

    /// Place and stage of the next part that a thread starts.
    fn next_started(&self) -> (Place, u8) {
        self.log.recv_timeout(Duration::from_secs(60)).expect("a part is started")
    }

    /// Requests a region that is not complete.
    fn request(&self, client: IpAddr, place: Place) -> Ticket {
        match self.demand.request(client, place) {
            Ok(Answer::InProgress(ticket)) => ticket,
            Ok(Answer::Complete(_)) => panic!("the region is complete already"),
            Err(refusal) => panic!("{refusal:?}"),
        }
    }

    fn is_on_disk(&self, place: Place) -> bool {
        matches!(self.demand.request(BOB, place), Ok(Answer::Complete(CompleteRegion::Manifest(_))))
    }
}

fn one_worker() -> Limits {
    Limits { workers: 1, ..Limits::default() }
}

fn place_at(x: f64) -> Place {
    Place([x, 0.0, 0.0])
}

/// Collects the lines up to the outcome.
async fn collect_events(mut ticket: Ticket) -> (Vec<Bytes>, Outcome) {
    let mut lines = Vec::new();
    loop {
        match ticket.event().await {
            Event::Lines(more) => lines.extend(more),
            Event::End(outcome) => return (lines, outcome),
            Event::Waiting(_) => {}
        }
    }
}

async fn expect_completion(ticket: Ticket) {
    assert_eq!(collect_events(ticket).await.1, Outcome::Complete);
}

#[tokio::test]
async fn a_place_requested_by_several_is_made_once_for_all() {
    let bench = Bench::new(None, one_worker());
    let first = bench.request(ANN, Place([3.9, 1.7, 0.1]));
    let second = bench.request(BOB, Place([4.2, 1.74, -0.3]));
    assert_eq!(first.place(), second.place());
    assert_eq!(first.place().to_string(), "4,1.75,0");
    bench.permit(2);
    for (lines, outcome) in [collect_events(first).await, collect_events(second).await] {
        assert_eq!(lines, [&b"{\"stage\":0}\n"[..], b"{\"stage\":1}\n"]);
        assert_eq!(outcome, Outcome::Complete);
    }
    assert_eq!(bench.begun.load(Ordering::SeqCst), 1);
    // Without a disk cache it stays in memory.
    assert!(matches!(
        bench.demand.request(ANN, Place([4.0, 1.7, 0.0])),
        Ok(Answer::Complete(CompleteRegion::InMemory(_)))
    ));
    assert!(bench.demand.file("files/4-0").is_some() && bench.demand.file("files/5-0").is_none());
}

#[tokio::test]
async fn a_slow_client_finds_maps_that_came_first_when_full_ones_are_made() {
    let folder = tempfile::tempdir().unwrap();
    let bench = Bench::new(Cache::open(folder.path(), 1 << 20).unwrap(), one_worker());
    let ticket = bench.request(ANN, Place([4.0, 1.75, 0.0]));
    bench.permit(2);
    expect_completion(ticket).await;
    assert!(bench.is_on_disk(Place([4.0, 1.75, 0.0])));
    assert!(matches!(bench.demand.file("files/4-0"), Some(Content::Bytes(_))));
    assert!(bench.demand.file("manifest.json").is_none());
}

#[tokio::test]
async fn a_new_client_is_served_before_late_stages_of_others() {
    let bench = Bench::new(None, one_worker());
    let flood = [0.0, 10.0, 20.0].map(|x| bench.request(ANN, place_at(x)));
    assert_eq!(bench.next_started(), (place_at(0.0), 0));
    let late = bench.request(BOB, place_at(90.0));
    bench.permit(8);
    expect_completion(late).await;
    for ticket in flood {
        expect_completion(ticket).await;
    }
    let order: Vec<(f64, u8)> = bench.log.try_iter().map(|(place, stage)| (place.0[0], stage)).collect();
    assert_eq!(order[0], (90.0, 0));
    assert_eq!(order[1..3], [(10.0, 0), (20.0, 0)]);
}

#[tokio::test]
async fn one_thread_is_left_for_first_stages() {
    let bench = Bench::new(None, Limits::default());
    let first = bench.request(ANN, place_at(0.0));
    assert_eq!(bench.next_started().1, 0);
    bench.permit(1);
    // Its late stage occupies the other thread, so the first thread stays free.
    assert_eq!(bench.next_started(), (place_at(0.0), 1));
    let second = bench.request(ANN, place_at(10.0));
    assert_eq!(bench.next_started(), (place_at(10.0), 0));
    bench.permit(3);
    expect_completion(first).await;
    expect_completion(second).await;
}

#[tokio::test]
async fn work_ends_when_the_last_client_leaves() {
    let bench = Bench::new(None, one_worker());
    let (first, second) = (bench.request(ANN, place_at(0.0)), bench.request(BOB, place_at(0.0)));
    assert_eq!(bench.next_started().1, 0);
    let waiting = bench.request(BOB, place_at(50.0));
    drop(first);
    assert_eq!(bench.demand.statistics().waiting, 2);
    drop(second);
    drop(waiting);
    assert_eq!(bench.demand.statistics().waiting, 0);
    // The thread becomes free without a permit for the abandoned part; abandoned waiting work is never started.
    let other = bench.request(ANN, place_at(20.0));
    assert_eq!(bench.next_started(), (place_at(20.0), 0));
    // A repeated request is served.
    let again = bench.request(ANN, place_at(0.0));
    bench.permit(4);
    expect_completion(other).await;
    expect_completion(again).await;
    assert_eq!(bench.begun.load(Ordering::SeqCst), 3);
}

#[tokio::test]
async fn requests_are_bounded_for_each_client_and_in_all() {
    let bench = Bench::new(None, Limits { regions: 3, per_client: 2, ..one_worker() });
    let _held = [bench.request(ANN, place_at(0.0)), bench.request(ANN, place_at(10.0))];
    assert_eq!(bench.demand.request(ANN, place_at(20.0)).err(), Some(Refusal::TooManyOfClient(2)));
    // A request for an existing region adds no work.
    let _other = bench.request(BOB, place_at(30.0));
    let _shared = bench.request(ANN, place_at(30.0));
    assert_eq!(bench.demand.request(BOB, place_at(40.0)).err(), Some(Refusal::TooMany(3)));
}

#[tokio::test]
async fn failures_and_panics_are_reported_without_affecting_others() {
    let bench = Bench::new(None, one_worker());
    let lost = bench.request(ANN, place_at(2e6));
    assert_eq!(collect_events(lost).await.1, Outcome::Failed("center: expected one with objects around it".into()));
    let panics = bench.request(ANN, place_at(666.0));
    assert!(matches!(collect_events(panics).await.1, Outcome::Failed(reason) if reason.contains("internal error")));
    let fine = bench.request(BOB, place_at(0.0));
    bench.permit(2);
    expect_completion(fine).await;
}

#[tokio::test]
async fn waiting_clients_are_told_their_position() {
    let bench = Bench::new(None, one_worker());
    let _first = bench.request(ANN, place_at(0.0));
    bench.next_started();
    let _second = bench.request(ANN, place_at(10.0));
    let mut third = bench.request(ANN, place_at(20.0));
    assert!(matches!(third.event().await, Event::Waiting(1)));
    bench.permit(1);
    assert!(matches!(third.event().await, Event::Waiting(0)));
}

#[tokio::test]
async fn complete_regions_come_from_the_disk() {
    let folder = tempfile::tempdir().unwrap();
    let bench = Bench::new(Cache::open(folder.path(), 1 << 20).unwrap(), one_worker());
    let ticket = bench.request(ANN, place_at(0.0));
    bench.permit(2);
    expect_completion(ticket).await;
    assert!(bench.is_on_disk(place_at(0.0)));
    assert_eq!(bench.begun.load(Ordering::SeqCst), 1);
}

#[tokio::test]
async fn a_stopping_server_cancels_work_and_reports_it() {
    let bench = Bench::new(None, one_worker());
    let ticket = bench.request(ANN, place_at(0.0));
    bench.next_started();
    bench.demand.close();
    assert!(matches!(collect_events(ticket).await.1, Outcome::Failed(_)));
    assert_eq!(bench.demand.request(ANN, place_at(0.0)).err(), Some(Refusal::Closing));
}

/// A thread that is about to wait when the server shuts down must still be woken.
#[test]
fn a_server_that_ends_at_once_ends() {
    for _ in 0..5_000 {
        Bench::new(None, Limits::default()).demand.close();
    }
}
