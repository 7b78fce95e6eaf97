//! What a table entry is made of, and the macros that turn one list into table, texts and typed view.

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
    /// A word with a meaning.
    Word(&'static [&'static str]),
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

macro_rules! kind {
    (number($f:expr)) => {
        $crate::nmea::table::Kind::Number($f)
    };
    (integer($f:expr)) => {
        $crate::nmea::table::Kind::Integer($f)
    };
    (lettered($f:expr, $l:literal)) => {
        $crate::nmea::table::Kind::Lettered($f, $l)
    };
    (sided($f:expr, $s:expr)) => {
        $crate::nmea::table::Kind::Sided($f, $s)
    };
    (crossed($f:expr, $s:expr, $l:literal)) => {
        $crate::nmea::table::Kind::Crossed($f, $s, $l)
    };
    (code($e:ident)) => {
        $crate::nmea::table::Kind::Code($e::LETTERS)
    };
    (word($e:ident)) => {
        $crate::nmea::table::Kind::Word($e::WORDS)
    };
    (text($n:literal)) => {
        $crate::nmea::table::Kind::Text($n)
    };
    (position($d:literal)) => {
        $crate::nmea::table::Kind::Position($d)
    };
    (latitude($d:literal)) => {
        $crate::nmea::table::Kind::Angle {
            degrees: 2,
            decimals: $d,
        }
    };
    (longitude($d:literal)) => {
        $crate::nmea::table::Kind::Angle {
            degrees: 3,
            decimals: $d,
        }
    };
    (time()) => {
        $crate::nmea::table::Kind::Time
    };
    (date()) => {
        $crate::nmea::table::Kind::Date
    };
    (hex($n:literal)) => {
        $crate::nmea::table::Kind::Hex($n)
    };
    (payload()) => {
        $crate::nmea::table::Kind::Payload
    };
    (any()) => {
        $crate::nmea::table::Kind::Any
    };
}

macro_rules! meanings {
    (code($e:ident)) => {
        $e::MEANINGS
    };
    (word($e:ident)) => {
        $e::MEANINGS
    };
    ($k:ident $a:tt) => {
        &[]
    };
}

macro_rules! view_type {
    (integer $a:tt) => { Option<u32> };
    (hex $a:tt) => { Option<u32> };
    (code($e:ident)) => { Option<$e> };
    (word $a:tt) => { Option<alloc::string::String> };
    (text $a:tt) => { Option<alloc::string::String> };
    (payload $a:tt) => { Option<alloc::string::String> };
    (any $a:tt) => { Option<alloc::string::String> };
    (position $a:tt) => { Option<$crate::geo::Position> };
    (time $a:tt) => { Option<$crate::nmea::UtcTime> };
    (date $a:tt) => { Option<$crate::nmea::Date> };
    ($k:ident $a:tt) => { Option<f64> };
}

/// Makes definition and texts of one sentence.
macro_rules! definition {
    ($formatter:literal $delimiter:literal [$($length:literal),*] $title:literal, $source:literal {
        $($m:ident : $k:ident $a:tt $note:literal),* $(,)?
        $(; later { $($lm:ident : $lk:ident $la:tt $lnote:literal),* $(,)? })?
        $(; each $repeat:ident $ra:tt $entry:ident $entries:ident { $($gm:ident : $gk:ident $ga:tt $gnote:literal),* $(,)? })?
        $(; tail { $($tm:ident : $tk:ident $ta:tt $tnote:literal),* $(,)? })?
    }) => {
        pub(crate) static DEFINITION: $crate::nmea::Definition = $crate::nmea::Definition {
            formatter: $formatter,
            key: $crate::nmea::table::key($formatter.as_bytes()),
            delimiter: $delimiter,
            lengths: &[$($length),*],
            members: &[$(kind!($k $a),)* $($(kind!($lk $la),)*)?],
            group: $crate::nmea::table::group!($($repeat $ra { $(kind!($gk $ga),)* })?),
            tail: &[$($(kind!($tk $ta),)*)?],
        };
        pub(crate) static TEXT: $crate::nmea::table::SentenceText = $crate::nmea::table::SentenceText {
            title: $title,
            source: $source,
            members: &[
                $($crate::nmea::table::MemberText { name: stringify!($m), note: $note, meanings: meanings!($k $a) },)*
                $($($crate::nmea::table::MemberText { name: stringify!($lm), note: $lnote, meanings: meanings!($lk $la) },)*)?
            ],
            group: &[$($($crate::nmea::table::MemberText { name: stringify!($gm), note: $gnote, meanings: meanings!($gk $ga) },)*)?],
            tail: &[$($($crate::nmea::table::MemberText { name: stringify!($tm), note: $tnote, meanings: meanings!($tk $ta) },)*)?],
        };
    };
}

