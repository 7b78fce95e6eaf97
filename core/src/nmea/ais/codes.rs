//! Meanings of the codes of ITU-R M.1371, by their numbers.

/// A function from a list: value and meaning.
macro_rules! meanings {
    ($( $(#[$doc:meta])* $name:ident { $( $value:pat => $meaning:literal ),+ $(,)? } )+) => {$(
        $(#[$doc])*
        pub(super) const fn $name(value: u32) -> Option<&'static str> {
            Some(match value {
                $( $value => $meaning, )+
                #[allow(unreachable_patterns)]
                _ => return None,
            })
        }
    )+};
}

meanings! {
    navigational_status {
        0 => "under way using engine", 1 => "at anchor", 2 => "not under command", 3 => "restricted manoeuvrability",
        4 => "constrained by her draught", 5 => "moored", 6 => "aground", 7 => "engaged in fishing", 8 => "under way sailing",
        9 => "reserved, high-speed craft", 10 => "reserved, wing in ground", 11 => "power-driven vessel towing astern",
        12 => "power-driven vessel pushing ahead or towing alongside", 13 => "reserved",
        14 => "AIS-SART, MOB-AIS or EPIRB-AIS active", 15 => "not defined",
    }
    special_manoeuvre { 1 => "not engaged in special manoeuvre", 2 => "engaged in special manoeuvre" }
    accuracy { 0 => "low, over 10 m", 1 => "high, 10 m or better" }
    time_stamp {
        61 => "positioning system in manual input mode", 62 => "positioning system in estimated mode (dead reckoning)",
        63 => "positioning system inoperative",
    }
    altitude_sensor { 0 => "GNSS", 1 => "barometric" }
    position_fixing {
        0 => "undefined", 1 => "GPS", 2 => "GLONASS", 3 => "combined GPS and GLONASS", 4 => "Loran-C", 5 => "Chayka",
        6 => "integrated navigation system", 7 => "surveyed", 8 => "Galileo", 15 => "internal GNSS",
    }
    terminal { 0 => "keyboard and display available", 1 => "not available" }
    repeat { 0 => "not repeated", 3 => "do not repeat any more" }
    edition {
        0 => "ITU-R M.1371-1", 1 => "ITU-R M.1371-3", 2 => "ITU-R M.1371-5", 3 => "a later edition",
    }
    sync {
        0 => "UTC direct", 1 => "UTC indirect", 2 => "synchronised to a base station", 3 => "synchronised to another station",
    }
    class_b_unit { 0 => "SOTDMA unit", 1 => "carrier-sense unit" }
    state_selector { 0 => "SOTDMA", 1 => "ITDMA" }
    ship_type {
        20 => "wing in ground", 21..=24 => "wing in ground, dangerous cargo", 25..=29 => "wing in ground",
        30 => "fishing", 31 => "towing", 32 => "towing, over 200 m long or 25 m wide", 33 => "dredging or underwater operations",
        34 => "diving operations", 35 => "military operations", 36 => "sailing", 37 => "pleasure craft",
        40 => "high-speed craft", 41..=44 => "high-speed craft, dangerous cargo", 45..=49 => "high-speed craft",
        50 => "pilot vessel", 51 => "search and rescue", 52 => "tug", 53 => "port tender", 54 => "anti-pollution",
        55 => "law enforcement", 56 | 57 => "spare, local", 58 => "medical transport", 59 => "not party to an armed conflict",
        60 => "passenger", 61..=64 => "passenger, dangerous cargo", 65..=69 => "passenger",
        70 => "cargo", 71..=74 => "cargo, dangerous", 75..=79 => "cargo",
        80 => "tanker", 81..=84 => "tanker, dangerous cargo", 85..=89 => "tanker",
        90 => "other", 91..=94 => "other, dangerous cargo", 95..=99 => "other",
        0..=19 | 38 | 39 => "reserved", 100..=199 => "reserved, regional", _ => "reserved",
    }
    aid_type {
        1 => "reference point", 2 => "racon", 3 => "fixed structure off shore", 4 => "emergency wreck marking buoy",
        5 => "light without sectors", 6 => "light with sectors", 7 => "leading light, front", 8 => "leading light, rear",
        9 => "beacon, cardinal north", 10 => "beacon, cardinal east", 11 => "beacon, cardinal south", 12 => "beacon, cardinal west",
        13 => "beacon, port hand", 14 => "beacon, starboard hand", 15 => "beacon, preferred channel port hand",
        16 => "beacon, preferred channel starboard hand", 17 => "beacon, isolated danger", 18 => "beacon, safe water",
        19 => "beacon, special mark", 20 => "floating, cardinal north", 21 => "floating, cardinal east",
        22 => "floating, cardinal south", 23 => "floating, cardinal west", 24 => "floating, port hand mark",
        25 => "floating, starboard hand mark", 26 => "floating, preferred channel port hand",
        27 => "floating, preferred channel starboard hand", 28 => "floating, isolated danger", 29 => "floating, safe water",
        30 => "floating, special mark", 31 => "light vessel, large buoy or rig",
    }
    transmission_mode {
        0 => "transmit A and B, receive A and B", 1 => "transmit A, receive A and B", 2 => "transmit B, receive A and B",
    }
    group_transmission_mode {
        0 => "transmit A and B, receive A and B", 1 => "transmit A, receive A and B", 2 => "transmit B, receive A and B", 3 => "reserved",
    }
    power { 0 => "high", 1 => "low" }
    bandwidth { 0 => "as the channel number says", 1 => "spare, formerly 12.5 kHz" }
    station_type {
        0 => "all mobiles", 1 => "class A mobiles", 2 => "class B mobiles", 3 => "airborne search and rescue",
        4 => "class B SOTDMA mobiles", 5 => "class B carrier-sense mobiles", 6 => "inland waterways",
        7 => "regional use", 8 => "regional use", 9 => "regional use", 10 => "base station coverage area",
    }
    reporting_interval {
        0 => "as the autonomous mode says", 1 => "10 min", 2 => "6 min", 3 => "3 min", 4 => "1 min", 5 => "30 s",
        6 => "15 s", 7 => "10 s", 8 => "5 s", 9 => "next shorter", 10 => "next longer", 11 => "2 s",
    }
    position_latency { 0 => "under 5 s", 1 => "over 5 s" }
    virtual_aid { 0 => "real aid to navigation", 1 => "virtual aid to navigation, simulated by a station" }
    target_status {
        0 => "not tracked, or no target to report", 1 => "being acquired, or sleeping", 2 => "lost",
        4 => "tracked or activated, no alarm", 6 => "tracked or activated, CPA/TCPA alarm",
        7 => "tracked or activated, CPA/TCPA alarm acknowledged", _ => "reserved",
    }
    test_target { 0 => "autonomous (normal)", 1 => "test target" }
    speed_mode { 0 => "true speed and course", 1 => "relative speed and course" }
    stabilisation { 0 => "over ground", 1 => "through water" }
}
