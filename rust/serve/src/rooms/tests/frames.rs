//! Encoding and decoding of frames, on their own and compared with the test vectors shared by all languages.

use data_encoding::HEXLOWER;
use serde_json::Value;

use super::support::{encode, encode_each, pose};
use crate::rooms::frame::{Fault, FromServer, FromUser, HEADER_BYTES, To};
use crate::rooms::pose::{MAX_BYTES, Placement, PointerOrigin, Pose};

fn full_pose() -> Pose {
    let placement = |x| Placement { position: [x, -0.0, 1e6], rotation: [23170, 0, -23170, 1] };
    Pose {
        sequence: u32::MAX,
        clock: 1 << 50,
        is_acknowledged: true,
        stops: true,
        head: placement(1.5),
        hands: [Some(placement(-2.0)), Some(placement(0.0))],
        pointer: Some((PointerOrigin::Right, 20.0)),
    }
}

fn poses() -> Vec<Pose> {
    let one_hand = Pose { hands: [full_pose().hands[0], None], pointer: Some((PointerOrigin::Left, 0.0)), ..pose(7) };
    vec![pose(0), full_pose(), one_hand, Pose { pointer: Some((PointerOrigin::Head, 3.25)), ..pose(8) }]
}

fn user_frames() -> Vec<Vec<u8>> {
    let mut frames = vec![
        FromUser::Hello { group: 3, name: "Ada é", ticket: &[] },
        FromUser::Hello { group: u16::MAX, name: "", ticket: &[9; 26] },
        FromUser::Ack { user: 258, sequence: 0x0102_0304 },
        FromUser::Say { to: To::Room, payload: b"score" },
        FromUser::Say { to: To::Group, payload: b"" },
        FromUser::Signal { user: 1, payload: &[0, 255] },
        FromUser::Bye,
    ];
    frames.extend(poses().into_iter().map(FromUser::Pose));
    frames.into_iter().map(|frame| encode(&[frame])).collect()
}

fn server_frames() -> Vec<Vec<u8>> {
    let mut frames = vec![
        FromServer::Welcome { user: 1, others: 3, ticket: &[7; 26] },
        FromServer::Joined { user: 2, group: 4, name: "Grace" },
        FromServer::Left { user: 2 },
        FromServer::Say { user: 2, to: To::Group, payload: b"hit" },
        FromServer::Signal { user: 5, payload: b"offer" },
        FromServer::Settled { sequence: 9 },
        FromServer::Refused { code: 3, sentence: "expected frames" },
    ];
    frames.extend(poses().into_iter().map(|pose| FromServer::Pose { user: 77, pose }));
    let encoded = encode_each(&frames);
    assert!(frames.iter().zip(&encoded).all(|(frame, bytes)| frame.bytes() == bytes.len()));
    encoded
}

/// Encoded frames, each with whether it is a user's frame or the server's.
fn all_frames() -> impl Iterator<Item = (Vec<u8>, bool)> {
    let user_frames = user_frames().into_iter().map(|frame| (frame, true));
    user_frames.chain(server_frames().into_iter().map(|frame| (frame, false)))
}

/// Reads the first frame and writes it reencode; also returns the rest.
fn reencode(bytes: &[u8], is_from_user: bool) -> Result<(Vec<u8>, &[u8]), Fault> {
    let mut out = Vec::new();
    let rest = if is_from_user {
        let (frame, rest) = FromUser::read(bytes)?;
        frame.write(&mut out);
        rest
    } else {
        let (frame, rest) = FromServer::read(bytes)?;
        frame.write(&mut out);
        rest
    };
    Ok((out, rest))
}

#[test]
fn a_message_of_several_frames_is_read_as_it_was_written() {
    for (frames, is_from_user) in [(user_frames(), true), (server_frames(), false)] {
        let message = frames.concat();
        let mut rest = &message[..];
        for frame in &frames {
            let (read, remaining) = reencode(rest, is_from_user).expect("a frame");
            assert_eq!(&read, frame);
            rest = remaining;
        }
        assert!(rest.is_empty());
    }
}

#[test]
fn names_have_no_characters_that_control_or_format_text() {
    let hello = |name| FromUser::read(&encode(&[FromUser::Hello { group: 1, name, ticket: &[] }])).map(|_| ());
    for name in ["Ada", "Ада", "愛", "אדה", "عدا", "👩", ""] {
        assert_eq!(hello(name), Ok(()), "{name}");
    }
    for wrong in ["a\n", "A\u{200b}da", "\u{202e}adA", "\u{feff}", "\u{ad}", "\u{2066}", "\u{e0041}", "\u{61c}"] {
        assert!(hello(wrong).is_err(), "{wrong:?}");
    }
}

