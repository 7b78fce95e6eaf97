//! Which sentences of a port are believed: the checksum policy (SEN-2).

use super::{Checksum, Sentence};
use crate::station::ChecksumPolicy;
use serde::{Deserialize, Serialize};

/// The checksum policy of a port, with what it has learned.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ChecksumGate {
    policy: ChecksumPolicy,
    learned: bool,
}

impl ChecksumGate {
    /// A gate that has heard nothing yet.
    #[must_use]
    pub const fn new(policy: ChecksumPolicy) -> Self {
        Self {
            policy,
            learned: false,
        }
    }

    /// Whether the sentence may be used. A wrong checksum never passes; a missing one by the policy.
    pub fn accepts(&mut self, sentence: &Sentence<'_>) -> bool {
        match sentence.checksum {
            Checksum::Right(_) => {
                self.learned = true;
                true
            }
            Checksum::Wrong { .. } => false,
            Checksum::Missing { .. } => match self.policy {
                ChecksumPolicy::Required => false,
                ChecksumPolicy::Learned => !self.learned,
                ChecksumPolicy::Optional => true,
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nmea::decode;

    #[test]
    fn each_policy_takes_what_it_says() {
        let check = |policy, lines: &[(&[u8], bool)]| {
            let mut gate = ChecksumGate::new(policy);
            for (line, expect) in lines {
                assert_eq!(gate.accepts(&decode(line)), *expect, "{policy:?}");
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
