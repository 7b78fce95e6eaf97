//! The fold: what each sentence on each kind of port changes in the picture (FE11, SEN-2, SEN-5).

use super::{Commanded, Fix, Ground, Heard, Picture, Source};
use crate::nmea::{self, Checksum, Htc, Htd, Pney1, Pney2, Sentence, Xte};
use crate::station::{ChecksumPolicy, Direction, PortIndex, Profile};
use crate::time::Stamp;
use crate::units::{Course, Heading, RateOfTurn, RudderAngle, Speed};
use alloc::vec::Vec;

/// At most so many sources a quantity; a further one is not taken.
const MAX_SOURCES: usize = 8;

impl Picture {
    /// Folds one line. The result depends on the arguments and the earlier lines alone.
    pub fn fold(&mut self, at: Stamp, port: PortIndex, dir: Direction, text: &[u8]) {
        let profile = self.ports.get(port).map(|setup| setup.profile);
        if dir == Direction::Out && profile != Some(Profile::Ecdis) {
            // Nothing of it is kept: it need not be read.
            if let Some(count) = self.counts.get_mut(port) {
                count.sent += 1;
            }
            return;
        }
        let sentence = nmea::decode(text);
        self.fold_sentence(at, port, dir, &sentence);
    }

    /// Folds one decoded line. True where the port's policy accepts it.
    pub fn fold_sentence(
        &mut self,
        at: Stamp,
        port: PortIndex,
        dir: Direction,
        sentence: &Sentence<'_>,
    ) -> bool {
        let (Some(setup), Some(count)) = (self.ports.get(port), self.counts.get_mut(port)) else {
            return false;
        };
        let profile = setup.profile;
        if dir == Direction::Out {
            count.sent += 1;
        } else {
            if sentence.formatter.is_empty() {
                count.garbage += 1;
                return false;
            }
            if !accepted(setup.checksum, sentence.checksum, &mut count.learned) {
                count.bad_checksum += 1;
                return false;
            }
            count.heard += 1;
            count.last = Some(at);
        }
        let source = || Source {
            port,
            talker: sentence.talker().into(),
            formatter: sentence.formatter.into(),
        };
        let clean = sentence.faults().is_empty();
        match (dir, sentence.formatter) {
            (Direction::In, "HDT") if gives_heading(profile) => {
                let value = nmea::Hdt::from_sentence(sentence).and_then(|s| s.heading);
                hear(
                    &mut self.headings,
                    at,
                    source(),
                    value.filter(|_| clean).map(Heading::from_deg),
                );
            }
            (Direction::In, "THS") if gives_heading(profile) => {
                let view = nmea::Ths::from_sentence(sentence);
                let value = view
                    .filter(|s| clean && s.mode == Some(nmea::ThsMode::Autonomous))
                    .and_then(|s| s.heading);
                hear(
                    &mut self.headings,
                    at,
                    source(),
                    value.map(Heading::from_deg),
                );
            }
            (Direction::In, "ROT") if gives_heading(profile) || profile == Profile::Rot => {
                let value = nmea::Rot::from_sentence(sentence)
                    .filter(|s| clean && s.status == Some(nmea::DataStatus::Valid))
                    .and_then(|s| s.rate);
                hear(
                    &mut self.rates,
                    at,
                    source(),
                    value.map(RateOfTurn::from_deg_per_min),
                );
            }
            (Direction::In, "GLL") if matches!(profile, Profile::Gps | Profile::Ecdis) => {
                let value = nmea::Gll::from_sentence(sentence).filter(|s| {
                    clean
                        && s.status == Some(nmea::DataStatus::Valid)
                        && s.mode.is_none_or(nmea::ModeIndicator::valid)
                });
                let fix = value.and_then(|s| {
                    let corrected = s.mode.is_some_and(|mode| {
                        mode.valid() && mode != nmea::ModeIndicator::Autonomous
                    });
                    s.position.map(|position| Fix {
                        position,
                        corrected,
                    })
                });
                hear(&mut self.fixes, at, source(), fix);
            }
            (Direction::In, "VTG") if matches!(profile, Profile::Gps | Profile::Ecdis) => {
                let value = nmea::Vtg::from_sentence(sentence)
                    .filter(|s| clean && s.mode.is_none_or(nmea::ModeIndicator::valid));
                let ground = value.and_then(|s| {
                    let course = s.course_true.map(Course::from_deg);
                    s.speed_knots.map(|speed| Ground {
                        course,
                        speed: Speed::from_knots(speed),
                    })
                });
                hear(&mut self.grounds, at, source(), ground);
            }
            (Direction::In, "VHW") if matches!(profile, Profile::Log | Profile::Ecdis) => {
                let value = nmea::Vhw::from_sentence(sentence).and_then(|s| s.speed_knots);
                let speed = value.filter(|_| clean).map(Speed::from_knots);
                hear(&mut self.water_speeds, at, source(), speed);
            }
            (Direction::In, "RSA") if matches!(profile, Profile::Gear | Profile::Ecdis) => {
                let value = nmea::Rsa::from_sentence(sentence)
                    .filter(|s| clean && s.starboard_status == Some(nmea::DataStatus::Valid))
                    .and_then(|s| s.starboard);
                hear_one(
                    &mut self.rudder,
                    at,
                    source(),
                    value.map(RudderAngle::from_deg),
                );
            }
            (_, "ROR") if profile == Profile::Ecdis => {
                let value = nmea::Ror::from_sentence(sentence)
                    .filter(|s| clean && s.starboard_status == Some(nmea::DataStatus::Valid))
                    .and_then(|s| s.starboard);
                hear_one(
                    &mut self.order,
                    at,
                    source(),
                    value.map(RudderAngle::from_deg),
                );
            }
            (_, "HTD") if profile == Profile::Ecdis => {
                let view = Htd::from_sentence(sentence).filter(|_| clean);
                hear_one(&mut self.htd, at, source(), view);
            }
            (Direction::In, "HTC") if profile == Profile::Ecdis => {
                self.hear_htc(at, source(), sentence)
            }
            (Direction::In, "XTE") if profile == Profile::Ecdis => {
                let view = Xte::from_sentence(sentence)
                    .filter(|s| clean && measured(s.status, s.cycle_lock, s.mode));
                hear_one(&mut self.xte, at, source(), view);
            }
            (Direction::In, "PNEY,001") if profile == Profile::Ecdis => {
                let view = Pney1::from_sentence(sentence)
                    .filter(|s| clean && measured(s.status, s.cycle_lock, s.mode));
                hear_one(&mut self.pney1, at, source(), view);
            }
            (Direction::In, "PNEY,002") if profile == Profile::Ecdis => {
                let view = Pney2::from_sentence(sentence).filter(|_| clean);
                hear_one(&mut self.pney2, at, source(), view);
            }
            _ => {}
        }
        true
    }

