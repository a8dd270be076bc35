use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Duration;

use bytes::Bytes;

use super::super::maker::{Making, Part, Wanted};
use super::super::ticket::Event;
use super::*;

const ANN: IpAddr = IpAddr::V4(std::net::Ipv4Addr::new(127, 0, 0, 1));
const BOB: IpAddr = IpAddr::V4(std::net::Ipv4Addr::new(127, 0, 0, 2));

/// Makes two stages of one part each; each part waits for a permit of the test.
struct Stepped {
    begun: Arc<AtomicUsize>,
    /// Places and stages of parts, in the order in which they are started.
    log: Sender<(Place, u8)>,
    permits: Arc<Mutex<Receiver<()>>>,
}

struct Two {
    place: Place,
    stage: u8,
    log: Sender<(Place, u8)>,
    permits: Arc<Mutex<Receiver<()>>>,
}

impl Maker for Stepped {
    fn begin(&self, place: Place) -> Result<Box<dyn Making>, String> {
        if place.0[0] > 1e6 {
            return Err("center: expected one with objects around it".into());
        }
        self.begun.fetch_add(1, Ordering::SeqCst);
        let (log, permits) = (self.log.clone(), Arc::clone(&self.permits));
        Ok(Box::new(Two { place, stage: 0, log, permits }))
    }
}

