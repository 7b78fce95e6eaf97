//! What the hand unit is told: installation, gains, state, in EMACUA's forms (EMC-2, EMC-3, EMC-4).

use crate::autopilot::facts::Outlook;
use crate::autopilot::modes::{Former, Mode};
use crate::nmea::{Deadband, InstallationSide, Pemc03, Pemc05, Pemc07, SmallCraftMode};
use crate::settings::{DeadBand, Settings, TillerSide};
use crate::units::{Heading, RudderAngle, SignedAngle};
use alloc::string::String;

/// 03.
pub(in super::super) fn installation(settings: &Settings) -> String {
    Pemc03 {
        tiller: Some(settings.tiller_centre),
        max_rudder: Some(settings.rudder_max),
        cruise_speed: Some(settings.cruise_speed),
        side: Some(match settings.tiller_side {
            TillerSide::Starboard => InstallationSide::Starboard,
            TillerSide::Port => InstallationSide::Port,
        }),
        damping: Some(settings.rudder_damping),
        variation: settings.variation,
        alignment: Some(settings.heading_alignment),
        off_course: Some(settings.off_heading_limit),
    }
    .line("")
}

/// 05.
pub(in super::super) fn gains(settings: &Settings) -> String {
    Pemc05 {
        kp: Some(settings.pid_kp),
        ki: Some(settings.pid_ki),
        kd: Some(settings.pid_kd),
        sample_time: Some(settings.sample_time as u32),
        deadband: Some(match settings.dead_band {
            DeadBand::Minimum => Deadband::Least,
            DeadBand::Maximum => Deadband::Greatest,
            DeadBand::Automatic => Deadband::Automatic,
        }),
    }
    .line("")
}

/// 07. Heading and course are of magnetic north, and empty where no variation is known; without orders no course is steered.
pub(in super::super) fn information(mode: &Mode, outlook: &Outlook<'_>) -> String {
    let magnetic = |heading: Heading| {
        if outlook.sight.is_magnetic() {
            return Some(heading.deg());
        }
        let variation = outlook
            .sight
            .variation(outlook.seen, outlook.facts.settings)?;
        Some((heading + SignedAngle::from_deg(-variation)).deg())
    };
    let [rudder, _] = outlook.rudders();
    let trim = outlook.facts.steered.map(|steered| steered.terms.integral);
    Pemc07 {
        mode: Some(letter(mode)),
        rudder: rudder.map(RudderAngle::deg),
        heading: outlook.sight.heading().and_then(magnetic),
        course_to_steer: mode.state().hts(&outlook.facts).and_then(magnetic),
        deadband: outlook.dead_band,
        trim: Some(trim.unwrap_or_default()),
    }
    .line("")
}

/// EMC-3. What a unit that knows three modes shows: who follows a route, who steers a heading, who steers by hand.
fn letter(mode: &Mode) -> SmallCraftMode {
    match mode {
        Mode::Track(_) | Mode::AutonavTi(_) => SmallCraftMode::Track,
        Mode::Dodge(dodge) if dodge.former == Former::Track => SmallCraftMode::Track,
        Mode::Auto(_)
        | Mode::AutonavTn(_)
        | Mode::WindVane(_)
        | Mode::RiverPilot(_)
        | Mode::Dodge(_)
        | Mode::Autotuning(_) => SmallCraftMode::Auto,
        Mode::Standby(_)
        | Mode::NfuOverride(_)
        | Mode::RudderHold(_)
        | Mode::FfuOverride(_)
        | Mode::Installation(_) => SmallCraftMode::Standby,
    }
}
