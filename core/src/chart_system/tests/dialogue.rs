//! A whole dialogue of both sides, for the checker's own tests.

use super::*;

impl Bench {
    /// A ship so many metres to the right of the track.
    pub(crate) fn right(right: f64) -> Self {
        Self {
            right,
            ..Self::new()
        }
    }

    /// Seconds and line of a round: not active, "Ti" through two turns, end of route. The autopilot's part is
    /// played by an echo of the second before.
    pub(crate) fn dialogue(mut self, control: ChartRequest) -> Vec<(f64, String)> {
        let mut lines = vec![];
        let mut echo = Htd {
            override_status: Some(nmea::OverrideStatus::NotInUse),
            reference: Some(nmea::Reference::True),
            rudder_angle: Some(2.0),
            rudder_limit: Some(35.0),
            rudder_status: Some(nmea::LimitStatus::Within),
            off_heading_status: Some(nmea::LimitStatus::Within),
            heading: Some(245.0),
            steering_mode: Some(SteeringMode::StandAlone),
            turn_mode: Some(TurnMode::NotControlled),
            radius: Some(0.42),
            ..Htd::default()
        };
        self.second();
        for second in 0..1_800 {
            if second == 5 {
                self.request(control).unwrap();
            }
            let said = self.second();
            let at = self.now as f64 / 1000.0;
            for line in &said.lines {
                lines.push((at, line.clone()));
            }
            let rsa = nmea::Rsa {
                starboard: Some(2.0),
                starboard_status: Some(DataStatus::Valid),
                port_status: Some(DataStatus::Invalid),
                ..nmea::Rsa::default()
            };
            let ror = nmea::Ror {
                starboard: Some(2.0),
                starboard_status: Some(DataStatus::Valid),
                port_status: Some(DataStatus::Invalid),
                source: Some(nmea::CommandSource::Bridge),
                ..nmea::Ror::default()
            };
            for line in [echo.line("AG"), rsa.line("AG"), ror.line("AG")] {
                lines.push((at + 0.4, line));
            }
            let mode = said.htc.steering_mode;
            let active = mode != Some(SteeringMode::StandAlone);
            let turning = said.htc.radius.is_some();
            echo.steering_mode = mode;
            echo.radius = match mode {
                Some(SteeringMode::HeadingControl) => None,
                _ => said.htc.radius.or(echo.radius).or(Some(0.42)),
            };
            echo.turn_mode = match mode {
                Some(SteeringMode::TrackControl) if turning => Some(TurnMode::Radius),
                Some(SteeringMode::HeadingControl) => said.htc.turn_mode,
                _ => Some(TurnMode::NotControlled),
            };
            echo.rate_of_turn = turning.then_some(27.5).or(said.htc.rate_of_turn);
            echo.track = said.htc.track;
            echo.heading_to_steer = said
                .htc
                .heading_to_steer
                .or(said.htc.track)
                .filter(|_| active);
            self.steering = mode.unwrap_or(SteeringMode::StandAlone);
            if self.chart.situation() == 6 && second > 20 {
                break;
            }
        }
        for _ in 0..4 {
            let said = self.second();
            let at = self.now as f64 / 1000.0;
            lines.extend(said.lines.into_iter().map(|line| (at, line)));
            lines.push((at + 0.4, echo.line("AG")));
            lines.push((at + 0.4, nmea::Rsa::default().line("AG")));
            lines.push((at + 0.4, nmea::Ror::default().line("AG")));
        }
        lines.retain(|(_, line)| !line.is_empty());
        lines
    }
}
