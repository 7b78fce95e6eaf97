//! The table: station, port, sentence, talker, and when it is said.

use crate::nmea::{self, Definition};
use crate::station::{Profile, Role};

/// The period of what is said once a second, milliseconds.
pub const SECOND_MS: u64 = 1_000;

/// The period of what a hand unit is told by itself (EMC-2, EMC-4), milliseconds.
pub const HAND_UNIT_MS: u64 = 5_000;

/// The period of HMS (AP-10), milliseconds.
pub const HMS_MS: u64 = 30_000;

/// When a sentence is said.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum When {
    /// Once in so many milliseconds.
    Every(u64),
    /// On each change, and once in so many milliseconds.
    Renewed(u64),
    /// With each control step (AP-15).
    Step,
    /// When what it reports has changed or a command is refused, within the share of the line (AP-11).
    Change,
    /// When an officer acknowledges, or a list names what is not known.
    Asked,
    /// When a hand unit asks for it (EMC-2).
    Requested,
    /// When an officer operates the station, where that is asked for (TCS-13).
    Operated,
}

macro_rules! sayings {
    ($($name:ident $sentence:ident),* $(,)?) => {
        /// A sentence that a station says.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[allow(missing_docs)]
        pub enum Saying { $($name,)* }

        impl Saying {
            /// Its entry in the dictionary.
            #[must_use]
            pub const fn definition(self) -> &'static Definition {
                match self { $(Self::$name => &nmea::$sentence::DEFINITION,)* }
            }
        }
    };
}

sayings! {
    Ack ack, Acn acn, Ala ala, Alc alc, Alf alf, Alr alr, Arc arc, Eve eve, Gll gll, Hbt hbt, Hdg hdg, Hdm hdm, Hdt hdt, Hmr hmr, Hms hms, Htc htc, Htd htd, Mwv mwv, Pemc03 pemc03, Pemc05 pemc05, Pemc07 pemc07, Pney1 pney1, Pney2 pney2, Ror ror, Rot rot, Rsa rsa, Vhw vhw, Vtg vtg, Xdr xdr,
    Xte xte,
}

/// A sentence of a station on a port.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Row {
    /// Which sentence.
    pub saying: Saying,
    /// As whom (SEN-3); none where it is passed on with the talker of its source.
    pub talker: Option<&'static str>,
    /// When.
    pub when: When,
    /// Fields that name what it reports, from 1: each thing has its own place in what waits to be sent (FB11).
    pub of: &'static [usize],
}

impl Row {
    /// Formatter of the sentence.
    #[must_use]
    pub const fn formatter(&self) -> &'static str {
        self.saying.definition().formatter
    }

    /// Its period in milliseconds; none where it follows control steps or events.
    #[must_use]
    pub const fn period_ms(&self) -> Option<u64> {
        match self.when {
            When::Every(period) => Some(period),
            When::Renewed(_)
            | When::Step
            | When::Change
            | When::Asked
            | When::Requested
            | When::Operated => None,
        }
    }
}

/// What a station says on ports of some profiles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Told {
    /// Who.
    pub station: Role,
    /// Where.
    pub profiles: &'static [Profile],
    /// What, in the order in which it is said.
    pub rows: &'static [Row],
}

const SECOND: When = When::Every(SECOND_MS);
const TENTH: When = When::Every(100);
const HALF_MINUTE: When = When::Every(30_000);

const fn row(saying: Saying, talker: &'static str, when: When) -> Row {
    Row {
        saying,
        talker: Some(talker),
        when,
        of: &[],
    }
}

/// Each thing that those fields name has its own place.
const fn each(row: Row, of: &'static [usize]) -> Row {
    Row { of, ..row }
}

const HTD: Row = row(Saying::Htd, "AG", SECOND);
const RSA: Row = row(Saying::Rsa, "AG", SECOND);
const ROR: Row = row(Saying::Ror, "AG", SECOND);
/// AP-10: HMS on change and each 30 s.
const HMR: Row = row(Saying::Hmr, "AG", SECOND);
const HMS: Row = row(Saying::Hms, "AG", When::Renewed(HMS_MS));
/// AP-12.
const HDT: Row = of_its_source(Saying::Hdt);

/// Passed on with the talker of its source.
const fn of_its_source(saying: Saying) -> Row {
    Row {
        saying,
        talker: None,
        when: SECOND,
        of: &[],
    }
}

/// Reports of alerts by number (AP-11).
const fn alr(talker: &'static str) -> Row {
    each(row(Saying::Alr, talker, When::Change), &[2])
}

