//! How a hull goes on: one Runge-Kutta step of whichever ship she is.

use super::hull::{Drive, Hull, ShipModel};
use super::{mariner, yacht};

impl Hull {
    /// One Runge-Kutta step of the fourth order.
    pub fn step(&mut self, drive: &Drive, dt: f64) {
        let k1 = self.derivative(drive);
        let k2 = self.moved(&k1, dt / 2.0).derivative(drive);
        let k3 = self.moved(&k2, dt / 2.0).derivative(drive);
        let k4 = self.moved(&k3, dt).derivative(drive);
        let mean = |a: f64, b: f64, c: f64, d: f64| (a + 2.0 * (b + c) + d) / 6.0;
        let sum = Self {
            surge: mean(k1.surge, k2.surge, k3.surge, k4.surge),
            sway: mean(k1.sway, k2.sway, k3.sway, k4.sway),
            rate: mean(k1.rate, k2.rate, k3.rate, k4.rate),
            heading: mean(k1.heading, k2.heading, k3.heading, k4.heading),
            north: mean(k1.north, k2.north, k3.north, k4.north),
            east: mean(k1.east, k2.east, k3.east, k4.east),
            rudder: mean(k1.rudder, k2.rudder, k3.rudder, k4.rudder),
            port_rudder: mean(
                k1.port_rudder,
                k2.port_rudder,
                k3.port_rudder,
                k4.port_rudder,
            ),
            heel: mean(k1.heel, k2.heel, k3.heel, k4.heel),
            heel_rate: mean(k1.heel_rate, k2.heel_rate, k3.heel_rate, k4.heel_rate),
            ship: self.ship,
        };
        *self = self.moved(&sum, dt);
    }

    fn moved(&self, by: &Self, dt: f64) -> Self {
        Self {
            surge: self.surge + dt * by.surge,
            sway: self.sway + dt * by.sway,
            rate: self.rate + dt * by.rate,
            heading: self.heading + dt * by.heading,
            north: self.north + dt * by.north,
            east: self.east + dt * by.east,
            rudder: self.rudder + dt * by.rudder,
            port_rudder: self.port_rudder + dt * by.port_rudder,
            heel: self.heel + dt * by.heel,
            heel_rate: self.heel_rate + dt * by.heel_rate,
            ship: self.ship,
        }
    }

    fn derivative(&self, drive: &Drive) -> Self {
        match self.ship {
            ShipModel::Mariner => mariner::derivative(self, drive),
            ShipModel::Yacht => yacht::derivative(self, drive),
        }
    }
}
