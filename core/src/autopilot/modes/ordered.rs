//! What the operator asks of the modes besides AUTO and AutoNAV: selecting them, setting their values, releasing DODGE,
//! ending AUTOTUNING (AP-18, AP-19, AP-21).

use super::autotuning;
use super::event::Event;
use super::former::Former;
use super::mode::{Mode, row};
use super::need::Need;
use super::part::Modes;
use super::set_value::SetValue;
use super::track::Track;
use crate::alerts::Alert;
use crate::autopilot::facts::Outlook;
use crate::autopilot::notices::Notices;
use crate::command::{ModeRequest, Order, Refusal};
use crate::settings::Value;
use crate::units::RudderAngle;
use alloc::format;
use alloc::string::{String, ToString};

/// What the operator's selection of a mode that steers is the answer to.
pub(super) const ANSWERED: [Alert; 4] = [
    Alert::HeadingLost,
    Alert::TrackFail,
    Alert::Override,
    Alert::WindLost,
];
/// AUTOTUNING is selected for the second time within so long.
const AGAIN_MS: u64 = 20_000;

impl Modes {
    /// The operator selects a mode that is entered at once.
    pub(super) fn enter(
        &mut self,
        outlook: &Outlook<'_>,
        request: ModeRequest,
        notices: &mut Notices,
    ) -> Result<String, Refusal> {
        self.may_select(outlook, request)?;
        let event = match request {
            ModeRequest::RiverPilot => Event::RiverPilot,
            ModeRequest::FfuOverride => Event::FfuOverride(self.present_rudder(outlook)),
            ModeRequest::WindVane => self.to_the_wind(outlook)?,
            ModeRequest::Dodge => self.dodge(outlook)?,
            ModeRequest::Installation => Event::Installation,
            ModeRequest::Autotuning => match self.tuning_is_asked_again(outlook) {
                true => Event::Autotuning,
                false => return Ok(self.why.clone()),
            },
            _ => return Err(Refusal::because("not a mode that is entered at once")),
        };
        for over in ANSWERED {
            notices.rectify(over);
        }
        self.off_heading.restart();
        let bounds = (request == ModeRequest::Autotuning)
            .then(|| autotuning::bounds(outlook.facts.settings));
        let title = self.mode.next(&event, &outlook.facts).title();
        let why = bounds.unwrap_or_else(|| format!("operator selected {title}"));
        self.apply(&outlook.facts, &event, &why);
        Ok(title.to_string())
    }

    /// The order in force, or where none is given the rudder as the hand left it, within the gear's maximum.
    pub(super) fn present_rudder(&self, outlook: &Outlook<'_>) -> RudderAngle {
        let left = outlook.gear.left(outlook.rudders());
        let left = left.filter(|_| !self.gives_orders());
        let most = outlook.facts.settings.rudder_max;
        let present = left.unwrap_or(outlook.facts.order).deg();
        RudderAngle::from_deg(present.clamp(-most, most))
    }

    /// To the wind as she lies.
    fn to_the_wind(&self, outlook: &Outlook<'_>) -> Result<Event, Refusal> {
        let apparent = !outlook.facts.settings.wind_true;
        let direction = outlook.sight.wind(apparent);
        let direction = direction.ok_or_else(|| Refusal::because(Need::Wind.missing()))?;
        Ok(Event::WindVane {
            angle: direction - outlook.facts.heading,
            apparent,
            direction,
        })
    }

    /// Off the heading that is steered.
    fn dodge(&self, outlook: &Outlook<'_>) -> Result<Event, Refusal> {
        let (state, facts) = (self.mode.state(), &outlook.facts);
        let former = state.former();
        Ok(Event::Dodge {
            base: state.hts(facts).unwrap_or(facts.heading),
            former: former.ok_or_else(|| Refusal::because(Need::Dodgeable.missing()))?,
        })
    }

    /// The limits of the manoeuvre are shown at the first selection, and the second one within 20 s begins it (AP-19).
    fn tuning_is_asked_again(&mut self, outlook: &Outlook<'_>) -> bool {
        let Mode::Auto(auto) = &mut self.mode else {
            return false;
        };
        let now = outlook.facts.now;
        if auto.tuning_until.is_some_and(|until| now < until) {
            return true;
        }
        auto.tuning_until = Some(now + AGAIN_MS);
        let bounds = autotuning::bounds(outlook.facts.settings);
        self.why = format!("AUTOTUNING, select it again within 20 s: {bounds}");
        false
    }

