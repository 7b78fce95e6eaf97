//! Everything that can be asked of a radio message, and what must hold for any.

use wheelover_core::nmea::ais::{Draft, Gathered, RadioMessage, Value};
use wheelover_core::nmea::{Sentence, json_line};

/// Asks the message that a sentence completes for values, faults, JSON and its bits again.
pub fn ask(sentence: &Sentence<'_>, gathered: &Gathered) {
    let text = json_line(1, None, sentence).text_with(gathered);
    assert!(serde_json::from_str::<serde_json::Value>(&text).is_ok());
    let (messages, _) = gathered.messages();
    for message in &messages {
        let entries = message.entries();
        for entry in &entries {
            let _ = (entry.unit(), entry.note(), entry.meaning());
            match entry.value {
                Value::Number(value) | Value::AtLeast(value) => assert!(value.is_finite()),
                Value::Text(text) => assert!(text.chars().all(|c| (' '..='_').contains(&c))),
                _ => {}
            }
        }
        for fault in message.faults() {
            assert!(
                fault
                    .field
                    .is_none_or(|name| entries.iter().any(|entry| entry.name() == name))
            );
        }
        again(message);
    }
}

/// What is made of the values of a message without faults is made of its own values too.
fn again(message: &RadioMessage<'_>) {
    let Ok((payload, fill_bits)) = Draft::of(message).payload() else {
        return;
    };
    let once = RadioMessage::decode(payload.as_bytes(), fill_bits.into());
    if !once.faults().is_empty() {
        return;
    }
    let twice = Draft::of(&once).payload().expect("values without faults");
    let thrice = RadioMessage::decode(twice.0.as_bytes(), twice.1.into());
    assert_eq!(Draft::of(&thrice).payload(), Ok(twice));
}
