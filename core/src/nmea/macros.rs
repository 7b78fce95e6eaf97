//! The macros that turn one list into table, texts and typed views.

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
    (letters($e:ident, $n:literal)) => {
        $crate::nmea::table::Kind::Letters($e::LETTERS, $n)
    };
    (words($e:ident)) => {
        $crate::nmea::table::Kind::Words($e::WORDS)
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
    (letters($e:ident, $n:literal)) => {
        $e::MEANINGS
    };
    (words($e:ident)) => {
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
    (words $a:tt) => { Option<alloc::string::String> };
    (letters $a:tt) => { Option<alloc::string::String> };
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
            group: $crate::nmea::macros::group!($($repeat $ra { $(kind!($gk $ga),)* })?),
            tail: &[$($(kind!($tk $ta),)*)?],
            numbered: const { $crate::nmea::table::numbered(&[$(stringify!($m)),*]) },
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
                #[allow(unused_mut, unused_variables)]
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
                #[allow(unused_mut, unused_variables)]
                let mut out = alloc::vec::Vec::with_capacity(96);
                #[allow(unused_mut)]
                let mut writer = $crate::nmea::encode::Writer::new(&mut out, &$module::DEFINITION, talker);
                $( writer.put(self.$m.to_cell()); )*
                $( for entry in &self.$entries { writer.entry(); $( writer.put(entry.$gm.to_cell()); )* } )?
                $( writer.tail(); $( writer.put(self.$tm.to_cell()); )* )?
                writer.finish();
                $crate::nmea::encode::text(out)
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