    /// The operator sets a value of the mode that is on.
    pub(in super::super) fn set(
        &mut self,
        outlook: &Outlook<'_>,
        set: SetValue,
    ) -> Result<String, Refusal> {
        let mut state = self.mode;
        // First whether the mode takes it, then how far.
        state.state_mut().set(&outlook.facts, set)?;
        set.within(outlook.facts.settings)?;
        self.mode = state;
        self.off_heading.restart();
        self.why = format!("operator {}", set.done());
        Ok(set.done())
    }

    /// What AUTO is set to are settings: an order that sets one there, as the change of the setting.
    pub(in super::super) fn as_setting(&self, order: &Order) -> Option<Order> {
        let (key, value) = match (&self.mode, order) {
            (Mode::Auto(_), Order::SetRate(rate)) => ("set_rate", *rate),
            (Mode::Auto(_), Order::SetRadius(radius)) => ("set_radius", *radius),
            _ => return None,
        };
        Some(Order::Setting {
            key: key.into(),
            value: Value::Number(value),
        })
    }

    /// AP-19: any command ends AUTOTUNING, in AUTO on the heading before. The selection of a mode is done from there, and
    /// anything else is refused.
    pub(in super::super) fn interrupt(
        &mut self,
        outlook: &Outlook<'_>,
        order: &Order,
    ) -> Result<(), Refusal> {
        let Mode::Autotuning(tuning) = &self.mode else {
            return Ok(());
        };
        let spared = matches!(
            order,
            Order::Acknowledge(_) | Order::Silence(_) | Order::Mode(ModeRequest::Standby)
        );
        if spared {
            return Ok(());
        }
        let event = Event::AutoOn(tuning.before);
        let why = "AUTOTUNING ended by a command: AUTO on the heading before";
        self.apply(&outlook.facts, &event, why);
        match order {
            Order::Mode(_) => Ok(()),
            _ => Err(Refusal::because(format!("{why}, give it again"))),
        }
    }

    /// DODGE is released: the mode before goes on with its set value where its needs still hold, else AUTO on the present
    /// heading; absent where DODGE is not on.
    pub(super) fn release(&mut self, outlook: &Outlook<'_>) -> Option<String> {
        let Mode::Dodge(dodge) = &self.mode else {
            return None;
        };
        let facts = &outlook.facts;
        let returned = match dodge.former {
            Former::Auto(set) => Ok(Event::AutoOn(set)),
            Former::Autonav => self.resumed(outlook),
            Former::Track => self
                .proven_leg(outlook)
                .map(|leg| Event::EngageTrack(Track::on(leg, facts.heading)))
                .ok_or_else(|| Need::Plotted.missing().to_string()),
            Former::WindVane { angle, apparent } => outlook
                .sight
                .wind(apparent)
                .map(|direction| Event::WindVane {
                    angle,
                    apparent,
                    direction,
                })
                .ok_or_else(|| Need::Wind.missing().to_string()),
        };
        self.off_heading.restart();
        let (event, missing) = match returned {
            Ok(event) => (event, None),
            Err(missing) => (Event::AutoOn(facts.heading), Some(missing)),
        };
        let title = self.mode.next(&event, facts).title();
        let why = match missing {
            None => format!("DODGE released: {title}"),
            Some(missing) => format!("DODGE released: AUTO on the present heading, {missing}"),
        };
        self.apply(facts, &event, &why);
        Some(why)
    }

    /// AutoNAV again, where all that it needs is there and it is not in the middle of a turn; else what is missing.
    fn resumed(&self, outlook: &Outlook<'_>) -> Result<Event, String> {
        let waits = || self.waits_for(outlook);
        let proven = self.commands(outlook).is_proven(outlook.facts.now);
        let wanted = self.wanted(outlook).filter(|_| proven).ok_or_else(waits)?;
        let entry = row(wanted).map_or(&[][..], |row| row.entry);
        let asked = entry.iter().filter(|need| **need != Need::InAuto);
        for need in asked {
            if !self.has(outlook, *need, wanted) {
                return Err(need.missing().to_string());
            }
        }
        match self.missing(outlook, wanted) {
            Some(missing) => Err(missing.to_string()),
            None => self.engagement(outlook, wanted).ok_or_else(waits),
        }
    }
}
