//! What a steering stand says by its HTD: selector, override and lever (AP-22).

use crate::limits::{Quantity, limits};
use crate::nmea::{Htd, OverrideStatus, Sentence, SteeringMode};
use crate::time::Stamp;
use crate::units::RudderAngle;
use alloc::format;
use alloc::string::String;
use serde::{Deserialize, Serialize};

/// Where the selector stands.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) enum Says {
    /// Field 1 is A: the override is in use.
    NfuLine,
    /// Field 4 is M.
    Hand,
    /// Field 4 is R: the follow-up lever, with its order.
    Rudder(RudderAngle),
    /// Field 4 is S.
    Autopilot,
}

/// The last that was said, and the last that could not be read.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Selector {
    said: Option<(Says, Stamp)>,
    nonsense: Option<(String, Stamp)>,
}

impl Selector {
    /// Takes an HTD.
    pub(super) fn take(&mut self, now: Stamp, sentence: &Sentence<'_>) {
        match read(sentence) {
            Ok(says) => self.said = Some((says, now)),
            Err(why) => self.nonsense = Some((why, now)),
        }
    }

    /// What it says now; silence claims nothing.
    pub(super) fn says(&self, now: Stamp) -> Option<Says> {
        let (says, at) = self.said?;
        (now.since(at) <= lost_ms()).then_some(says)
    }

    /// What is wrong with it: nonsense, or silence where a stand is `wired`.
    pub(super) fn wrong(&self, now: Stamp, wired: bool) -> Option<String> {
        let heard = self.said.map_or(Stamp(0), |(_, at)| at);
        let nonsense = self.nonsense.as_ref().filter(|(_, at)| *at > heard);
        if let Some((why, _)) = nonsense.filter(|(_, at)| now.since(*at) <= lost_ms()) {
            return Some(format!("The steering stand's HTD is not used: {why}"));
        }
        let silent = wired && now.since(heard) > lost_ms();
        silent.then(|| "The steering stand is silent: its selector is not known here".into())
    }
}

const fn lost_ms() -> u64 {
    limits(Quantity::Report).1
}

/// What an HTD says, or what is wrong with it.
fn read(sentence: &Sentence<'_>) -> Result<Says, String> {
    let Some(htd) = Htd::from_sentence(sentence) else {
        return Err("not an HTD".into());
    };
    if let Some(fault) = sentence.faults().first() {
        let field = fault.field.map(|field| format!("field {field}: "));
        return Err(format!("{}{}", field.unwrap_or_default(), fault.text()));
    }
    if htd.override_status == Some(OverrideStatus::InUse) {
        return Ok(Says::NfuLine);
    }
    if htd.override_status.is_none() {
        return Err("field 1: no override status".into());
    }
    match (htd.steering_mode, htd.rudder_angle) {
        (Some(SteeringMode::Manual), _) => Ok(Says::Hand),
        (Some(SteeringMode::StandAlone), _) => Ok(Says::Autopilot),
        (Some(SteeringMode::RudderControl), Some(order)) => {
            Ok(Says::Rudder(RudderAngle::from_deg(order)))
        }
        (Some(SteeringMode::RudderControl), None) => Err("field 2: no rudder order".into()),
        (Some(mode), _) => Err(format!("field 4: {} is no mode of a stand", mode.letter())),
        (None, _) => Err("field 4: no steering mode".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nmea::{decode, with_checksum};

    // AP-22
    #[test]
    fn each_letter_says_who_steers_and_what_is_no_stands_is_nonsense() {
        let of = |start: &str| {
            let line = with_checksum(&format!("IIHTD,{start},,,,,,,,,T,A,A,,90.0"));
            read(&decode(line.as_bytes()))
        };
        assert_eq!(of("V,,,M"), Ok(Says::Hand));
        assert_eq!(of("V,,,S"), Ok(Says::Autopilot));
        assert_eq!(
            of("V,12.5,L,R"),
            Ok(Says::Rudder(RudderAngle::from_deg(-12.5)))
        );
        for mode in ["M", "S", "R", "T", ""] {
            assert_eq!(of(&format!("A,,,{mode}")), Ok(Says::NfuLine), "{mode}");
        }
        for (start, why) in [
            (",,,M", "field 1: "),
            ("V,,,", "field 4: "),
            ("V,,,H", "field 4: H"),
            ("V,,,T", "field 4: T"),
            ("V,,,R", "field 2: "),
            ("V,12.5,,R", "field "),
            ("X,,,M", "field 1: "),
        ] {
            let refused = of(start).unwrap_err();
            assert!(refused.starts_with(why), "{start}: {refused}");
        }
    }
}
