//! FB6: every field of every sentence at the exact values that have frozen other decoders.

use super::generate::{bytes, line};
use super::random::Random;
use crate::nmea::explain::{FieldValue, explain};
use crate::nmea::table::Kind;
use crate::nmea::*;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

const VALUES: &[&str] = &[
    "0", "90", "180", "270", "359.99", "360", "-0", "NaN", "1e308", "inf", "-inf", "",
];

/// The typed view of a sentence as text, whichever it is.
fn view(sentence: &Sentence<'_>) -> Option<String> {
    macro_rules! first_of {
        ($($view:ident)+) => {
            None$(.or_else(|| $view::from_sentence(sentence).map(|view| format!("{view:?}"))))+
        };
    }
    first_of!(
        Htc Htd Xte Hsc Apb Rsa Ror Hdt Ths Hdg Hdm Rot Vhw Hms Hmr Hcr Hrm Vbw Vlw Vdr Xdr Mtw Mwv Mwd Vwr Vwt
        Dbt Dpt Rpm Txt
        Gll Vtg Gga Rmc Zda Gsv Bod Bwc Bwr Rmb Wpl Rte Alr Ack Ala Arc Acn Hbt Eve Alc Alf
        Vdm Vdo Abm Bbm Vsd Osd Rsd Ttm Tlb Ttd Pney1 Pney2
        Pemc00 Pemc01 Pemc02 Pemc03 Pemc04 Pemc05 Pemc06 Pemc07 Pemc08 Pemc09 Pemc10 Pemc11
    )
}

/// The text of a number that a field with this format takes as it is.
fn exact(sentence: &Sentence<'_>, at: usize, value: &str) {
    let Ok(number) = value.parse::<f64>() else {
        return;
    };
    let check = |item: Item<'_>| {
        let plain = matches!(item.kind, Kind::Number(_) | Kind::Lettered(..));
        if item.field == at && plain && !matches!(item.value, Value::Invalid) {
            assert_eq!(item.value.number(), Some(number), "{value} in field {at}");
        }
    };
    sentence.walk(check, &mut Vec::new());
}

fn check(raw: &[u8], at: usize, value: &str) {
    let sentence = decode(raw);
    let text = || String::from_utf8_lossy(raw).into_owned();
    sentence.walk(
        |item| {
            let position = item.value.position();
            let finite = item.value.number().is_none_or(f64::is_finite)
                && position.is_none_or(|p| p.lat.is_finite() && p.lon.is_finite());
            assert!(finite, "{}", text());
        },
        &mut Vec::new(),
    );
    if !value.is_empty() {
        exact(&sentence, at, value);
    }
    for field in explain(&sentence).fields {
        if let FieldValue::Number(number) | FieldValue::Degrees(number) = field.value {
            assert!(number.is_finite(), "{}", text());
        }
    }
    // JSON has no NaN: a number that is none would be written as null.
    let json = json(1, None, raw);
    let read: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(
        read["fields"].as_array().map(Vec::len),
        Some(sentence.fields.len())
    );
    if let Some(view) = view(&sentence) {
        // A text may say so, a number may not.
        let wild = ["(NaN", " NaN", "(inf", "(-inf", " inf"];
        assert!(!wild.iter().any(|word| view.contains(word)), "{view}");
    }
    if let Some(line) = encode(&sentence) {
        assert!(decode(&bytes(&line)).checksum.is_right(), "{line}");
    }
}

#[test]
fn exact_values_in_every_field_stay_finite() {
    let mut random = Random::seeded("sweep");
    let mut swept = 0;
    for definition in dictionary() {
        for _ in 0..2 {
            let text = line(&mut random, definition);
            let parts: Vec<&str> = text[..text.len() - 3].split(',').collect();
            for at in 1..parts.len() {
                for value in VALUES {
                    let mut changed = parts.clone();
                    changed[at] = value;
                    let raw = bytes(&with_checksum(&changed.join(",")));
                    check(&raw, at, value);
                    swept += 1;
                }
            }
        }
    }
    assert!(swept > 20_000, "{swept} values");
}

#[test]
fn every_typed_view_is_swept() {
    let mut random = Random::seeded("views");
    let mut without: Vec<&str> = Vec::new();
    for definition in dictionary() {
        let text = bytes(line(&mut random, definition));
        if view(&decode(&text)).is_none() {
            without.push(definition.formatter);
        }
    }
    // Sentences that the code explains and needs no type for.
    assert!(without.len() + 75 == dictionary().len(), "{without:?}");
}
