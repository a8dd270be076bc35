//! Frames, compared with the test vectors shared by all languages: `tests/vectors/rooms.json`.

use data_encoding::HEXLOWER;
use serde_json::Value;

use super::support::{encode, encode_each};
use crate::rooms::frame::{FromServer, FromUser, To};
use crate::rooms::pose::{Begin, Placed, Pose};

/// Cases of a section.
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

fn parse_placed(value: &Value) -> Option<Placed> {
    (!value.is_null()).then(|| Placed {
        position: serde_json::from_value(value["position"].clone()).unwrap(),
        rotation: serde_json::from_value(value["rotation"].clone()).unwrap(),
    })
}

fn pose(value: &Value) -> Pose {
    let pointer = &value["pointer"];
    let begin = || match pointer["begin"].as_str().unwrap() {
        "head" => Begin::Head,
        "left" => Begin::Left,
        _ => Begin::Right,
    };
    Pose {
        sequence: number(&value["sequence"]),
        clock: number(&value["clock"]),
        is_acknowledged: value["acknowledged"].as_bool().unwrap(),
        stops: value["stops"].as_bool().unwrap(),
        head: parse_placed(&value["head"]).unwrap(),
        hands: [parse_placed(&value["left"]), parse_placed(&value["right"])],
        pointer: (!pointer.is_null()).then(|| (begin(), pointer["length"].as_f64().unwrap() as f32)),
    }
}

#[test]
fn frames_of_users_have_their_bytes_and_their_fields() {
    for case in cases("users") {
        let (frame, expected) = (&case["frame"], bytes(&case["bytes"]));
        let payload = payload(frame);
        let meant = match frame["kind"].as_str().unwrap() {
            "hello" => {
                let name = frame["name"].as_str().unwrap();
                FromUser::Hello { group: number(&frame["group"]), name, ticket: &payload }
            }
            "pose" => FromUser::Pose(pose(&frame["pose"])),
            "ack" => FromUser::Ack { user: number(&frame["user"]), sequence: number(&frame["sequence"]) },
            "say" => FromUser::Say { to: to(&frame["to"]), payload: &payload },
            "signal" => FromUser::Signal { user: number(&frame["user"]), payload: &payload },
            _ => FromUser::Bye,
        };
        assert_eq!(encode(&[meant]), expected, "{}", case["region"]);
        assert_eq!(FromUser::read(&expected), Ok((meant, &[][..])), "{}", case["region"]);
    }
}

#[test]
fn frames_of_the_server_have_their_bytes_and_their_fields() {
    for case in cases("servers") {
        let (frame, expected) = (&case["frame"], bytes(&case["bytes"]));
        let payload = payload(frame);
        let user = || number(&frame["user"]);
        let meant = match frame["kind"].as_str().unwrap() {
            "welcome" => FromServer::Welcome { user: user(), others: number(&frame["others"]), ticket: &payload },
            "pose" => FromServer::Pose { user: user(), pose: pose(&frame["pose"]) },
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
        assert_eq!(encode_each(&[meant]), [&expected[..]], "{}", case["region"]);
        assert_eq!(FromServer::read(&expected), Ok((meant, &[][..])), "{}", case["region"]);
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
