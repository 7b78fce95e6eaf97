//! Engines, thrusters, doors, detectors and displays.

use crate::nmea::codes::*;
use crate::nmea::formats::*;
use crate::nmea::macros::{definition, kind, meanings, sentences, view, view_type};
use crate::nmea::table::{Format, Unit};
use serde::{Deserialize, Serialize};

codes! {
    /// State of a navigation light.
    LightStatus {
        NotInUse = b'0' "not in use", Off = b'1' "off", On = b'2' "on", Error = b'3' "error, reason unknown", ShortCircuit = b'4' "error, short circuit",
        OpenCircuit = b'5' "error, open circuit", LowLuminosity = b'6' "error, low luminosity", OtherError = b'9' "error, other",
    }
    /// Whether a steering system is in control.
    SteeringStatus { Passive = b'0' "not in control (passive)", Active = b'1' "in control (active)", Failed = b'2' "internal failure, cannot be in control" }
    /// Where steering is done.
    SteeringLocation {
        Bridge = b'B' "bridge, centre", PortWing = b'P' "port wing", StarboardWing = b'S' "starboard wing", Aft = b'A' "aft bridge",
        AftPortWing = b'X' "aft bridge, port wing", AftStarboardWing = b'Y' "aft bridge, starboard wing", Fly = b'F' "fly bridge",
        EngineControlRoom = b'C' "engine control room", EngineSide = b'E' "engine side, local", Emergency = b'M' "emergency steering stand",
        GearRoom = b'R' "steering gear room", Other = b'O' "other",
    }
    /// Mode of a steering system.
    SteeringSystemMode {
        Direct = b'D' "direct", Manual = b'M' "manual", Autopilot = b'A' "autopilot", DynamicPositioning = b'P' "dynamic positioning",
        Joystick = b'J' "joystick", Emergency = b'E' "emergency",
    }
    /// Source of a rotation.
    RotationSource { Shaft = b'S' "shaft", Engine = b'E' "engine" }
    /// Mode of a speed of rotation.
    RotationMode { Percent = b'P' "per cent", Revolutions = b'R' "revolutions a minute", Invalid = b'V' "not valid" }
    /// Mode of a pitch.
    PitchMode { Percent = b'P' "per cent", Degrees = b'D' "degrees", Invalid = b'V' "not valid" }
    /// Operating status of an engine telegraph.
    TelegraphMessage { Order = b'O' "order", Answer = b'A' "answer-back" }
    /// Preset of a display.
    DisplayPreset { Day = b'D' "day", Dusk = b'K' "dusk", Night = b'N' "night", Off = b'O' "backlighting off" }
    /// Kind of a status message.
    StatusMessage { Status = b'S' "status of a section", Event = b'E' "single event", Fault = b'F' "fault of the system" }
    /// State of a door.
    DoorState { Open = b'O' "open", Closed = b'C' "closed", Secured = b'S' "secured", Free = b'F' "free", Fault = b'X' "fault" }
    /// Setting of the watertight doors of a ship.
    DoorMode { Harbour = b'O' "harbour mode, may be open", Sea = b'C' "sea mode, ordered closed" }
    /// Kind of a message of a fire detection system.
    FireMessage { Status = b'S' "status of a section", Event = b'E' "status of a detector", Fault = b'F' "fault of the system", Disabled = b'D' "detector is disabled" }
    /// Condition of a fire detector.
    FireCondition { Activated = b'A' "activation", NotActivated = b'V' "no activation", Fault = b'X' "fault, state unknown" }
    /// Condition of a water level.
    WaterCondition {
        Normal = b'N' "normal", High = b'H' "high", ExtremeHigh = b'J' "extremely high", Low = b'L' "low", ExtremeLow = b'K' "extremely low",
        Fault = b'X' "fault, state unknown",
    }
    /// Override of a water level alarm.
    WaterOverride { Active = b'O' "override active, water is allowed there", NotActive = b'N' "override not active" }
}

