//! HSC as a source of the heading to steer in Tn: set by the engineer, behind HTC, and supervised as HTC is (AP-13, HTC-4, FB13).

use crate::rig::Rig;
use wheelover_core::alerts::Alert;
use wheelover_core::nmea::SteeringMode;
use wheelover_core::settings::Value;
use wheelover_core::station::Profile;
use wheelover_core::view::{ChartRequest, ModeName, ModeRequest, Order};

/// A ship in AUTO that may be commanded by HSC, where no HTC is heard.
fn ship(set: bool) -> Rig {
    let mut rig = Rig::heading_east(&[("plotter", Profile::Plotter)], 0.0);
    let (key, value) = ("hsc".into(), Value::Switch(set));
    rig.command(Order::Setting { key, value }).unwrap();
    rig.silence(Profile::Ecdis, "HTC,");
    rig.run(7.0);
    rig.command(Order::Mode(ModeRequest::Auto)).unwrap();
    rig
}

impl Rig {
    /// Once a second this HSC.
    fn hsc(&mut self, seconds: u32, from: Profile, body: &str) {
        for _ in 0..seconds {
            self.say(from, body);
            self.run(1.0);
        }
    }
}

#[test]
fn a_heading_is_steered_by_hsc_and_its_loss_is_track_fail() {
    for from in [Profile::Ecdis, Profile::Plotter] {
        let mut rig = ship(true);
        rig.command(Order::Mode(ModeRequest::Autonav)).unwrap();
        rig.hsc(4, from, "EIHSC,100.0,T,,M,C");
        assert_eq!(rig.mode(), ModeName::AutonavTn, "{}", rig.autopilot().why());
        rig.hsc(60, from, "EIHSC,100.0,T,,M,C");
        let htd = rig.last_htd();
        assert_eq!(htd.steering_mode, Some(SteeringMode::HeadingControl));
        assert_eq!(
            (htd.heading_to_steer, htd.track),
            (Some(100.0), Some(100.0))
        );
        assert!(
            (rig.heading().deg() - 100.0).abs() < 1.0,
            "{}",
            rig.heading().deg()
        );
        rig.until("caution", 4.0, |rig| rig.raised(Alert::TrackDataLate));
        rig.until("TRACK FAIL", 4.0, |rig| rig.raised(Alert::TrackFail));
        let text = rig.text(Alert::TrackFail);
        assert!(text.starts_with("HSC missing"), "{text}");
        assert_eq!(rig.mode(), ModeName::Auto);
        rig.check_orders();
    }
}

#[test]
fn without_the_setting_hsc_commands_nothing() {
    let mut rig = ship(false);
    rig.command(Order::Mode(ModeRequest::Autonav)).unwrap();
    rig.hsc(25, Profile::Ecdis, "EIHSC,100.0,T,,M,C");
    assert_eq!(rig.mode(), ModeName::Auto);
    assert!(
        rig.autopilot().why().contains("not confirmed"),
        "{}",
        rig.autopilot().why()
    );
}

// HTC-4: an HTC goes before, whichever came first.
#[test]
fn htc_goes_before_hsc() {
    let mut rig = ship(true);
    rig.command(Order::Mode(ModeRequest::Autonav)).unwrap();
    rig.hsc(5, Profile::Plotter, "EIHSC,95.0,T,,M,C");
    assert_eq!(rig.mode(), ModeName::AutonavTn);
    // The chart system's HTC is heard again: it does not control.
    rig.silence(Profile::Magn, "");
    rig.hsc(3, Profile::Plotter, "EIHSC,95.0,T,,M,C");
    assert_eq!(rig.mode(), ModeName::Auto);
    let text = rig.text(Alert::TrackFail);
    assert!(text.starts_with("stopped by chart system"), "{text}");
    rig.command(Order::Mode(ModeRequest::Autonav)).unwrap();
    rig.hsc(22, Profile::Plotter, "EIHSC,95.0,T,,M,C");
    assert_eq!(rig.mode(), ModeName::Auto, "an HTC holds");
    // In Tn by HTC a lost HTC is TRACK FAIL, though an HSC is heard.
    rig.ask(ChartRequest::Heading).unwrap();
    rig.command(Order::Mode(ModeRequest::Autonav)).unwrap();
    rig.hsc(6, Profile::Plotter, "EIHSC,95.0,T,,M,C");
    assert_eq!(rig.mode(), ModeName::AutonavTn, "{}", rig.autopilot().why());
    rig.silence(Profile::Ecdis, "HTC,");
    rig.hsc(8, Profile::Plotter, "EIHSC,95.0,T,,M,C");
    assert_eq!(rig.mode(), ModeName::Auto);
    let text = rig.text(Alert::TrackFail);
    assert!(text.starts_with("HTC missing"), "{text}");
    rig.check_orders();
}

// FB13
#[test]
fn of_two_hsc_the_first_is_obeyed_and_the_conflict_said() {
    let mut rig = ship(true);
    rig.command(Order::Mode(ModeRequest::Autonav)).unwrap();
    for _ in 0..20 {
        rig.say(Profile::Plotter, "IIHSC,200.0,T,,M,C");
        rig.hsc(1, Profile::Ecdis, "EIHSC,100.0,T,,M,C");
    }
    assert_eq!(rig.mode(), ModeName::AutonavTn);
    let text = rig.text(Alert::HscConflict);
    assert_eq!(
        text,
        "HSC SOURCE CONFLICT: plotter/II/HSC is obeyed, ecdis/EI/HSC commands too and is not"
    );
    assert_eq!(rig.last_htd().heading_to_steer, Some(200.0));
}
