//! What the steering stand claims goes before what is selected here: at once, and back only by the operator (AP-22, HTC-4).

use super::event::Event;
use super::mode::Mode;
use super::part::Modes;
use crate::alerts::Alert;
use crate::autopilot::facts::Outlook;
use crate::autopilot::notices::Notices;
use crate::autopilot::stand::Claim;
use crate::command::{Order, Origin, Refusal};
use crate::nmea::Sentence;
use crate::station::Switch;
use crate::time::Stamp;
use alloc::format;

/// Said where the hardware override steers.
const NFU_LINE: &str = "the NFU line is in use";

impl Modes {
    /// An HTD was heard on a stand's port.
    pub(in super::super) fn on_stand(
        &mut self,
        outlook: &Outlook<'_>,
        sentence: &Sentence<'_>,
        notices: &mut Notices,
    ) {
        self.stand.on_htd(outlook.facts.now, sentence);
        self.obey_the_stand(outlook, notices);
    }

    /// A contact is so now; absent where it cannot be read.
    pub(in super::super) fn on_contact(
        &mut self,
        outlook: &Outlook<'_>,
        (switch, closed): (Switch, Option<bool>),
        notices: &mut Notices,
    ) {
        self.stand.on_contact(outlook.facts.now, switch, closed);
        self.obey_the_stand(outlook, notices);
    }

    /// Takes the ship where the stand claims her; nothing is ever taken back by itself.
    pub(super) fn obey_the_stand(&mut self, outlook: &Outlook<'_>, notices: &mut Notices) {
        let claim = self.stand.claim(outlook.facts.now);
        self.over_the_lever &= matches!(claim, Some(Claim::Rudder(_)));
        let (event, why) = match (claim, &self.mode) {
            (Some(Claim::NfuLine), Mode::NfuOverride(nfu)) if nfu.line => return,
            (Some(Claim::NfuLine), _) => (Event::NfuLine(true), NFU_LINE),
            (_, Mode::NfuOverride(nfu)) if nfu.line => {
                let why = "the NFU line is released: select a mode";
                (Event::NfuLine(false), why)
            }
            (Some(Claim::Rudder(order)), Mode::FfuOverride(ffu)) if ffu.rudder == order => return,
            (Some(Claim::Rudder(_)), Mode::NfuOverride(_)) => return,
            // HTC-4: the operator's STANDBY goes before the lever, until that is let go.
            (Some(Claim::Rudder(_)), _) if self.over_the_lever => return,
            (Some(claim @ Claim::Rudder(order)), _) => (Event::FfuOverride(order), said(claim)),
            (Some(claim), _) if self.gives_orders() => (Event::Standby, said(claim)),
            _ => return,
        };
        if self.gives_orders() && !matches!(event, Event::FfuOverride(_)) {
            notices.raise(Alert::Override, format!("{why}: no orders are given"));
        }
        self.apply(&outlook.facts, &event, why);
    }

    /// HTC-4: whether an order comes from somebody who goes before the one who has the ship.
    pub(in super::super) fn yields(
        &self,
        now: Stamp,
        by: Origin,
        order: &Order,
    ) -> Result<(), Refusal> {
        let Some(claim) = self.stand.claim(now) else {
            return Ok(());
        };
        let holder = match claim {
            Claim::NfuLine => Origin::NfuLine,
            Claim::Hand(_) | Claim::Rudder(_) => Origin::Stand,
        };
        if order.rank(by) <= holder.rank() {
            return Ok(());
        }
        Err(Refusal::because(format!(
            "{}: the {} goes before the {}",
            said(claim),
            holder.title(),
            by.title()
        )))
    }

    /// Once a step: what the stand claims, and what is wrong with it.
    pub(super) fn watch_the_stand(&mut self, outlook: &Outlook<'_>, notices: &mut Notices) {
        self.obey_the_stand(outlook, notices);
        let trouble = self.stand.trouble(outlook.facts.now, outlook.seen.picture);
        notices.tell(Alert::Stand, trouble);
    }
}

const fn said(claim: Claim) -> &'static str {
    match claim {
        Claim::NfuLine => NFU_LINE,
        Claim::Hand(why) => why,
        Claim::Rudder(_) => "the FFU lever steers",
    }
}