#[test]
fn every_truncation_is_refused() {
    for (frame, is_from_user) in all_frames() {
        for length in 0..frame.len() {
            assert!(reencode(&frame[..length], is_from_user).is_err(), "{length} bytes of {frame:?}");
            // Header with a matching, shorter length.
            let mut short = frame[..length.max(HEADER_BYTES)].to_vec();
            let body = (short.len() - HEADER_BYTES) as u16;
            short[1..HEADER_BYTES].copy_from_slice(&body.to_le_bytes());
            if let Ok((read, rest)) = reencode(&short, is_from_user) {
                assert_eq!((read, rest), (short.clone(), &[][..]));
            }
        }
    }
}

#[test]
fn accepted_frames_with_a_changed_bit_are_written_as_the_same_bytes() {
    let mut refused = 0;
    for (frame, is_from_user) in all_frames() {
        for bit in 0..frame.len() * 8 {
            let mut changed = frame.clone();
            changed[bit / 8] ^= 1 << (bit % 8);
            match reencode(&changed, is_from_user) {
                Ok((read, rest)) => assert_eq!([&read[..], rest].concat(), changed),
                Err(_) => refused += 1,
            }
        }
    }
    assert!(refused > 1000);
}

#[test]
fn numbers_are_little_endian_and_poses_are_short() {
    let ack = FromUser::Ack { user: 0x0102, sequence: 0x0304_0506 };
    assert_eq!(encode(&[ack]), [3, 6, 0, 2, 1, 6, 5, 4, 3]);
    let bytes = |pose: Pose| FromServer::Pose { user: 1, pose }.bytes();
    assert_eq!((bytes(pose(1)), bytes(full_pose())), (38, 82));
    assert_eq!(full_pose().bytes(), MAX_BYTES);
}

#[test]
fn invalid_poses_are_refused() {
    let head = |position: [f32; 3]| Pose { head: Placement { position, ..pose(1).head }, ..pose(1) };
    let rotated = |rotation: [i16; 4]| Pose { head: Placement { rotation, ..pose(1).head }, ..pose(1) };
    let pointing = |begin, length| Pose { pointer: Some((begin, length)), ..pose(1) };
    for wrong in [
        head([f32::NAN, 0.0, 0.0]),
        head([0.0, f32::INFINITY, 0.0]),
        head([0.0, 0.0, -1.1e6]),
        rotated([0; 4]),
        rotated([0, 0, 0, 16000]),
        rotated([i16::MIN; 4]),
        pointing(PointerOrigin::Left, 1.0),
        pointing(PointerOrigin::Right, 1.0),
        pointing(PointerOrigin::Head, -1.0),
        pointing(PointerOrigin::Head, f32::NAN),
    ] {
        assert!(matches!(FromUser::read(&encode(&[FromUser::Pose(wrong)])), Err(Fault::Frame(_))), "{wrong:?}");
    }
}

#[test]
fn names_and_payloads_have_a_maximum_length() {
    let read = |frame: FromUser<'_>| FromUser::read(&encode(&[frame])).map(|_| ());
    let hello = |name| FromUser::Hello { group: 0, name, ticket: &[] };
    let (longest, too_long) = ("é".repeat(32), "é".repeat(32) + "a");
    assert_eq!(read(hello(&longest)), Ok(()));
    for name in [&too_long, "a\nb", "\u{9f}"] {
        assert!(read(hello(name)).is_err(), "{name:?}");
    }
    for (frame, is_read) in [
        (FromUser::Say { to: To::Group, payload: &[0; 4096] }, true),
        (FromUser::Say { to: To::Group, payload: &[0; 4097] }, false),
        (FromUser::Signal { user: 1, payload: &[0; 16384] }, true),
        (FromUser::Signal { user: 1, payload: &[0; 16385] }, false),
    ] {
        assert_eq!(read(frame).is_ok(), is_read);
    }
    assert_eq!(FromUser::read(&[1, 1, 0, 2]), Err(Fault::Version(2)));
}

fn cases(section: &str) -> Vec<Value> {
    let path = format!("{}/../../tests/vectors/rooms.json", env!("CARGO_MANIFEST_DIR"));
    let document: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    assert_eq!((&document["format"], &document["version"]), (&"nearfar.vectors".into(), &1.into()));
    let cases = document[section].as_array().unwrap().clone();
    assert!(!cases.is_empty());
    cases
}

