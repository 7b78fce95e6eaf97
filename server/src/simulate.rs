//! `wheelover simulate`: scenarios in closed loop and open-loop manoeuvres, as fast as they go (CLI-4).

use std::fs::File;
use std::io::{BufWriter, IsTerminal, Write};
use std::path::{Path, PathBuf};
use wheelover_core::autopilot::steering::SteeringSettings;
use wheelover_core::scenario::{
    Bench, BenchRun, Conditions, Disturbance, Document, Manoeuvre, Plan, Report, Sample,
};

/// Steps between two rows of the table: 2 Hz.
const STEPS_PER_ROW: u64 = 5;
/// Steps between two looks at the progress.
const STEPS_PER_PROGRESS: u64 = 5000;

/// Runs the scenario file, or one scenario of it; the exit code is 1 where a ship lost her track.
///
/// # Errors
/// One line that says what is wrong and where.
pub(crate) fn simulate(
    scenario: &Path,
    only: Option<&str>,
    csv: Option<&Path>,
    json: bool,
    quiet: bool,
) -> Result<i32, String> {
    let text = read(scenario)?;
    let document = Document::parse(&text).map_err(|e| format!("{}: {e}", scenario.display()))?;
    match document {
        Document::Bench(bench) => benches(scenario, &bench, only, csv, json, quiet),
        Document::Manoeuvre(plan) => {
            let name = stem(scenario);
            if let Some(other) = only.filter(|o| *o != name) {
                return Err(format!(
                    "{}: no scenario `{other}`: {name}",
                    scenario.display()
                ));
            }
            manoeuvre(&name, &plan, csv, json)
        }
    }
}

fn benches(
    file: &Path,
    bench: &Bench,
    only: Option<&str>,
    csv: Option<&Path>,
    json: bool,
    quiet: bool,
) -> Result<i32, String> {
    let wanted: Vec<(&str, &Conditions)> = bench
        .scenarios()
        .filter(|(name, _)| only.is_none_or(|o| o == *name))
        .collect();
    if wanted.is_empty() {
        let names: Vec<&str> = bench.scenarios().map(|(name, _)| name).collect();
        let only = only.unwrap_or_default();
        return Err(format!(
            "{}: no scenario `{only}`: {}",
            file.display(),
            names.join(", ")
        ));
    }
    let noisy = wanted
        .iter()
        .any(|(_, c)| c.noise != 0.0 || c.wave_deg != 0.0);
    let disturbance = if noisy {
        noise(file, bench)?
    } else {
        Disturbance::default()
    };
    let mut reports = Vec::new();
    let mut code = 0;
    for (name, conditions) in &wanted {
        let mut table = match csv {
            Some(path) if wanted.len() > 1 => Some(Table::create(&named(path, name))?),
            Some(path) => Some(Table::create(path)?),
            None => None,
        };
        if let Some(table) = &mut table {
            table.line(
                "t_s,north_m,east_m,heading_deg,rudder_deg,rudder_order_deg,speed_mps,xtd_m",
            )?;
        }
        let settings = SteeringSettings::default();
        let mut run = BenchRun::new(bench, **conditions, &disturbance, settings);
        let mut progress = Progress::new(name, quiet);
        let mut step = 0;
        while !run.done() {
            let sample = run.step();
            if let Some(table) = &mut table
                && step % STEPS_PER_ROW == 0
            {
                table.line(&row(&sample))?;
            }
            if step % STEPS_PER_PROGRESS == 0 {
                progress.show(run.progress());
            }
            step += 1;
        }
        progress.clear();
        if let Some(table) = table {
            table.close()?;
        }
        if run.lost() {
            code = 1;
            if !quiet {
                eprintln!("{name}: the ship lost her track");
            }
        }
        reports.push(((*name).to_owned(), run.report()));
    }
    print(&text(&reports, Some("wheelover"), json));
    Ok(code)
}

fn noise(file: &Path, bench: &Bench) -> Result<Disturbance, String> {
    let [fast, slow] = bench.disturbance_files() else {
        return Err(format!(
            "{}: disturbance_files must name two files",
            file.display()
        ));
    };
    let folder = file.parent().unwrap_or(Path::new(""));
    let (fast, slow) = (folder.join(fast), folder.join(slow));
    Disturbance::parse(&read(&fast)?, &read(&slow)?)
        .map_err(|e| format!("{} or {}: {e}", fast.display(), slow.display()))
}

fn row(s: &Sample) -> String {
    let heading = wheelover_core::units::wrap_360(s.heading);
    format!(
        "{:.1},{:.3},{:.3},{:.3},{:.3},{:.3},{:.4},{:.3}",
        s.time, s.north, s.east, heading, s.rudder, s.order, s.speed, s.cross_track
    )
}