impl Making for Two {
    fn next(&mut self, is_wanted: &Wanted) -> Result<Part, String> {
        let stage = self.stage;
        self.stage += 1;
        self.log.send((self.place, stage)).unwrap();
        assert!(self.place.0[0] != 666.0, "a panic of a maker");
        loop {
            if self.permits.lock().unwrap().recv_timeout(Duration::from_millis(5)).is_ok() {
                break;
            }
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

struct Kitchen {
    demand: Demand,
    begun: Arc<AtomicUsize>,
    log: Receiver<(Place, u8)>,
    permit: Sender<()>,
}

fn kitchen(cache: Option<Cache>, limits: Limits) -> Kitchen {
    let begun = Arc::new(AtomicUsize::new(0));
    let ((log, heard), (permit, permits)) = (channel(), channel());
    let maker = Stepped { begun: Arc::clone(&begun), log, permits: Arc::new(Mutex::new(permits)) };
    Kitchen { demand: Demand::start(Box::new(maker), 2.0, cache, limits).unwrap(), begun, log: heard, permit }
}

fn one() -> Limits {
    Limits { workers: 1, ..Limits::default() }
}

fn coming(answer: Result<Answer, Refusal>) -> Ticket {
    match answer {
        Ok(Answer::Coming(ticket)) => ticket,
        Ok(Answer::Whole(_)) => panic!("the region is there"),
        Err(refusal) => panic!("{refusal:?}"),
    }
}

/// Collects the lines up to the outcome.
async fn collect_events(mut ticket: Ticket) -> (Vec<Bytes>, Outcome) {
    let mut lines = Vec::new();
    loop {
        match ticket.event().await {
            Event::Lines(more) => lines.extend(more),
            Event::End(outcome) => return (lines, outcome),
            Event::Before(_) => {}
        }
    }
}

#[tokio::test]
async fn a_place_requested_by_several_is_made_once_for_all() {
    let kitchen = kitchen(None, one());
    let first = coming(kitchen.demand.ask(ANN, Place([3.9, 1.7, 0.1])));
    let second = coming(kitchen.demand.ask(BOB, Place([4.2, 1.74, -0.3])));
    assert_eq!(first.place(), second.place());
    assert_eq!(first.place().to_string(), "4,1.75,0");
    kitchen.permit.send(()).unwrap();
    kitchen.permit.send(()).unwrap();
    for (lines, outcome) in [collect_events(first).await, collect_events(second).await] {
        assert_eq!(lines, [&b"{\"stage\":0}\n"[..], b"{\"stage\":1}\n"]);
        assert_eq!(outcome, Outcome::Complete);
    }
    assert_eq!(kitchen.begun.load(Ordering::SeqCst), 1);
    // Without a disk cache it stays in memory.
    assert!(matches!(kitchen.demand.ask(ANN, Place([4.0, 1.7, 0.0])), Ok(Answer::Whole(Whole::InMemory(_)))));
    assert!(kitchen.demand.file("files/4-0").is_some() && kitchen.demand.file("files/5-0").is_none());
}

#[tokio::test]
async fn a_slow_client_finds_maps_that_came_first_when_full_ones_are_made() {
    let folder = tempfile::tempdir().unwrap();
    let kitchen = kitchen(Cache::open(folder.path(), 1 << 20).unwrap(), one());
    let ticket = coming(kitchen.demand.ask(ANN, Place([4.0, 1.75, 0.0])));
    kitchen.permit.send(()).unwrap();
    kitchen.permit.send(()).unwrap();
    assert_eq!(collect_events(ticket).await.1, Outcome::Complete);
    assert!(matches!(kitchen.demand.ask(ANN, Place([4.0, 1.75, 0.0])), Ok(Answer::Whole(Whole::Manifest(_)))));
    assert!(matches!(kitchen.demand.file("files/4-0"), Some(Kept::Content(_))));
    assert!(kitchen.demand.file("manifest.json").is_none());
}

#[tokio::test]
async fn a_new_client_is_served_before_late_stages_of_others() {
    let kitchen = kitchen(None, one());
    let flood: Vec<Ticket> =
        (0..3).map(|x| coming(kitchen.demand.ask(ANN, Place([f64::from(x) * 10.0, 0.0, 0.0])))).collect();
    assert_eq!(kitchen.log.recv().unwrap(), (Place([0.0; 3]), 0));
    let late = coming(kitchen.demand.ask(BOB, Place([90.0, 0.0, 0.0])));
    for _ in 0..8 {
        kitchen.permit.send(()).unwrap();
    }
    assert_eq!(collect_events(late).await.1, Outcome::Complete);
    for ticket in flood {
        assert_eq!(collect_events(ticket).await.1, Outcome::Complete);
    }
    let order: Vec<(f64, u8)> = kitchen.log.try_iter().map(|(place, stage)| (place.0[0], stage)).collect();
    assert_eq!(order[0], (90.0, 0));
    assert_eq!(order[1..3], [(10.0, 0), (20.0, 0)]);
}

#[tokio::test]
async fn one_thread_is_left_for_first_stages() {
    let kitchen = kitchen(None, Limits::default());
    let first = coming(kitchen.demand.ask(ANN, Place([0.0; 3])));
    assert_eq!(kitchen.log.recv().unwrap().1, 0);
    kitchen.permit.send(()).unwrap();
    // Its late stage occupies the other thread, so the first thread stays free.
    assert_eq!(kitchen.log.recv().unwrap(), (Place([0.0; 3]), 1));
    let second = coming(kitchen.demand.ask(ANN, Place([10.0, 0.0, 0.0])));
    assert_eq!(kitchen.log.recv().unwrap(), (Place([10.0, 0.0, 0.0]), 0));
    kitchen.permit.send(()).unwrap();
    kitchen.permit.send(()).unwrap();
    kitchen.permit.send(()).unwrap();
    assert_eq!(collect_events(first).await.1, Outcome::Complete);
    assert_eq!(collect_events(second).await.1, Outcome::Complete);
}

#[tokio::test]
async fn work_ends_when_the_last_client_leaves() {
    let kitchen = kitchen(None, one());
    let (first, second) =
        (coming(kitchen.demand.ask(ANN, Place([0.0; 3]))), coming(kitchen.demand.ask(BOB, Place([0.0; 3]))));
    assert_eq!(kitchen.log.recv().unwrap().1, 0);
    let waiting = coming(kitchen.demand.ask(BOB, Place([50.0, 0.0, 0.0])));
    drop(first);
    assert_eq!(kitchen.demand.waiting(), 2);
    drop(second);
    drop(waiting);
    assert_eq!(kitchen.demand.waiting(), 0);
    // The thread becomes free without a permit for the abandoned part; abandoned waiting work is never started.
    let other = coming(kitchen.demand.ask(ANN, Place([20.0, 0.0, 0.0])));
    assert_eq!(kitchen.log.recv().unwrap(), (Place([20.0, 0.0, 0.0]), 0));
    // A repeated request is served.
    let again = coming(kitchen.demand.ask(ANN, Place([0.0; 3])));
    for _ in 0..4 {
        kitchen.permit.send(()).unwrap();
    }
    assert_eq!(collect_events(other).await.1, Outcome::Complete);
    assert_eq!(collect_events(again).await.1, Outcome::Complete);
    assert_eq!(kitchen.begun.load(Ordering::SeqCst), 3);
}

#[tokio::test]
async fn requests_are_bounded_for_each_client_and_in_all() {
    let kitchen = kitchen(None, Limits { regions: 3, per_client: 2, ..one() });
    let at = |x: i32| Place([f64::from(x) * 10.0, 0.0, 0.0]);
    let _held = [coming(kitchen.demand.ask(ANN, at(0))), coming(kitchen.demand.ask(ANN, at(1)))];
    assert_eq!(kitchen.demand.ask(ANN, at(2)).err(), Some(Refusal::TooManyOfClient(2)));
    // Joining an existing region adds no work.
    let _other = coming(kitchen.demand.ask(BOB, at(3)));
    let _shared = coming(kitchen.demand.ask(ANN, at(3)));
    assert_eq!(kitchen.demand.ask(BOB, at(4)).err(), Some(Refusal::TooMany(3)));
}

#[tokio::test]
async fn failures_and_panics_are_reported_without_affecting_others() {
    let kitchen = kitchen(None, one());
    let lost = coming(kitchen.demand.ask(ANN, Place([2e6, 0.0, 0.0])));
    assert_eq!(collect_events(lost).await.1, Outcome::Failed("center: expected one with objects around it".into()));
    let panics = coming(kitchen.demand.ask(ANN, Place([666.0, 0.0, 0.0])));
    assert!(matches!(collect_events(panics).await.1, Outcome::Failed(reason) if reason.contains("internal error")));
    let fine = coming(kitchen.demand.ask(BOB, Place([0.0; 3])));
    kitchen.permit.send(()).unwrap();
    kitchen.permit.send(()).unwrap();
    assert_eq!(collect_events(fine).await.1, Outcome::Complete);
}

#[tokio::test]
async fn waiting_clients_are_told_their_position() {
    let kitchen = kitchen(None, one());
    let _first = coming(kitchen.demand.ask(ANN, Place([0.0; 3])));
    kitchen.log.recv().unwrap();
    let _second = coming(kitchen.demand.ask(ANN, Place([10.0, 0.0, 0.0])));
    let mut third = coming(kitchen.demand.ask(ANN, Place([20.0, 0.0, 0.0])));
    assert!(matches!(third.event().await, Event::Before(1)));
    kitchen.permit.send(()).unwrap();
    assert!(matches!(third.event().await, Event::Before(0)));
}

#[tokio::test]
async fn complete_regions_come_from_the_disk() {
    let folder = tempfile::tempdir().unwrap();
    let kitchen = kitchen(Cache::open(folder.path(), 1 << 20).unwrap(), one());
    let ticket = coming(kitchen.demand.ask(ANN, Place([0.0; 3])));
    kitchen.permit.send(()).unwrap();
    kitchen.permit.send(()).unwrap();
    assert_eq!(collect_events(ticket).await.1, Outcome::Complete);
    assert!(matches!(kitchen.demand.ask(BOB, Place([0.0; 3])), Ok(Answer::Whole(Whole::Manifest(_)))));
    assert_eq!(kitchen.begun.load(Ordering::SeqCst), 1);
}

#[tokio::test]
async fn a_stopping_server_cancels_work_and_reports_it() {
    let kitchen = kitchen(None, one());
    let ticket = coming(kitchen.demand.ask(ANN, Place([0.0; 3])));
    kitchen.log.recv().unwrap();
    kitchen.demand.close();
    assert!(matches!(collect_events(ticket).await.1, Outcome::Failed(_)));
    assert_eq!(kitchen.demand.ask(ANN, Place([0.0; 3])).err(), Some(Refusal::Closing));
}

/// A thread that is about to wait when the server shuts down must still be woken.
#[test]
fn a_server_that_ends_at_once_ends() {
    for _ in 0..5_000 {
        kitchen(None, Limits::default()).demand.close();
    }
}
