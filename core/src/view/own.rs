//! The stations' own facts, for the page.

use super::message::{AlertView, ChartOwn, Own, Pending, RefusedView};
use crate::alerts::{Category, HeardAlert, Standing};
use crate::autopilot::{Autopilot, Mode, ModeName};
use crate::chart_system::ChartSystem;
use crate::command::ModeRequest;
use crate::settings::{Rudders, SpeedSource, SteeringBy};
use crate::station::Profile;
use crate::time::Stamp;
use crate::units::{Course, Distance, Heading, RudderAngle};
use alloc::string::{String, ToString};
use alloc::vec::Vec;

/// What only the autopilot knows.
#[must_use]
pub fn own(autopilot: &Autopilot, now: Stamp) -> Own {
    let steered = autopilot.steered();
    let settings = autopilot.settings();
    let [starboard, port] = autopilot.rudder_orders();
    Own {
        mode: autopilot.mode().name(),
        why: autopilot.why().to_string(),
        pending: autopilot.pending().map(|until| Pending {
            request: autopilot.pending_mode(now),
            until: until.0,
            waits_for: autopilot.waits_for(now),
        }),
        closed: closed(autopilot, now),
        set_heading: match autopilot.mode() {
            Mode::Auto(auto) => Some(auto.set.deg()),
            _ => None,
        },
        set_value: autopilot.mode().set_value(),
        hts: autopilot.hts().map(Heading::deg),
        set_rate: settings.set_rate,
        set_radius: settings.set_radius,
        by_radius: settings.steering_by == SteeringBy::Radius,
        rudder_limit: autopilot.rudder_limit(),
        rudder_order: starboard.map(RudderAngle::deg),
        pair: settings.rudders == Rudders::Independent,
        port_order: port.map(RudderAngle::deg),
        cross_track: autopilot.cross_track().map(Distance::m),
        cross_track_limit: autopilot.off_track_limit(now),
        sources: sources(autopilot, now),
        heading: autopilot.believed_heading().map(Heading::deg),
        magnetic: autopilot.heading_is_magnetic(),
        judged: autopilot.judged_at().0,
        position: autopilot.believed_position(now),
        manual_speed: (settings.speed_source == SpeedSource::Manual)
            .then_some(settings.manual_speed),
        calculated: autopilot
            .calculated_over_ground(now)
            .map(|(course, speed)| (course.map(Course::deg), speed.knots())),
        refused: autopilot
            .refused()
            .into_iter()
            .map(|refused| RefusedView {
                quantity: refused.quantity,
                source: autopilot.source_name(refused.source),
                why: refused.why.to_string(),
            })
            .collect(),
        terms: steered.map(|steered| steered.terms),
        limited: steered.is_some_and(|steered| steered.limited),
        output: autopilot
            .picture()
            .ports
            .iter()
            .any(|port| port.profile == Profile::Gear && port.output),
    }
}

/// AP-6: which of the modes that have a button would be refused, by the table of needs.
fn closed(autopilot: &Autopilot, now: Stamp) -> Vec<(ModeRequest, String)> {
    let mode = autopilot.mode();
    let on = |name| mode.name() == name;
    let buttons = [
        (ModeRequest::Auto, on(ModeName::Auto)),
        (ModeRequest::Autonav, mode.is_autonav()),
        (ModeRequest::Track, on(ModeName::Track)),
        (ModeRequest::WindVane, on(ModeName::WindVane)),
        (ModeRequest::RiverPilot, on(ModeName::RiverPilot)),
        (ModeRequest::Dodge, on(ModeName::Dodge)),
        (ModeRequest::FfuOverride, on(ModeName::FfuOverride)),
        (ModeRequest::Installation, on(ModeName::Installation)),
        (ModeRequest::Autotuning, on(ModeName::Autotuning)),
    ];
    let off = buttons.into_iter().filter(|(_, on)| !on);
    off.filter_map(|(request, _)| {
        let refusal = autopilot.may_select(now, request).err()?;
        Some((request, refusal.text))
    })
    .collect()
}

fn sources(autopilot: &Autopilot, now: Stamp) -> Vec<(String, String)> {
    let picture = autopilot.picture();
    let ground = autopilot.over_ground_from(now);
    let ground = ground.or_else(|| Some(picture.ground(now)?.source.clone()));
    let manual = autopilot.settings().speed_source == SpeedSource::Manual;
    let list = [
        ("heading", autopilot.compass_in_use()),
        ("rate", picture.rate(now).map(|heard| &heard.source)),
        ("position", autopilot.receiver_in_use()),
        ("ground", ground.as_ref()),
        ("water", picture.water_speed(now).map(|heard| &heard.source)),
    ];
    let named = list
        .into_iter()
        .filter_map(|(name, source)| Some((name.to_string(), picture.source_name(source?))));
    // AP-7: what the gains are made of, where the operator entered it.
    let by_hand = manual.then(|| ("speed".to_string(), "manual".to_string()));
    named.chain(by_hand).collect()
}

/// What only our chart-system side knows.
#[must_use]
pub(super) fn chart_own(chart: &ChartSystem) -> ChartOwn {
    ChartOwn {
        situation: chart.situation(),
        control: chart.control_name().into(),
        leg: chart.leg().unwrap_or(0),
        wheel_over_s: chart.wheel_over_s(chart.now()),
        why: chart.reason(),
        adrift: chart.adrift().map(|(place, off)| (place, off.m())),
    }
}

/// An alert of a foreign autopilot as it is shown; none where its identifier is larger than any that the page shows.
#[must_use]
pub(super) fn heard_alert(heard: &HeardAlert) -> Option<AlertView> {
    Some(AlertView {
        number: u16::try_from(heard.number).ok()?,
        priority: heard.priority,
        state: heard.state,
        category: Category::B,
        title: heard.title.clone(),
        text: heard.text.clone(),
        at: heard.at.0,
    })
}

/// An alert as it is shown; the autopilot, where it runs here, says its own.
#[must_use]
pub(super) fn alert(standing: &Standing, autopilot: Option<&Autopilot>) -> AlertView {
    let definition = standing.alert.definition();
    AlertView {
        number: standing.alert.number(),
        priority: definition.priority,
        state: standing.state,
        category: definition.category,
        title: definition.title.to_string(),
        text: autopilot.map_or_else(
            || standing.text().to_string(),
            |autopilot| autopilot.text_of(standing),
        ),
        at: standing.at.0,
    }
}