fn manoeuvre(name: &str, plan: &Plan, csv: Option<&Path>, json: bool) -> Result<i32, String> {
    if let Some(path) = csv {
        let mut table = Table::create(path)?;
        if matches!(plan.manoeuvre, Manoeuvre::Spiral) {
            table.line(
                "rudder_deg,steady_r_degps,steady_speed_mps,steady_drift_deg,steady_radius_m",
            )?;
            for r in plan.spiral() {
                table.line(&format!(
                    "{:.2},{:.5},{:.4},{:.3},{:.2}",
                    r.rudder, r.rate, r.speed, r.drift, r.radius
                ))?;
            }
        } else {
            table.line(
                "t_s,u_mps,v_mps,r_degps,north_m,east_m,psi_deg,rudder_deg,rudder_order_deg,speed_mps",
            )?;
            let mut trouble = None;
            plan.sail(&mut |r| {
                let h = &r.hull;
                let line = format!(
                    "{:.5},{:.5},{:.5},{:.5},{:.5},{:.5},{:.5},{:.5},{:.5},{:.5}",
                    r.time,
                    h.surge,
                    h.sway,
                    h.rate.to_degrees(),
                    h.north,
                    h.east,
                    h.heading.to_degrees(),
                    h.rudder.to_degrees(),
                    r.order,
                    h.speed()
                );
                if trouble.is_none() {
                    trouble = table.line(&line).err();
                }
            });
            if let Some(trouble) = trouble {
                return Err(trouble);
            }
        }
        table.close()?;
    }
    print(&text(&[(name.to_owned(), plan.report())], None, json));
    Ok(0)
}

/// One JSON object a scenario, or one table with a scenario in each column.
fn text(reports: &[(String, Report)], controller: Option<&str>, json: bool) -> String {
    let mut text = String::new();
    if json {
        for (name, report) in reports {
            text.push_str(&format!("{{\"scenario\":{}", quoted(name)));
            if let Some(controller) = controller {
                text.push_str(&format!(",\"controller\":{}", quoted(controller)));
            }
            for (name, value) in &report.0 {
                let value = value.map_or("null".to_owned(), |v| v.to_string());
                text.push_str(&format!(",{}:{value}", quoted(name)));
            }
            text.push_str("}\n");
        }
    } else if let Some((_, first)) = reports.first() {
        text.push_str(&format!("{:34}", ""));
        for (name, _) in reports {
            text.push_str(&format!(" {name:>18}"));
        }
        for (i, (figure, _)) in first.0.iter().enumerate() {
            text.push_str(&format!("\n{figure:34}"));
            for (_, report) in reports {
                let value = report.0.get(i).and_then(|(_, v)| *v);
                let value = value.map_or("-".to_owned(), |v| format!("{v:.3}"));
                text.push_str(&format!(" {value:>18}"));
            }
        }
        text.push('\n');
    }
    text
}

fn print(text: &str) {
    // A reader that went away is no error.
    let _ = std::io::stdout().write_all(text.as_bytes());
}

fn quoted(text: &str) -> String {
    serde_json::Value::from(text).to_string()
}

fn read(path: &Path) -> Result<String, String> {
    std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))
}

fn stem(path: &Path) -> String {
    path.file_stem()
        .map_or_else(String::new, |s| s.to_string_lossy().into_owned())
}

/// `out.csv` becomes `out-NAME.csv`.
fn named(path: &Path, name: &str) -> PathBuf {
    let suffix = path
        .extension()
        .map(|e| format!(".{}", e.to_string_lossy()));
    path.with_file_name(format!(
        "{}-{name}{}",
        stem(path),
        suffix.unwrap_or_default()
    ))
}

/// A table on its way to a file.
struct Table {
    path: PathBuf,
    out: BufWriter<File>,
}

impl Table {
    fn create(path: &Path) -> Result<Self, String> {
        let file = File::create(path).map_err(|e| format!("{}: {e}", path.display()))?;
        Ok(Self {
            path: path.to_owned(),
            out: BufWriter::new(file),
        })
    }

    fn line(&mut self, text: &str) -> Result<(), String> {
        writeln!(self.out, "{text}").map_err(|e| format!("{}: {e}", self.path.display()))
    }

    fn close(mut self) -> Result<(), String> {
        self.out
            .flush()
            .map_err(|e| format!("{}: {e}", self.path.display()))
    }
}

/// A line on standard error that is overwritten, where that is a terminal (CLI-5).
struct Progress<'a> {
    name: &'a str,
    shown: bool,
}

impl<'a> Progress<'a> {
    fn new(name: &'a str, quiet: bool) -> Self {
        Self {
            name,
            shown: !quiet && std::io::stderr().is_terminal(),
        }
    }

    fn show(&mut self, part: f64) {
        if self.shown {
            eprint!("\r{}: {:3.0} %", self.name, 100.0 * part);
        }
    }

    fn clear(&mut self) {
        if self.shown {
            eprint!("\r{:60}\r", "");
        }
    }
}

#[cfg(test)]
mod tests;
