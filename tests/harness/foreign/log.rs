//! What is known of a foreign ship, and what her autopilot answered over the line.

use std::collections::BTreeMap;
use wheelover_core::alerts::Alert;

/// What the ship is and what was heard of the autopilot.
#[derive(Debug, Default)]
pub struct Log {
    /// Seconds since the start.
    pub now: f64,
    /// Situation of the chart system, 1 to 5.
    pub situation: u8,
    /// Heading, degrees.
    pub heading: f64,
    /// Distance off leg or arc by the chart system's position, metres, positive to starboard.
    pub off_path: f64,
    /// Fields of each HTD with its time, the address first.
    pub htd: Vec<(f64, Vec<String>)>,
    /// Rudder orders.
    pub orders: Vec<(f64, f64)>,
    /// Condition of each alert as last reported by ALR.
    pub alerts: BTreeMap<u16, bool>,
}

impl Log {
    /// A field of the last HTD; empty before the first.
    #[must_use]
    pub fn htd(&self, field: usize) -> &str {
        let last = self.htd.last().and_then(|(_, fields)| fields.get(field));
        last.map_or("", String::as_str)
    }

    /// Whether the alert is raised as the line says.
    #[must_use]
    pub fn raised(&self, alert: Alert) -> bool {
        self.alerts.get(&alert.number()).copied().unwrap_or(false)
    }

    /// Largest order since that time, without sign.
    #[must_use]
    pub fn largest_order(&self, since: f64) -> f64 {
        let late = self.orders.iter().filter(|(at, _)| *at >= since);
        late.fold(0.0, |most, (_, order)| most.max(order.abs()))
    }

    pub(super) fn hear(&mut self, line: &str) {
        let body = line.split('*').next().unwrap_or_default();
        let fields: Vec<String> = body.split(',').map(str::to_string).collect();
        let now = self.now;
        match fields[0].as_str() {
            "$AGHTD" => self.htd.push((now, fields)),
            "$AGROR" if fields.get(2).is_some_and(|status| status == "A") => {
                self.orders
                    .extend(fields[1].parse().map(|order| (now, order)));
            }
            "$AGALR" if fields.len() > 3 => {
                if let Ok(number) = fields[2].parse() {
                    self.alerts.insert(number, fields[3] == "A");
                }
            }
            _ => {}
        }
    }
}
