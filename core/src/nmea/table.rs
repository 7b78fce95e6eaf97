//! What a table entry is made of.

/// A sentence of the dictionary: its fields, without their texts.
#[derive(Debug)]
pub struct Definition {
    /// `HTC`, or with its sub-address `PNEY,001`.
    pub formatter: &'static str,
    pub(crate) key: u32,
    pub(crate) delimiter: u8,
    /// Accepted numbers of fields; the first is the one that is sent.
    pub(crate) lengths: &'static [u8],
    pub(crate) members: &'static [Kind],
    pub(crate) group: Option<Group>,
    pub(crate) tail: &'static [Kind],
    /// Whether it begins with the number of sentences of its message and its own among them.
    pub(crate) numbered: bool,
}

/// Members that stand several times.
#[derive(Debug)]
pub(crate) struct Group {
    pub(crate) members: &'static [Kind],
    pub(crate) repeat: Repeat,
}

/// How often a group stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Repeat {
    /// At most so often; missing ones are null (GSV).
    UpTo(u8),
    /// As often as the field with this index (from 0) says (ALC).
    Counted(u8),
    /// To the end of the line (XDR).
    Open,
}

/// Unit of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// A bare number.
    None,
    /// Degrees of arc.
    Degrees,
    /// Degrees a minute.
    DegreesPerMinute,
    /// Nautical miles.
    NauticalMiles,
    /// Kilometres.
    Kilometres,
    /// Metres.
    Metres,
    /// Feet.
    Feet,
    /// Fathoms.
    Fathoms,
    /// Knots.
    Knots,
    /// Kilometres an hour.
    KilometresPerHour,
    /// Metres a second.
    MetresPerSecond,
    /// Degrees Celsius.
    Celsius,
    /// Bars.
    Bars,
    /// Inches of mercury.
    InchesOfMercury,
    /// Per cent.
    Percent,
    /// Hertz and its multiples, as the field says.
    Kilohertz,
    /// Milliseconds.
    Milliseconds,
    /// Seconds.
    Seconds,
    /// Minutes of time.
    Minutes,
    /// Hours.
    Hours,
    /// Minutes of arc.
    ArcMinutes,
    /// Decibels.
    Decibels,
    /// Bits a second.
    BitsPerSecond,
    /// Revolutions a minute.
    RevolutionsPerMinute,
}

impl Unit {
    /// Its name as it is shown; none for a bare number.
    #[must_use]
    pub const fn name(self) -> Option<&'static str> {
        Some(match self {
            Self::None => return None,
            Self::Degrees => "deg",
            Self::DegreesPerMinute => "deg/min",
            Self::NauticalMiles => "nm",
            Self::Kilometres => "km",
            Self::Metres => "m",
            Self::Feet => "ft",
            Self::Fathoms => "fathoms",
            Self::Knots => "kn",
            Self::KilometresPerHour => "km/h",
            Self::MetresPerSecond => "m/s",
            Self::Celsius => "°C",
            Self::Bars => "bar",
            Self::InchesOfMercury => "inHg",
            Self::Percent => "%",
            Self::Kilohertz => "kHz",
            Self::Milliseconds => "ms",
            Self::Seconds => "s",
            Self::Minutes => "min",
            Self::Hours => "h",
            Self::ArcMinutes => "arc min",
            Self::Decibels => "dB",
            Self::BitsPerSecond => "bit/s",
            Self::RevolutionsPerMinute => "rev/min",
        })
    }
}

/// Unit, range and digits of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Format {
    /// Its unit.
    pub unit: Unit,
    /// Least value of the standard.
    pub low: i32,
    /// Greatest value of the standard; `i32::MAX` where it has none.
    pub high: i32,
    /// Digits sent before the point, at least.
    pub whole: u8,
    /// Decimals sent (SEN-9).
    pub decimals: u8,
}

impl Format {
    pub(crate) const fn new(unit: Unit, low: i32, high: i32, whole: u8, decimals: u8) -> Self {
        Self {
            unit,
            low,
            high,
            whole,
            decimals,
        }
    }
}

