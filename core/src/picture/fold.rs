//! The fold: what each sentence on each kind of port changes in the picture (FE11, SEN-2, SEN-5).

use super::{Commanded, Heard, Picture, Source};
use crate::facts::facts;
use crate::facts::ports::{believes, is_pictured};
use crate::facts::read::{self, Reading};
use crate::nmea::{self, Checksum, Definition, Htc, Sentence};
use crate::station::{ChecksumPolicy, Direction, PortIndex, Profile};
use crate::time::Stamp;
use alloc::vec::Vec;

/// At most so many sources a quantity; a further one is not taken.
const MAX_SOURCES: usize = 16;

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

    /// Folds one decoded line. True where the port's policy accepts it and the port may say it.
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
        let stranger = !setup.listens_to(sentence.talker());
        if dir == Direction::Out {
            count.sent += 1;
        } else {
            if sentence.formatter.is_empty() || !sentence.begins() {
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
        if dir == Direction::In
            && (stranger || !believes(self.station, profile, sentence.formatter))
        {
            self.counts[port].unused += 1;
            return false;
        }
        let pictured = is_pictured(profile, sentence.formatter);
        let Some(known) = sentence.known.filter(|_| pictured) else {
            return true;
        };
        let clean = sentence.faults().is_empty();
        match dir {
            Direction::In => self.take(at, port, sentence, known, clean),
            Direction::Out if profile == Profile::Ecdis => {
                self.take_own(at, port, sentence, known, clean)
            }
            Direction::Out => {}
        }
        true
    }

    /// SEN-5: only a strict HTC renews the command; a refused one is kept with its reason.
    fn hear_htc(&mut self, at: Stamp, source: Source, sentence: &Sentence<'_>) {
        let Some(htc) = Htc::from_sentence(sentence) else {
            return;
        };
        let refusal = crate::command::htc(sentence, true)
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
                    not_valid: None,
                    source,
                });
            }
        }
    }
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

/// Where the values of a fact are kept.
trait Store<T> {
    fn hear(&mut self, at: Stamp, source: Source, reading: Reading<T>);
}

impl<T> Store<T> for Vec<Heard<T>> {
    fn hear(&mut self, at: Stamp, source: Source, reading: Reading<T>) {
        let room = self.len() < MAX_SOURCES;
        let known = self.iter_mut().find(|heard| heard.source == source);
        match (known, reading) {
            (Some(heard), Reading::Value(value)) => *heard = Heard::new(value, at, source),
            (None, Reading::Value(value)) if room => {
                self.push(Heard::new(value, at, source));
            }
            (Some(heard), Reading::NotValid) => heard.not_valid = Some(at),
            (Some(_), Reading::Null) | (None, _) => {}
        }
    }
}

impl<T> Store<T> for Option<Heard<T>> {
    fn hear(&mut self, at: Stamp, source: Source, reading: Reading<T>) {
        match (self.as_mut(), reading) {
            (_, Reading::Value(value)) => *self = Some(Heard::new(value, at, source)),
            (Some(heard), Reading::NotValid) => heard.not_valid = Some(at),
            (Some(_), Reading::Null) | (None, _) => {}
        }
    }
}

/// Takes a reading into its place in the picture.
macro_rules! take {
    (command $field:ident $picture:ident $at:ident $source:ident $sentence:ident $clean:ident $read:path) => {
        $picture.hear_htc($at, $source, $sentence)
    };
    (report $field:ident $picture:ident $at:ident $source:ident $sentence:ident $clean:ident $read:path) => {{
        let reading = if $clean {
            $read($sentence)
        } else {
            Reading::Null
        };
        if let (Some(heard), Reading::NotValid | Reading::Null) = (&mut $picture.$field, &reading) {
            heard.refused = Some($at);
        }
        $picture.$field.hear($at, $source, reading)
    }};
    ($kind:ident $field:ident $picture:ident $at:ident $source:ident $sentence:ident $clean:ident $read:path) => {
        $picture.$field.hear(
            $at,
            $source,
            if $clean {
                $read($sentence)
            } else {
                Reading::Null
            },
        )
    };
}

/// Makes the fold from the table of facts.
macro_rules! fold {
    ($($(#[$doc:meta])* $field:ident: $kind:ident $type:ty { $($name:ident: $read:path),* } $(own { $($own:ident: $own_read:path),* })?;)*) => {
        impl Picture {
            /// What was heard.
            fn take(&mut self, at: Stamp, port: PortIndex, sentence: &Sentence<'_>, known: &Definition, clean: bool) {
                $($(if core::ptr::eq(known, &nmea::$name::DEFINITION) {
                    let source = source(port, sentence);
                    take!($kind $field self at source sentence clean $read);
                })*)*
            }

            /// What the station said itself.
            fn take_own(&mut self, at: Stamp, port: PortIndex, sentence: &Sentence<'_>, known: &Definition, clean: bool) {
                $($($(if core::ptr::eq(known, &nmea::$own::DEFINITION) {
                    let source = source(port, sentence);
                    take!($kind $field self at source sentence clean $own_read);
                })*)?)*
            }
        }
    };
}

facts!(fold);

fn source(port: PortIndex, sentence: &Sentence<'_>) -> Source {
    Source {
        port,
        talker: sentence.talker().into(),
        formatter: sentence.formatter.into(),
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
