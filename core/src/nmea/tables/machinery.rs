//! Engines, thrusters, doors, detectors and displays.

use crate::nmea::codes::*;
use crate::nmea::formats::*;
use crate::nmea::macros::{definition, kind, meanings, sentences, view, view_type};
use crate::nmea::table::{Format, Unit};
use serde::{Deserialize, Serialize};

codes! {
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
    /// Condition of a detector.
    DetectorCondition { Activated = b'A' "activation", Fault = b'F' "fault", Disabled = b'D' "disabled", Normal = b'N' "normal", High = b'H' "high level", Low = b'J' "low level", Extreme = b'L' "extreme level", Unknown = b'V' "not valid", Other = b'X' "other" }
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
        position: integer(whole(0, 99, 2)) "Position of the engine telegraph.",
        sub_position: integer(whole(0, 99, 2)) "Position of the sub telegraph.",
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
        system: text(2) "Type of the door system.",
        division_1: text(3) "First division.",
        division_2: text(3) "Second division.",
        number: integer(whole(0, 999, 3)) "Door, or count of open or faulty doors.",
        state: code(DoorState) "State of the door.",
        mode: text(1) "Setting of the watertight door mode.",
        text: text(40) "Description.",
    }
    fir = "FIR" b'$' [9] "Fire detection", "IEC 61162-1 FIR" {
        message: code(StatusMessage) "Kind of the message.",
        time: time() "Event time.",
        system: text(2) "Type of the detection system.",
        division_1: text(3) "First division.",
        division_2: text(3) "Second division.",
        number: integer(whole(0, 999, 3)) "Detector, or count.",
        condition: code(DetectorCondition) "Condition.",
        acknowledged: code(AcknowledgeState) "Acknowledge state.",
        text: text(40) "Description.",
    }
    wat = "WAT" b'$' [9] "Water level detection", "IEC 61162-1 WAT" {
        message: code(StatusMessage) "Kind of the message.",
        time: time() "Event time.",
        system: text(2) "Type of the detection system.",
        division_1: text(3) "First location.",
        division_2: text(3) "Second location.",
        number: integer(whole(0, 999, 3)) "Detection point, or count.",
        condition: code(DetectorCondition) "Condition.",
        override_setting: text(1) "Override setting.",
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
}