words! {
    DoorSystem { "WT" "watertight door", "WS" "semi-watertight door", "FD" "fire door", "HD" "hull door", "OT" "other" }
    FireSystem {
        "FD" "fire detector of any kind", "FH" "heat detector", "FS" "smoke detector", "FM" "manual call point", "GD" "gas detector", "GO" "oxygen detector",
        "GS" "hydrogen sulphide detector", "GH" "hydrocarbon detector", "SF" "sprinkler flow switch", "SV" "sprinkler valve, released by hand",
        "CO" "carbon dioxide, released by hand", "OT" "other",
    }
    WaterSystem { "WL" "water level detection", "BI" "high level by the bilge system", "HD" "leakage at a hull door", "OT" "other" }
    TelegraphPosition {
        "00" "stop", "01" "dead slow ahead", "02" "slow ahead", "03" "half ahead", "04" "full ahead", "05" "navigation full ahead",
        "11" "dead slow astern", "12" "slow astern", "13" "half astern", "14" "full astern", "15" "crash astern",
    }
    SubTelegraphPosition { "20" "stand by engine", "30" "full away", "40" "finished with engine" }
}

const ROTATION: Format = Format::new(Unit::RevolutionsPerMinute, -99_999, 99_999, 1, 1);

sentences! {
    rpm as Rpm = "RPM" b'$' [5] "Revolutions", "IEC 61162-1 RPM" {
        source: code(RotationSource) "Shaft or engine.",
        number: integer(whole(0, 99, 1)) "Odd starboard, even port, 0 single or centre.",
        speed: number(ROTATION) "Speed, negative counter-clockwise.",
        pitch: number(PERCENT) "Propeller pitch, negative astern.",
        status: code(DataStatus) "Status.",
    }
    prc = "PRC" b'$' [8] "Propulsion remote control status", "IEC 61162-1 PRC" {
        lever: number(PERCENT) "Lever demand.",
        lever_status: code(DataStatus) "Its status.",
        rotation: number(BARE) "Rotation demand.",
        rotation_mode: code(RotationMode) "Its mode.",
        pitch: number(BARE) "Pitch demand.",
        pitch_mode: code(PitchMode) "Its mode.",
        location: code(CommandSource) "Where it is commanded from.",
        number: integer(whole(0, 99, 1)) "Engine or shaft.",
    }
    trc = "TRC" b'$' [8] "Thruster control data", "IEC 61162-1 TRC" {
        number: integer(whole(0, 99, 1)) "Thruster: odd bow, even stern.",
        rotation: number(BARE) "Rotation demand.",
        rotation_mode: code(RotationMode) "Its mode.",
        pitch: number(BARE) "Pitch demand, port negative.",
        pitch_mode: code(PitchMode) "Its mode.",
        azimuth: number(DIRECTION) "Azimuth demand.",
        location: code(CommandSource) "Where it is commanded from.",
        status: code(CommandStatus) "Sentence status.",
    }
    trd = "TRD" b'$' [6] "Thruster response data", "IEC 61162-1 TRD" {
        number: integer(whole(0, 99, 1)) "Thruster: odd bow, even stern.",
        rotation: number(BARE) "Rotation response.",
        rotation_mode: code(RotationMode) "Its mode.",
        pitch: number(BARE) "Pitch response, port negative.",
        pitch_mode: code(PitchMode) "Its mode.",
        azimuth: number(DIRECTION) "Azimuth response.",
    }
    etl = "ETL" b'$' [6] "Engine telegraph operation status", "IEC 61162-1 ETL" {
        time: time() "Event time.",
        message: code(TelegraphMessage) "Order or answer.",
        position: words(TelegraphPosition) "Position of the engine telegraph.",
        sub_position: words(SubTelegraphPosition) "Position of the sub telegraph.",
        location: code(CommandSource) "Where it is operated.",
        number: integer(whole(0, 99, 1)) "Engine or shaft.",
    }
    ddc = "DDC" b'$' [4] "Display dimming control", "IEC 61162-1 DDC" {
        preset: code(DisplayPreset) "Preset.",
        brightness: integer(whole(0, 99, 2)) "Brightness.",
        palette: code(DisplayPreset) "Palette.",
        status: code(CommandStatus) "Sentence status.",
    }
    dor = "DOR" b'$' [9] "Door status detection", "IEC 61162-1 DOR" {
        message: code(StatusMessage) "Kind of the message.",
        time: time() "Event time.",
        system: words(DoorSystem) "Type of the door system.",
        division_1: text(3) "First division.",
        division_2: text(3) "Second division.",
        number: integer(whole(0, 999, 3)) "Door, or count of open or faulty doors.",
        state: code(DoorState) "State of the door.",
        mode: code(DoorMode) "Setting of the watertight door mode.",
        text: text(40) "Description.",
    }
    fir = "FIR" b'$' [9] "Fire detection", "IEC 61162-1 FIR" {
        message: code(FireMessage) "Kind of the message.",
        time: time() "Event time.",
        system: words(FireSystem) "Type of the detection system.",
        division_1: text(3) "First division.",
        division_2: text(3) "Second division.",
        number: integer(whole(0, 999, 3)) "Detector, or count.",
        condition: code(FireCondition) "Condition.",
        acknowledged: code(AcknowledgeState) "Acknowledge state.",
        text: text(40) "Description.",
    }
    wat = "WAT" b'$' [9] "Water level detection", "IEC 61162-1 WAT" {
        message: code(StatusMessage) "Kind of the message.",
        time: time() "Event time.",
        system: words(WaterSystem) "Type of the detection system.",
        division_1: text(3) "First location.",
        division_2: text(3) "Second location.",
        number: integer(whole(0, 999, 3)) "Detection point, or count.",
        condition: code(WaterCondition) "Condition.",
        override_setting: code(WaterOverride) "Override setting.",
        text: text(40) "Description.",
    }
    hss = "HSS" b'$' [3] "Hull stress surveillance systems", "IEC 61162-1 HSS" {
        point: text(20) "Measurement point.",
        value: number(BARE) "Measured value.",
        status: code(DataStatus) "Status.",
    }
    epv = "EPV" b'$' [5] "Command or report equipment property value", "IEC 61162-1 EPV" {
        status: code(CommandStatus) "Sentence status.",
        equipment: text(2) "Type of the destination equipment.",
        identifier: text(15) "Its identifier.",
        property: integer(whole(0, 999, 1)) "Property.",
        value: text(60) "Its value.",
    }
    pos = "POS" b'$' [10] "Device position and ship dimensions", "IEC 61162-1 POS" {
        equipment: text(2) "Equipment.",
        number: integer(whole(0, 99, 2)) "Its number.",
        position_status: code(DataStatus) "Validity of the position.",
        ahead: number(METRES) "Position from the bow.",
        athwart: number(METRES) "Position from the centre line, starboard positive.",
        height: number(METRES) "Position above the keel.",
        ship_status: code(DataStatus) "Validity of the dimensions.",
        width: number(METRES) "Width of the ship.",
        length: number(METRES) "Length of the ship.",
        status: code(CommandStatus) "Sentence status.",
    }
    epm = "EPM" b'$' [8] "Command or report long equipment property value", "IEC 61162-1 EPM, as SwiftNMEA reads it" {
        total: integer(whole(1, 99, 1)) "Number of sentences of this value.",
        number: integer(whole(1, 99, 1)) "Number of this sentence.",
        sequence: integer(whole(0, 9, 1)) "Identifier that joins them.",
        status: code(CommandStatus) "Sentence status.",
        equipment: text(2) "Type of the destination equipment.",
        identifier: text(15) "Its identifier.",
        property: integer(whole(0, 999, 1)) "Property.",
        value: text(60) "Its value, or a part of it.",
    }
    nls = "NLS" b'$' [] "Navigation light status", "IEC 61162-1 NLS, as SwiftNMEA reads it" {
        total: integer(whole(1, 99, 1)) "Number of sentences of this message.",
        number: integer(whole(1, 99, 1)) "Number of this sentence.",
        sequence: integer(whole(0, 99, 1)) "Identifier that joins them.",
        count: integer(whole(0, 99, 1)) "Lights in this sentence.";
        each Counted(3) NlsLight lights {
            light: integer(whole(1, 999, 1)) "Which light.",
            status: code(LightStatus) "Its status.",
            hours: integer(whole(0, 99, 1)) "Working hours that remain, in hundreds; 99: more than 9800.",
        }
    }
    slm = "SLM" b'$' [5] "Steering location/mode", "IEC 61162-1 SLM, as SwiftNMEA reads it" {
        status: code(SteeringStatus) "Whether the system is in control.",
        location: code(SteeringLocation) "Where steering is done.",
        description: text(30) "Description of another location.",
        mode: code(SteeringSystemMode) "Mode.",
        sub_mode: text(30) "Description of the mode.",
    }
}