fn bytes(value: &Value) -> Vec<u8> {
    HEXLOWER.decode(value.as_str().unwrap().as_bytes()).unwrap()
}

fn payload(frame: &Value) -> Vec<u8> {
    ["ticket", "data"].iter().find_map(|name| frame.get(name)).map(bytes).unwrap_or_default()
}

fn number<T: TryFrom<u64>>(value: &Value) -> T {
    T::try_from(value.as_u64().unwrap()).ok().unwrap()
}

fn to(value: &Value) -> To {
    if value == "room" { To::Room } else { To::Group }
}

fn parse_placement(value: &Value) -> Option<Placement> {
    (!value.is_null()).then(|| Placement {
        position: serde_json::from_value(value["position"].clone()).unwrap(),
        rotation: serde_json::from_value(value["rotation"].clone()).unwrap(),
    })
}

fn parse_pose(value: &Value) -> Pose {
    let pointer = &value["pointer"];
    let begin = || match pointer["begin"].as_str().unwrap() {
        "head" => PointerOrigin::Head,
        "left" => PointerOrigin::Left,
        _ => PointerOrigin::Right,
    };
    Pose {
        sequence: number(&value["sequence"]),
        clock: number(&value["clock"]),
        is_acknowledged: value["acknowledged"].as_bool().unwrap(),
        stops: value["stops"].as_bool().unwrap(),
        head: parse_placement(&value["head"]).unwrap(),
        hands: [parse_placement(&value["left"]), parse_placement(&value["right"])],
        pointer: (!pointer.is_null()).then(|| (begin(), pointer["length"].as_f64().unwrap() as f32)),
    }
}

#[test]
fn frames_of_users_equal_the_test_vectors() {
    for case in cases("users") {
        let (frame, expected) = (&case["frame"], bytes(&case["bytes"]));
        let payload = payload(frame);
        let expected_frame = match frame["kind"].as_str().unwrap() {
            "hello" => {
                let name = frame["name"].as_str().unwrap();
                FromUser::Hello { group: number(&frame["group"]), name, ticket: &payload }
            }
            "pose" => FromUser::Pose(parse_pose(&frame["pose"])),
            "ack" => FromUser::Ack { user: number(&frame["user"]), sequence: number(&frame["sequence"]) },
            "say" => FromUser::Say { to: to(&frame["to"]), payload: &payload },
            "signal" => FromUser::Signal { user: number(&frame["user"]), payload: &payload },
            _ => FromUser::Bye,
        };
        assert_eq!(encode(&[expected_frame]), expected, "{}", case["region"]);
        assert_eq!(FromUser::read(&expected), Ok((expected_frame, &[][..])), "{}", case["region"]);
    }
}

#[test]
fn frames_of_the_server_equal_the_test_vectors() {
    for case in cases("servers") {
        let (frame, expected) = (&case["frame"], bytes(&case["bytes"]));
        let payload = payload(frame);
        let user = || number(&frame["user"]);
        let expected_frame = match frame["kind"].as_str().unwrap() {
            "welcome" => FromServer::Welcome { user: user(), others: number(&frame["others"]), ticket: &payload },
            "pose" => FromServer::Pose { user: user(), pose: parse_pose(&frame["pose"]) },
            "settled" => FromServer::Settled { sequence: number(&frame["sequence"]) },
            "say" => FromServer::Say { user: user(), to: to(&frame["to"]), payload: &payload },
            "signal" => FromServer::Signal { user: user(), payload: &payload },
            "joined" => {
                let name = frame["name"].as_str().unwrap();
                FromServer::Joined { user: user(), group: number(&frame["group"]), name }
            }
            "left" => FromServer::Left { user: user() },
            _ => FromServer::Refused { code: number(&frame["reason"]), sentence: frame["sentence"].as_str().unwrap() },
        };
        assert_eq!(encode_each(&[expected_frame]), [&expected[..]], "{}", case["region"]);
        assert_eq!(FromServer::read(&expected), Ok((expected_frame, &[][..])), "{}", case["region"]);
    }
}

#[test]
fn malformed_frames_are_refused() {
    for case in cases("refused") {
        assert!(FromServer::read(&bytes(&case["server"])).is_err(), "{}", case["region"]);
        if !case["user"].is_null() {
            assert!(FromUser::read(&bytes(&case["user"])).is_err(), "{}", case["region"]);
        }
    }
}