    /// SEN-5: only a strict HTC renews the command; a refused one is kept with its reason.
    fn hear_htc(&mut self, at: Stamp, source: Source, sentence: &Sentence<'_>) {
        let Some(htc) = Htc::from_sentence(sentence) else {
            return;
        };
        let refusal = nmea::steering(sentence, true)
            .err()
            .map(|refusal| refusal.text);
        match (&mut self.htc, refusal) {
            (Some(heard), Some(refusal)) => {
                heard.refused = Some(at);
                heard.value.refusal = Some(refusal);
            }
            (slot, refusal) => {
                let refused = refusal.is_some().then_some(at);
                let value = Commanded { htc, refusal };
                *slot = Some(Heard {
                    value,
                    at,
                    refused,
                    source,
                });
            }
        }
    }
}

const fn gives_heading(profile: Profile) -> bool {
    matches!(
        profile,
        Profile::Gyro1 | Profile::Gyro2 | Profile::Thd | Profile::Ecdis
    )
}

/// SEN-2: whether the port's policy accepts the sentence.
fn accepted(policy: ChecksumPolicy, checksum: Checksum, learned: &mut bool) -> bool {
    match checksum {
        Checksum::Right { .. } => {
            *learned = true;
            true
        }
        Checksum::Wrong { .. } => false,
        Checksum::Missing { .. } => match policy {
            ChecksumPolicy::Required => false,
            ChecksumPolicy::Learned => !*learned,
            ChecksumPolicy::Optional => true,
        },
    }
}

/// AP-9, FA5: both status letters and the mode indicator must be valid.
fn measured(
    status: Option<nmea::DataStatus>,
    cycle_lock: Option<nmea::DataStatus>,
    mode: Option<nmea::ModeIndicator>,
) -> bool {
    status == Some(nmea::DataStatus::Valid)
        && cycle_lock != Some(nmea::DataStatus::Invalid)
        && mode.is_none_or(nmea::ModeIndicator::valid)
}

fn hear<T>(list: &mut Vec<Heard<T>>, at: Stamp, source: Source, value: Option<T>) {
    let index = list.iter().position(|heard| heard.source == source);
    match (index.and_then(|index| list.get_mut(index)), value) {
        (Some(heard), Some(value)) => {
            *heard = Heard {
                value,
                at,
                refused: None,
                source,
            }
        }
        (Some(heard), None) => heard.refused = Some(at),
        (None, Some(value)) => {
            if list.len() < MAX_SOURCES {
                list.push(Heard {
                    value,
                    at,
                    refused: None,
                    source,
                });
            }
        }
        (None, None) => {}
    }
}

fn hear_one<T>(slot: &mut Option<Heard<T>>, at: Stamp, source: Source, value: Option<T>) {
    match (slot.as_mut(), value) {
        (_, Some(value)) => {
            *slot = Some(Heard {
                value,
                at,
                refused: None,
                source,
            })
        }
        (Some(heard), None) => heard.refused = Some(at),
        (None, None) => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nmea::decode;

    /// SEN-2.
    #[test]
    fn each_policy_takes_what_it_says() {
        let check = |policy, lines: &[(&[u8], bool)]| {
            let mut learned = false;
            for (line, expect) in lines {
                let checksum = decode(line).checksum;
                assert_eq!(
                    accepted(policy, checksum, &mut learned),
                    *expect,
                    "{policy:?}"
                );
            }
        };
        let (right, wrong, missing, broken) = (
            b"$PEMC,00*37".as_slice(),
            b"$PEMC,00*38".as_slice(),
            b"$PEMC,00".as_slice(),
            b"$PEMC,00*3".as_slice(),
        );
        check(
            ChecksumPolicy::Required,
            &[(missing, false), (right, true), (wrong, false)],
        );
        check(
            ChecksumPolicy::Learned,
            &[
                (missing, true),
                (wrong, false),
                (missing, true),
                (right, true),
                (missing, false),
            ],
        );
        check(
            ChecksumPolicy::Optional,
            &[(right, true), (missing, true), (broken, false)],
        );
    }
}