/// What bridge alert management is told; IEC 62923-1: the list and the heartbeat at least once in 30 s.
const fn to_management(talker: &'static str) -> [Row; 4] {
    [
        each(row(Saying::Alf, talker, When::Change), &[9, 2]),
        each(row(Saying::Alc, talker, HALF_MINUTE), &[2]),
        each(row(Saying::Arc, talker, When::Change), &[3, 5]),
        row(Saying::Hbt, talker, HALF_MINUTE),
    ]
}

/// The table.
pub static TABLE: &[Told] = &[
    Told {
        station: Role::Autopilot,
        profiles: &[Profile::Ecdis],
        rows: &[
            HTD,
            RSA,
            ROR,
            HDT,
            HMR,
            HMS,
            alr("AG"),
            each(row(Saying::Ala, "AG", When::Change), &[5]),
        ],
    },
    Told {
        station: Role::Autopilot,
        profiles: &[Profile::Bams],
        rows: &const { to_management("AG") },
    },
    Told {
        station: Role::Autopilot,
        profiles: &[Profile::Monitor],
        rows: &[HTD, RSA, ROR, HDT, HMR],
    },
    Told {
        station: Role::Autopilot,
        profiles: &[Profile::Stand],
        rows: &[HTD],
    },
    Told {
        station: Role::Autopilot,
        profiles: &[Profile::Plotter],
        rows: &[
            of_its_source(Saying::Hdg),
            of_its_source(Saying::Hdm),
            HDT,
            RSA,
            row(Saying::Xdr, "AG", SECOND),
        ],
    },
    Told {
        station: Role::Autopilot,
        profiles: &[Profile::Hmi],
        rows: &[
            row(Saying::Pemc07, "P", When::Every(HAND_UNIT_MS)),
            row(Saying::Pemc03, "P", When::Requested),
            row(Saying::Pemc05, "P", When::Requested),
        ],
    },
    Told {
        station: Role::Autopilot,
        profiles: &[Profile::Gear],
        rows: &[row(Saying::Ror, "AG", When::Step)],
    },
    Told {
        station: Role::ChartSystem,
        profiles: &[Profile::Ecdis],
        rows: &[
            row(Saying::Htc, "EI", SECOND),
            row(Saying::Xte, "EI", SECOND),
            row(Saying::Pney1, "P", SECOND),
            row(Saying::Pney2, "P", SECOND),
            row(Saying::Gll, "EI", SECOND),
            row(Saying::Vtg, "EI", SECOND),
            row(Saying::Vhw, "EI", SECOND),
            each(row(Saying::Ack, "EI", When::Asked), &[1]),
            each(row(Saying::Acn, "EI", When::Asked), &[3, 5]),
        ],
    },
    Told {
        station: Role::ChartSystem,
        profiles: &[Profile::Bams],
        rows: &const {
            let [alf, alc, arc, hbt] = to_management("EI");
            let eve = row(Saying::Eve, "EI", When::Operated);
            [alf, alc, arc, hbt, eve]
        },
    },
    Told {
        station: Role::ChartSystem,
        profiles: &[Profile::Monitor],
        rows: &[alr("EI")],
    },
    Told {
        station: Role::World,
        profiles: &[Profile::Gyro1],
        rows: &[row(Saying::Hdt, "HE", TENTH), row(Saying::Rot, "HE", TENTH)],
    },
    Told {
        station: Role::World,
        profiles: &[Profile::Gear],
        rows: &[row(Saying::Rsa, "II", TENTH)],
    },
    Told {
        station: Role::World,
        profiles: &[Profile::Gps],
        rows: &[
            row(Saying::Gll, "GP", SECOND),
            row(Saying::Vtg, "GP", SECOND),
        ],
    },
    Told {
        station: Role::World,
        profiles: &[Profile::Log],
        rows: &[row(Saying::Vhw, "VD", SECOND)],
    },
    Told {
        station: Role::World,
        profiles: &[Profile::Wind],
        rows: &[
            // Apparent and true in turn, each once a second.
            each(row(Saying::Mwv, "WI", When::Every(SECOND_MS / 2)), &[2]),
        ],
    },
];

/// What a station says on a port of a profile, in the order in which it is said.
#[must_use]
pub fn told(station: Role, profile: Profile) -> &'static [Row] {
    let mut all = TABLE.iter();
    all.find(|told| told.station == station && told.profiles.contains(&profile))
        .map_or(&[], |told| told.rows)
}