macro_rules! group {
    () => { None };
    (Open() { $($kind:expr),* $(,)? }) => {
        Some($crate::nmea::table::Group { members: &[$($kind),*], repeat: $crate::nmea::table::Repeat::Open })
    };
    ($repeat:ident ($n:literal) { $($kind:expr),* $(,)? }) => {
        Some($crate::nmea::table::Group { members: &[$($kind),*], repeat: $crate::nmea::table::Repeat::$repeat($n) })
    };
}

/// Makes the typed view of one sentence.
macro_rules! view {
    ($view:ident $module:ident $formatter:literal $title:literal {
        $($m:ident : $k:ident $a:tt $note:literal),* $(,)?
        $(; later $later:tt)?
        $(; each $repeat:ident $ra:tt $entry:ident $entries:ident { $($gm:ident : $gk:ident $ga:tt $gnote:literal),* $(,)? })?
        $(; tail { $($tm:ident : $tk:ident $ta:tt $tnote:literal),* $(,)? })?
    }) => {
        #[doc = concat!($formatter, ": ", $title, ".")]
        #[derive(Clone, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
        pub struct $view {
            $( #[doc = $note] pub $m: view_type!($k $a), )*
            $( #[doc = concat!("Each ", stringify!($entry), ".")] pub $entries: alloc::vec::Vec<$entry>, )?
            $( $( #[doc = $tnote] pub $tm: view_type!($tk $ta), )* )?
        }
        impl $view {
            /// The formatter that it is a view of.
            pub const FORMATTER: &'static str = $formatter;
            /// The view of a sentence; none where it has another formatter. Faulty fields are absent.
            #[must_use]
            pub fn from_sentence(sentence: &$crate::nmea::Sentence<'_>) -> Option<Self> {
                #[allow(unused_mut)]
                let mut reader = $crate::nmea::view::Reader::new(sentence, &$module::DEFINITION)?;
                Some(Self {
                    $( $m: reader.take(), )*
                    $( $entries: reader.entries(|reader| $entry { $( $gm: reader.take(), )* }), )?
                    $( $( $tm: reader.take(), )* )?
                })
            }
            /// The line with its checksum, without CR LF.
            #[must_use]
            pub fn line(&self, talker: &str) -> alloc::string::String {
                #[allow(unused_imports)]
                use $crate::nmea::view::ToCell;
                #[allow(unused_mut)]
                let mut writer = $crate::nmea::encode::Writer::new(&$module::DEFINITION, talker);
                $( writer.put(self.$m.to_cell()); )*
                $( for entry in &self.$entries { writer.entry(); $( writer.put(entry.$gm.to_cell()); )* } )?
                $( writer.tail(); $( writer.put(self.$tm.to_cell()); )* )?
                writer.finish()
            }
        }
        $(
            #[doc = concat!("One of the entries of ", $formatter, ".")]
            #[derive(Clone, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
            pub struct $entry {
                $( #[doc = $gnote] pub $gm: view_type!($gk $ga), )*
            }
        )?
    };
}

/// A list of sentences: `module [as View] = "FMT" delimiter [lengths] "title", "source" { members }`.
macro_rules! sentences {
    ($( $module:ident $(as $view:ident)? = $formatter:literal $delimiter:literal $lengths:tt $title:literal, $source:literal $body:tt )+) => {
        $(
            pub(crate) mod $module {
                #[allow(unused_imports)]
                use super::*;
                definition! { $formatter $delimiter $lengths $title, $source $body }
            }
            $( view! { $view $module $formatter $title $body } )?
        )+
        pub(crate) const DEFINITIONS: &[&$crate::nmea::Definition] = &[$(&$module::DEFINITION),+];
        pub(crate) const TEXTS: &[&$crate::nmea::table::SentenceText] = &[$(&$module::TEXT),+];
    };
}

pub(crate) use {definition, group, kind, meanings, sentences, view, view_type};