/// Letters of the side of a magnitude.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sides {
    /// Port, west, south.
    pub negative: u8,
    /// Starboard, east, north.
    pub positive: u8,
}

/// What a member is; it may span several wire fields.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A number.
    Number(Format),
    /// A whole number.
    Integer(Format),
    /// A number and the letter that fixes its unit or reference.
    Lettered(Format, u8),
    /// A magnitude and its side.
    Sided(Format, Sides),
    /// A magnitude, its side and the letter that fixes its unit.
    Crossed(Format, Sides, u8),
    /// A letter with a meaning.
    Code(&'static [u8]),
    /// At most so many letters, each with a meaning.
    Letters(&'static [u8], u8),
    /// One of these words.
    Words(&'static [&'static str]),
    /// Text of at most so many characters.
    Text(u8),
    /// Latitude, N/S, longitude, E/W.
    Position(u8),
    /// Latitude and N/S alone, or longitude and E/W alone.
    Angle {
        /// Digits of the degrees: 2 for a latitude, 3 for a longitude.
        degrees: u8,
        /// Decimals sent.
        decimals: u8,
    },
    /// hhmmss.ss.
    Time,
    /// ddmmyy.
    Date,
    /// A hexadecimal number of so many digits.
    Hex(u8),
    /// Six-bit armoured data.
    Payload,
    /// A field that is reserved or free.
    Any,
}

impl Kind {
    /// How many wire fields it spans.
    #[must_use]
    pub const fn width(&self) -> usize {
        match self {
            Self::Lettered(..) | Self::Sided(..) | Self::Angle { .. } => 2,
            Self::Crossed(..) => 3,
            Self::Position(_) => 4,
            _ => 1,
        }
    }
}

const fn width_of(members: &[Kind]) -> usize {
    let mut sum = 0;
    let mut i = 0;
    while i < members.len() {
        sum += members[i].width();
        i += 1;
    }
    sum
}

/// Whether the first two members are called `total` and `number`.
pub(crate) const fn numbered(names: &[&str]) -> bool {
    const fn same(a: &str, b: &str) -> bool {
        let (a, b) = (a.as_bytes(), b.as_bytes());
        let mut same = a.len() == b.len();
        let mut i = 0;
        while same && i < a.len() {
            same = a[i] == b[i];
            i += 1;
        }
        same
    }
    names.len() > 1 && same(names[0], "total") && same(names[1], "number")
}

impl Group {
    pub(crate) const fn width(&self) -> usize {
        width_of(self.members)
    }
}

impl Definition {
    /// Index of the first field that belongs to a member: the sub-address is field 1 where there is one.
    pub(crate) const fn first(&self) -> usize {
        (self.formatter.len() > 4) as usize
    }
    /// Fields before the group.
    pub(crate) const fn fixed_width(&self) -> usize {
        self.first() + width_of(self.members)
    }
    pub(crate) const fn tail_width(&self) -> usize {
        width_of(self.tail)
    }
    /// The number of fields that is sent where no group follows.
    pub(crate) const fn sent(&self) -> usize {
        if self.lengths.is_empty() {
            self.fixed_width()
        } else {
            self.lengths[0] as usize
        }
    }
}

/// Texts of a sentence, apart from the table so that a page without explanations leaves them out.
#[derive(Debug)]
pub(crate) struct SentenceText {
    pub(crate) title: &'static str,
    pub(crate) source: &'static str,
    pub(crate) members: &'static [MemberText],
    pub(crate) group: &'static [MemberText],
    pub(crate) tail: &'static [MemberText],
}

/// Texts of a member.
#[derive(Debug)]
pub(crate) struct MemberText {
    pub(crate) name: &'static str,
    /// What it is and what this interface does with it.
    pub(crate) note: &'static str,
    /// Meanings of its codes, in the order of the codes.
    pub(crate) meanings: &'static [&'static str],
}

/// Three letters in one number.
pub(crate) const fn key(formatter: &[u8]) -> u32 {
    if formatter.len() == 3 {
        (formatter[0] as u32) << 16 | (formatter[1] as u32) << 8 | formatter[2] as u32
    } else {
        0
    }
}
