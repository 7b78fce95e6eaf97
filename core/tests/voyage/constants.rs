//! Whose constants steer: one rule, at the start and after every change of a setting (AP-20).

use wheelover_core::autopilot::steering::SteeringSettings;
use wheelover_core::chart_system::ChartConfig;
use wheelover_core::command::{ModeRequest, Order, Origin};
use wheelover_core::settings::{Settings, Value};
use wheelover_core::time::Stamp;
use wheelover_core::voyage::{Event, Role, Voyage, VoyageConfig, VoyageOutput};
use wheelover_core::world::WorldConfig;

/// A turn in AUTO by a ship that is named and may have constants of her own; the rudder orders that it takes.
fn turn(own: Option<(f64, f64)>, change: Option<Order>) -> Vec<String> {
    let mut voyage = Voyage::configured(VoyageConfig {
        embedded: false,
        roles: Role::ALL.to_vec(),
        ports: Vec::new(),
        settings: Settings {
            gain_per_s: own.map(|(gain, _)| gain),
            time_constant_s: own.map(|(_, time)| time),
            rudder_slew: 5.0,
            ..Settings::default()
        },
        ship: Some(SteeringSettings::default()),
        chart: ChartConfig::default(),
        world: WorldConfig::default(),
    });
    let mut orders = vec![
        (5_000, Order::Mode(ModeRequest::Auto)),
        (20_000, Order::AdjustHeading(30.0)),
    ];
    if let Some(change) = change {
        orders.push((10_000, change));
    }
    let mut said = Vec::new();
    for step in 1..=900 {
        let now = Stamp(step * 100);
        let mut out = Vec::new();
        voyage.handle(now, Event::Tick, &mut out);
        for (id, order) in orders.iter().filter(|(at, _)| *at == now.0) {
            let event = Event::Order {
                id: *id,
                by: Origin::Officer,
                order: order.clone(),
            };
            voyage.handle(now, event, &mut out);
        }
        said.extend(out.into_iter().filter_map(|output| match output {
            VoyageOutput::Line(line) if line.text.contains("ROR,") => Some(line.text),
            VoyageOutput::Answer(answer) => {
                assert!(answer.ok, "{}", answer.text);
                None
            }
            _ => None,
        }));
    }
    said
}

// AP-20
#[test]
fn a_setting_that_is_nothing_to_the_ship_leaves_her_constants_alone() {
    let change = || Order::Setting {
        key: "off_heading_limit".into(),
        value: Value::Number(Settings::default().off_heading_limit),
    };
    for own in [None, Some((0.09, 60.0))] {
        assert!(turn(own, None) == turn(own, Some(change())), "{own:?}");
    }
    assert!(turn(None, None) != turn(Some((0.09, 60.0)), None));
}
